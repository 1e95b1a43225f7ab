//! `.mcap`: the same plan gives the same bytes, and what is read back is what was recorded, to the bit.

use std::fs;
use std::path::Path;

use mcap::MessageStream;
use polhode::recording::mcap_file::McapFile;
use polhode::recording::{Contents, Entry, PartFile, Recorder, Recording, Sink, Subject, contents};
use polhode::scenario::Plan;
use polhode::telemetry::{BodySamples, Channel};
use prost::Message;
use tempfile::tempdir;

use crate::planned::{assert_same_samples, bits, picture, plan, samples, single};

/// `polhode.BodyState` as its schema says, written down a second time.
#[derive(Clone, PartialEq, Message)]
struct BodyState {
    #[prost(double, tag = "1")]
    time_s: f64,
    #[prost(message, optional, tag = "2")]
    timestamp: Option<Timestamp>,
    #[prost(message, optional, tag = "3")]
    attitude: Option<Numbers>,
    #[prost(message, optional, tag = "4")]
    angular_velocity: Option<Numbers>,
    #[prost(message, optional, tag = "5")]
    angular_velocity_world: Option<Numbers>,
    #[prost(message, optional, tag = "6")]
    angular_momentum_world: Option<Numbers>,
    #[prost(message, optional, tag = "7")]
    angular_momentum_body: Option<Numbers>,
    #[prost(message, optional, tag = "8")]
    moment_body: Option<Numbers>,
    #[prost(message, optional, tag = "9")]
    moment_world: Option<Numbers>,
    #[prost(message, optional, tag = "10")]
    position: Option<Numbers>,
    #[prost(message, optional, tag = "11")]
    velocity: Option<Numbers>,
    #[prost(message, optional, tag = "12")]
    force_world: Option<Numbers>,
    #[prost(double, optional, tag = "13")]
    rotational_energy: Option<f64>,
    #[prost(double, optional, tag = "14")]
    translational_energy: Option<f64>,
    #[prost(double, optional, tag = "15")]
    potential_energy: Option<f64>,
    #[prost(double, optional, tag = "16")]
    total_energy: Option<f64>,
    #[prost(double, optional, tag = "17")]
    energy_drift: Option<f64>,
    #[prost(double, optional, tag = "18")]
    momentum_drift: Option<f64>,
    #[prost(double, optional, tag = "19")]
    slip: Option<f64>,
    #[prost(double, optional, tag = "20")]
    tilt: Option<f64>,
    #[prost(double, optional, tag = "21")]
    precession_rate: Option<f64>,
    #[prost(message, optional, tag = "22")]
    euler_zxz: Option<Numbers>,
    #[prost(message, optional, tag = "23")]
    euler_zyz: Option<Numbers>,
    #[prost(message, optional, tag = "24")]
    euler_zyx: Option<Numbers>,
    #[prost(message, optional, tag = "25")]
    euler_xyz: Option<Numbers>,
    #[prost(message, optional, tag = "26")]
    figure_angles: Option<Numbers>,
    #[prost(message, optional, tag = "27")]
    figure_rates: Option<Numbers>,
    #[prost(double, optional, tag = "28")]
    momentum_tilt: Option<f64>,
    #[prost(double, optional, tag = "29")]
    polhode_phase: Option<f64>,
    #[prost(double, optional, tag = "30")]
    separatrix_distance: Option<f64>,
    #[prost(double, optional, tag = "31")]
    kinetic_energy: Option<f64>,
    #[prost(double, optional, tag = "32")]
    jacobi_integral: Option<f64>,
    #[prost(double, optional, tag = "33")]
    kovalevskaya_integral: Option<f64>,
    #[prost(message, optional, tag = "34")]
    acceleration: Option<Numbers>,
    #[prost(message, optional, tag = "35")]
    position_body: Option<Numbers>,
    #[prost(message, optional, tag = "36")]
    velocity_body: Option<Numbers>,
    #[prost(message, optional, tag = "37")]
    acceleration_body: Option<Numbers>,
    #[prost(message, optional, tag = "38")]
    gyroscope: Option<Numbers>,
    #[prost(message, optional, tag = "39")]
    accelerometer: Option<Numbers>,
}

