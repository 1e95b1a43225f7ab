//! Plans and samples that recording tests share: made by hand, so that every format can be tested without scene files.

use nalgebra::{UnitQuaternion, Vector3};
use polhode::body::{AngularVelocity, Attitude, MassProperties, PrincipalMoments, State, Surface};
use polhode::dynamics::Problem;
use polhode::recording::Recording;
use polhode::recording::picture::{Arrow, BodyPicture, Picture, Poinsot, Quantity};
use polhode::scenario::{Event, EventKind, Grid, Path, Plan, PlannedBody, Provenance, nanoseconds};
use polhode::telemetry::{BodySamples, Channel, Samples};

/// Two torque-free bodies: `upper` with every channel, `lower` with ω in body axes and its energy only.
pub fn plan(count: u64) -> Plan {
    let lower = [Channel::AngularVelocity, Channel::RotationalEnergy];
    Plan {
        name: "pair".into(),
        title: "Two bodies".into(),
        summary: "Nothing to see".into(),
        text: "title = \"Two bodies\"\n".into(),
        identity: "two bodies".into(),
        provenance: Provenance::default(),
        tolerance_rad: None,
        grid: Grid::Uniform { every_s: 1e-3, count },
        bodies: vec![body("upper", &Channel::ALL), body("lower", &lower)],
        checks: Vec::new(),
        outcomes: Vec::new(),
        events: vec![
            Event { time_s: 0.0, body: 0, kind: EventKind::Load, text: "thruster on".into() },
            Event { time_s: 2.5e-3, body: 1, kind: EventKind::Load, text: "thruster off".into() },
        ],
    }
}

/// As above, of the first body only.
pub fn single(count: u64) -> Plan {
    let mut plan = plan(count);
    plan.bodies.truncate(1);
    plan.events.truncate(1);
    plan
}

/// Torque-free, tumbling about an axis near no principal one.
fn problem(moments: PrincipalMoments) -> Problem {
    Problem {
        moments,
        mass: Some(2.0),
        initial: State {
            attitude: Attitude::new([0.5, 0.5, -0.5, 0.5]).expect("a unit quaternion"),
            angular_velocity: AngularVelocity::new([0.7, -0.4, 1.1]).expect("finite rates"),
            position: Vector3::zeros(),
            velocity: Vector3::zeros(),
        },
        loads: Vec::new(),
        gravity: Vector3::zeros(),
        wants_attitude: true,
        wants_translation: true,
    }
}

fn body(name: &str, channels: &[Channel]) -> PlannedBody {
    let moments = PrincipalMoments::new([1.0, 2.0, 2.6]).expect("a body");
    let corner = |x, y| [x, y, 0.0];
    PlannedBody {
        name: name.into(),
        properties: MassProperties {
            mass: Some(2.0),
            centre_of_mass: Vector3::zeros(),
            moments,
            body_from_principal: UnitQuaternion::identity(),
            about: Vector3::zeros(),
        },
        surfaces: vec![Surface {
            vertices: vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(0.0, 1.0)],
            normals: vec![[0.0, 0.0, 1.0]; 3],
            triangles: vec![[0, 1, 2]],
        }],
        problem: problem(moments),
        path: Path::ClosedForm,
        reason: "no torque".into(),
        channels: channels.to_vec(),
        points: Vec::new(),
        skipped: Vec::new(),
        moves: false,
        is_pivoted: false,
        certificate: None,
    }
}

/// Every fourth sample drawn, three arrows a body.
#[cfg_attr(not(feature = "mcap"), allow(dead_code))]
pub fn picture(plan: &Plan) -> Picture {
    let arrow = |quantity| Arrow { quantity, label: "1 m = 1".into(), colour: [255, 128, 0], metres_per_unit: 1.0 };
    let quantities = [Quantity::AngularVelocity, Quantity::AngularMomentum, Quantity::Moment];
    let body = |body: &PlannedBody| BodyPicture {
        colour: [200, 200, 255, 255],
        extent: 1.0,
        arrows: quantities.into_iter().filter(|quantity| quantity.is_recorded(&body.channels)).map(arrow).collect(),
        spin_axis: Vector3::z(),
        position: Vector3::new(0.0, 0.0, 1.5),
        travels: body.channels.contains(&Channel::Position),
        poinsot: Poinsot::of(body),
    };
    Picture {
        stride: 4,
        playback_speed: 1.0,
        last: plan.grid.len() - 1,
        eye: Vector3::new(3.0, 0.0, 1.0),
        target: Vector3::zeros(),
        floor: 0.0,
        size: 1.0,
        bodies: plan.bodies.iter().map(body).collect(),
        powers: vec![(Channel::TotalEnergy, -3)],
    }
}

/// All samples of `plan`, in batches of `batch`, with numbers that try a format: −0, subnormal, huge, all 53 bits.
pub fn samples(plan: &Plan, batch: usize) -> Vec<Samples> {
    let count = plan.grid.len();
    let batches = (0..count).step_by(batch).map(|first_index| {
        let mut samples = Samples { first_index, ..Samples::default() };
        plan.grid.fill(first_index, batch, &mut samples.times_s);
        samples.stamps_ns = samples.times_s.iter().map(|time| nanoseconds(*time)).collect();
        samples.bodies = plan.bodies.iter().map(|body| body_samples(body, first_index, samples.len())).collect();
        samples
    });
    batches.collect()
}

fn body_samples(body: &PlannedBody, first_index: u64, count: usize) -> BodySamples {
    let mut samples = BodySamples::new(&body.channels);
    for channel in &body.channels {
        for (component, column) in samples.channel_mut(*channel).expect("watched").iter_mut().enumerate() {
            let seed = (*channel as u64) << 8 | component as u64;
            column.extend((first_index..).take(count).map(|index| value(index << 16 | seed)));
        }
    }
    samples
}

fn value(seed: u64) -> f64 {
    let bits = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    match bits % 16 {
        0 => -0.0,
        1 => 0.0,
        2 => f64::MIN_POSITIVE / 8.0,
        3 => -1.797e308,
        // 52 random bits and an exponent that makes it 1 to 2.
        _ => f64::from_bits(0x3ff0_0000_0000_0000 | bits >> 12) - 1.5,
    }
}

/// The bits of sample `index`: all of the body's columns.
pub fn bits(samples: &BodySamples, index: usize) -> Vec<u64> {
    samples.columns().iter().map(|column| column[index].to_bits()).collect()
}

/// Fails unless `recording` holds all samples of `plan`, to the bit, and is whole.
pub fn assert_same_samples(mut recording: Recording, plan: &Plan) {
    let count = usize::try_from(plan.grid.len()).expect("a short plan");
    let expected = &samples(plan, count)[0];
    let mut first = 0;
    while let Some(batch) = recording.next_batch().expect("whole") {
        assert_eq!(batch.first_index, first as u64);
        assert_eq!(batch.stamps_ns, expected.stamps_ns[first..first + batch.len()]);
        for index in 0..batch.len() {
            assert_eq!(batch.times_s[index].to_bits(), expected.times_s[first + index].to_bits());
            for (read, written) in batch.bodies.iter().zip(&expected.bodies) {
                assert_eq!(bits(read, index), bits(written, first + index), "sample {}", first + index);
            }
        }
        assert_eq!(batch.bodies.len(), expected.bodies.len());
        first += batch.len();
    }
    assert_eq!(first, count);
    assert!(recording.is_whole());
}
