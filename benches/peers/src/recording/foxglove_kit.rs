use std::error::Error;
use std::path::{Path, PathBuf};

use foxglove::messages::{FrameTransform, Quaternion, Timestamp, Vector3};
use foxglove::{Channel, Context, McapCompression, McapWriteOptions};
use polhode::scenario::Plan;
use polhode::telemetry::{BodySamples, Channel as Column};

/// What is no vector, in one message.
#[derive(foxglove::Encode)]
struct Scalars {
    rotational_energy: f64,
    translational_energy: f64,
    potential_energy: f64,
    total_energy: f64,
    energy_drift: f64,
    momentum_drift: f64,
}

/// Five messages a sample: a transform, three vectors, the scalars. Chunks as polhode has them: 1 MiB,
/// zstd 1, no threads; no arrows.
pub fn record(plan: &Plan, folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let path = folder.join("run.mcap");
    let options = McapWriteOptions::new()
        .compression(Some(McapCompression::Zstd))
        .compression_level(1)
        .compression_threads(0)
        .chunk_size(Some(1 << 20));
    let context = Context::new();
    let writer = context.mcap_writer_with_options(options).create_new_buffered_file(&path)?;
    let transforms: Channel<FrameTransform> = context.channel_builder("/tf").build();
    let vectors = [Column::AngularVelocity, Column::AngularMomentumWorld, Column::MomentBody]
        .map(|column| (column, context.channel_builder(format!("/body/{}", column.row().name)).build::<Vector3>()));
    let scalars: Channel<Scalars> = context.channel_builder("/body/scalars").build();
    let mut run = plan.start()?;
    while let Some(samples) = run.next_batch()? {
        let body = &samples.bodies[0];
        for (index, stamp_ns) in samples.stamps_ns.iter().enumerate() {
            let stamp_ns = stamp_ns.unsigned_abs();
            transforms.log_with_time(&transform(body, index, stamp_ns), stamp_ns);
            for (column, channel) in &vectors {
                let [x, y, z] = numbers(body, *column, index);
                channel.log_with_time(&Vector3 { x, y, z }, stamp_ns);
            }
            scalars.log_with_time(&scalars_at(body, index), stamp_ns);
        }
    }
    writer.close()?.into_inner()?.sync_all()?;
    Ok(vec![path])
}

fn transform(body: &BodySamples, index: usize, stamp_ns: u64) -> FrameTransform {
    let [x, y, z] = numbers(body, Column::Position, index);
    let [w, i, j, k] = numbers(body, Column::Attitude, index);
    FrameTransform {
        timestamp: Some(Timestamp::new((stamp_ns / 1_000_000_000) as u32, (stamp_ns % 1_000_000_000) as u32)),
        parent_frame_id: "world".into(),
        child_frame_id: "body".into(),
        translation: Some(Vector3 { x, y, z }),
        rotation: Some(Quaternion { x: i, y: j, z: k, w }),
    }
}

fn scalars_at(body: &BodySamples, index: usize) -> Scalars {
    let number = |column| {
        let [number] = numbers(body, column, index);
        number
    };
    Scalars {
        rotational_energy: number(Column::RotationalEnergy),
        translational_energy: number(Column::TranslationalEnergy),
        potential_energy: number(Column::PotentialEnergy),
        total_energy: number(Column::TotalEnergy),
        energy_drift: number(Column::EnergyDrift),
        momentum_drift: number(Column::MomentumDrift),
    }
}

/// The scene records every channel that is asked for here.
fn numbers<const N: usize>(body: &BodySamples, column: Column, index: usize) -> [f64; N] {
    let columns = body.channel(column).expect("recorded");
    std::array::from_fn(|component| columns[component][index])
}