#[derive(Clone, Copy, PartialEq, Message)]
struct Timestamp {
    #[prost(int64, tag = "1")]
    seconds: i64,
    #[prost(int32, tag = "2")]
    nanos: i32,
}

/// A vector or a quaternion.
#[derive(Clone, Copy, PartialEq, Message)]
struct Numbers {
    #[prost(double, optional, tag = "1")]
    first: Option<f64>,
    #[prost(double, optional, tag = "2")]
    second: Option<f64>,
    #[prost(double, optional, tag = "3")]
    third: Option<f64>,
    #[prost(double, optional, tag = "4")]
    fourth: Option<f64>,
}

impl BodyState {
    fn of(samples: &BodySamples, index: usize, time_s: f64, stamp_ns: i64) -> Self {
        let scalar = |channel| Some(samples.channel(channel)?[0][index]);
        let numbers = |channel| {
            let columns = samples.channel(channel)?;
            let number = |component: usize| Some(columns.get(component)?[index]);
            Some(Numbers { first: number(0), second: number(1), third: number(2), fourth: number(3) })
        };
        let nanos = i32::try_from(stamp_ns % 1_000_000_000).expect("below 1e9");
        Self {
            time_s,
            timestamp: Some(Timestamp { seconds: stamp_ns / 1_000_000_000, nanos }),
            attitude: numbers(Channel::Attitude),
            angular_velocity: numbers(Channel::AngularVelocity),
            angular_velocity_world: numbers(Channel::AngularVelocityWorld),
            angular_momentum_world: numbers(Channel::AngularMomentumWorld),
            angular_momentum_body: numbers(Channel::AngularMomentumBody),
            moment_body: numbers(Channel::MomentBody),
            moment_world: numbers(Channel::MomentWorld),
            position: numbers(Channel::Position),
            velocity: numbers(Channel::Velocity),
            force_world: numbers(Channel::ForceWorld),
            rotational_energy: scalar(Channel::RotationalEnergy),
            translational_energy: scalar(Channel::TranslationalEnergy),
            potential_energy: scalar(Channel::PotentialEnergy),
            total_energy: scalar(Channel::TotalEnergy),
            energy_drift: scalar(Channel::EnergyDrift),
            momentum_drift: scalar(Channel::MomentumDrift),
            slip: scalar(Channel::Slip),
            tilt: scalar(Channel::Tilt),
            precession_rate: scalar(Channel::PrecessionRate),
            euler_zxz: numbers(Channel::EulerZxz),
            euler_zyz: numbers(Channel::EulerZyz),
            euler_zyx: numbers(Channel::EulerZyx),
            euler_xyz: numbers(Channel::EulerXyz),
            figure_angles: numbers(Channel::FigureAngles),
            figure_rates: numbers(Channel::FigureRates),
            momentum_tilt: scalar(Channel::MomentumTilt),
            polhode_phase: scalar(Channel::PolhodePhase),
            separatrix_distance: scalar(Channel::SeparatrixDistance),
            kinetic_energy: scalar(Channel::KineticEnergy),
            jacobi_integral: scalar(Channel::JacobiIntegral),
            kovalevskaya_integral: scalar(Channel::KovalevskayaIntegral),
            acceleration: numbers(Channel::Acceleration),
            position_body: numbers(Channel::PositionBody),
            velocity_body: numbers(Channel::VelocityBody),
            acceleration_body: numbers(Channel::AccelerationBody),
            gyroscope: numbers(Channel::Gyroscope),
            accelerometer: numbers(Channel::Accelerometer),
        }
    }

    /// The numbers of every channel that is there, in the order of the fields.
    fn bits(&self) -> Vec<u64> {
        let tuples = [
            &self.attitude,
            &self.angular_velocity,
            &self.angular_velocity_world,
            &self.angular_momentum_world,
            &self.angular_momentum_body,
            &self.moment_body,
            &self.moment_world,
            &self.position,
            &self.velocity,
            &self.force_world,
        ];
        let scalars = [
            self.rotational_energy,
            self.translational_energy,
            self.potential_energy,
            self.total_energy,
            self.energy_drift,
            self.momentum_drift,
            self.slip,
            self.tilt,
            self.precession_rate,
        ];
        let derived_tuples = [
            &self.euler_zxz,
            &self.euler_zyz,
            &self.euler_zyx,
            &self.euler_xyz,
            &self.figure_angles,
            &self.figure_rates,
        ];
        let derived_scalars = [
            self.momentum_tilt,
            self.polhode_phase,
            self.separatrix_distance,
            self.kinetic_energy,
            self.jacobi_integral,
            self.kovalevskaya_integral,
        ];
        let of_points = [
            &self.acceleration,
            &self.position_body,
            &self.velocity_body,
            &self.acceleration_body,
            &self.gyroscope,
            &self.accelerometer,
        ];
        let numbers =
            |tuple: &Option<Numbers>| tuple.iter().flat_map(|n| [n.first, n.second, n.third, n.fourth]).collect();
        let numbers =
            |tuples: &[&Option<Numbers>]| -> Vec<_> { tuples.iter().flat_map(|n| -> Vec<_> { numbers(n) }).collect() };
        let derived = [numbers(&derived_tuples), derived_scalars.to_vec(), numbers(&of_points)].concat();
        let all = [numbers(&tuples), scalars.to_vec(), derived].concat();
        all.into_iter().flatten().map(f64::to_bits).collect()
    }
}

/// Records `plan` at `path` in batches of `batch`.
fn record(plan: &Plan, path: &Path, batch: usize) {
    let file = PartFile::create(path, false).expect("a free name");
    let mut sink = McapFile::create(&Subject::drawn(plan, &picture(plan)), file).expect("room");
    for samples in samples(plan, batch) {
        sink.write(&samples).expect("room");
    }
    Box::new(sink).finish().expect("room").publish().expect("a free name");
}

#[test]
fn same_plan_same_bytes_however_it_is_batched() {
    let folder = tempdir().expect("a folder");
    let plan = plan(5000);
    let recorded = [5000, 5000, 1000, 7].map(|batch| {
        let path = folder.path().join(format!("{batch}.mcap"));
        record(&plan, &path, batch);
        let bytes = fs::read(&path).expect("recorded");
        fs::remove_file(path).expect("recorded");
        bytes
    });
    assert!(recorded.iter().all(|bytes| *bytes == recorded[0]));
}

#[test]
fn samples_read_back_to_the_bit() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("pair.mcap");
    let plan = plan(3000);
    record(&plan, &path, 1024);
    let bytes = fs::read(&path).expect("recorded");
    for (body, planned) in plan.bodies.iter().enumerate() {
        let topic = format!("/body/{}/state", planned.name);
        let messages = MessageStream::new(&bytes).expect("an mcap").map(|message| message.expect("whole"));
        let mut messages = messages.filter(|message| message.channel.topic == topic);
        for samples in samples(&plan, 3000) {
            for index in 0..samples.len() {
                let message = messages.next().expect("a message a sample");
                let (time, stamp) = (samples.times_s[index], samples.stamps_ns[index]);
                let state = BodyState::decode(&*message.data).expect("its schema");
                assert_eq!(state.bits(), bits(&samples.bodies[body], index), "{topic} at {time} s");
                assert_eq!(state.time_s.to_bits(), time.to_bits());
                assert_eq!((message.log_time, message.publish_time), (stamp.cast_unsigned(), stamp.cast_unsigned()));
                assert_eq!(message.sequence as usize, index);
            }
        }
        assert!(messages.next().is_none());
    }
}

#[test]
fn a_recording_gives_back_what_was_recorded() {
    let folder = tempdir().expect("a folder");
    for (number, plan) in [plan(20_000), single(3)].into_iter().enumerate() {
        let path = folder.path().join(format!("{number}.mcap"));
        record(&plan, &path, 1024);
        let recording = Recording::open(&path).expect("whole");
        let heading = recording.heading();
        for (read, planned) in heading.bodies.iter().zip(&plan.bodies) {
            assert_eq!((&read.name, &read.channels), (&planned.name, &planned.channels));
        }
        assert_eq!(heading.scene.as_deref(), Some(plan.text.as_str()));
        assert!(heading.provenance.contains(&("scene".into(), plan.name.clone())));
        assert_same_samples(recording, &plan);
    }
}

#[test]
fn the_hand_laid_encoder_writes_what_a_derived_one_writes() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("one.mcap");
    let plan = single(2000);
    record(&plan, &path, 2000);
    let bytes = fs::read(&path).expect("recorded");
    let messages = MessageStream::new(&bytes).expect("an mcap").map(|message| message.expect("whole"));
    let states: Vec<_> = messages.filter(|message| message.channel.topic == "/body/upper/state").collect();
    let samples = &samples(&plan, 2000)[0];
    for (index, message) in states.iter().enumerate() {
        let mut state = BodyState::of(&samples.bodies[0], index, samples.times_s[index], samples.stamps_ns[index]);
        let mut expected = state.encode_to_vec();
        if index == 0 {
            // A derived encoder leaves out the time 0; it is the only zero it treats so.
            state.time_s = 1.0;
            expected = state.encode_to_vec();
            expected[1..9].copy_from_slice(&0.0_f64.to_le_bytes());
        }
        assert_eq!(message.data, expected, "sample {index}");
    }
    assert_eq!(states.len(), 2000);
}

/// Its count, and the times of its first and last message.
fn entry(contents: &Contents, name: &str) -> Option<(u64, Option<f64>, Option<f64>)> {
    let found: Vec<&Entry> = contents.entries.iter().filter(|entry| entry.name == name).collect();
    (found.len() == 1).then(|| (found[0].count, found[0].from_s, found[0].to_s))
}

#[test]
fn contents_name_every_topic_with_its_times() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("pair.mcap");
    record(&plan(5002), &path, 4096);
    let from_summary = contents(&path).expect("an mcap");
    let part = folder.path().join("pair.mcap.part");
    fs::copy(&path, &part).expect("room");
    let from_start = contents(&part).expect("an mcap");
    assert_eq!(from_summary, from_start);
    assert_eq!(entry(&from_summary, "/body/upper/state"), Some((5002, Some(0.0), Some(5.001))));
    assert_eq!(entry(&from_summary, "/body/lower/state"), Some((5002, Some(0.0), Some(5.001))));
    // Every fourth of 0 … 5001, and the last.
    assert_eq!(entry(&from_summary, "/tf"), Some((1252, Some(0.0), Some(5.001))));
    assert_eq!(entry(&from_summary, "/scene"), Some((1252, Some(0.0), Some(5.001))));
    assert_eq!(entry(&from_summary, "/scene/surfaces"), Some((1, Some(0.0), Some(0.0))));
    assert_eq!(entry(&from_summary, "/log"), Some((3, Some(0.0), Some(2.5e-3))));
    let detail = |name: &str| from_summary.details.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_str());
    assert_eq!(detail("body.upper.method"), Some("closed form"));
    assert_eq!(detail("schema_version"), Some("1"));
    assert_eq!(detail("attachment pair.toml"), Some("application/toml, 21 bytes"));
}

#[test]
fn without_attitude_nothing_is_turned() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("lower.mcap");
    let mut plan = plan(100);
    plan.bodies.remove(0);
    plan.events.clear();
    record(&plan, &path, 100);
    let contents = contents(&path).expect("an mcap");
    let topics: Vec<_> = contents.entries.iter().map(|entry| entry.name.as_str()).collect();
    assert_eq!(topics, ["/body/lower/state", "/log"]);
}

#[test]
fn a_recorder_records_a_run() {
    let folder = tempdir().expect("a folder");
    let paths = ["run.mcap", "run.csv"].map(|name| folder.path().join(name));
    let plan = plan(20_000);
    let mut recorder = Recorder::create(&plan, &paths, false).expect("free names");
    let mut run = plan.start().expect("a motion");
    while let Some(samples) = run.next_batch().expect("finite states") {
        recorder.write(samples).expect("room");
    }
    let finished = recorder.finish().expect("room");
    for (finished, path) in finished.iter().zip(&paths) {
        assert_eq!(finished.path, *path);
        assert_eq!(finished.bytes, fs::metadata(path).expect("published").len());
        assert!(contents(path).expect("whole").entries.iter().any(|entry| entry.count == 20_000));
    }
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 2);
}
