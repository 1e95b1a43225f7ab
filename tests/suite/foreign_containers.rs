//! `.mcap` and `.rrd` files that other programs wrote (the script is beside them), and what is wrong with damaged ones.

use std::fs;
use std::path::{Path, PathBuf};

use polhode::recording::foreign::{BodyMapping, Mapping, Observation, observe};
use polhode::recording::{Axes, Observed, PartFile, RecordingError, Track};
use tempfile::tempdir;

/// A few roundings.
const DOUBLE: f64 = 4.0 * f64::EPSILON;
/// What f32 may be off: a part of 1 has half a unit of 2⁻²⁴; a matrix and an axis lose three more.
const SINGLE: f64 = 4.0 / 16_777_216.0;

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/foreign").join(name)
}

fn read(name: &str) -> Observation {
    observe(&file(name), &Mapping::default()).unwrap_or_else(|error| panic!("{error}"))
}

fn of_frame(frame: &str) -> Mapping {
    Mapping { frame: Some(frame.into()), ..Mapping::default() }
}

fn body<'a>(observation: &'a Observation, name: &str) -> &'a Observed {
    let found = observation.bodies.iter().find(|body| body.name == name);
    found.unwrap_or_else(|| {
        panic!("no {name} among {:?}", observation.bodies.iter().map(|body| &body.name).collect::<Vec<_>>())
    })
}

fn product([a, b, c, d]: [f64; 4], [e, f, g, h]: [f64; 4]) -> [f64; 4] {
    [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]
}

/// Rz(0.7 t) Rx(0.4) Rz(1.9 t), as the script has it.
fn attitude(t: f64) -> [f64; 4] {
    let z = |angle: f64| [(angle / 2.0).cos(), 0.0, 0.0, (angle / 2.0).sin()];
    product(product(z(0.7 * t), [0.2_f64.cos(), 0.2_f64.sin(), 0.0, 0.0]), z(1.9 * t))
}

fn position(t: f64) -> [f64; 3] {
    [t, 2.0, -t]
}

fn rates(t: f64, axes: Axes) -> [f64; 3] {
    let (sine, cosine) = 0.4_f64.sin_cos();
    match axes {
        Axes::Body => [0.7 * sine * (1.9 * t).sin(), 0.7 * sine * (1.9 * t).cos(), 0.7 * cosine + 1.9],
        Axes::World => [1.9 * sine * (0.7 * t).sin(), -1.9 * sine * (0.7 * t).cos(), 1.9 * cosine + 0.7],
    }
}

/// All 40 samples, every 20 ms from 0, are what they should be.
fn assert_is<const N: usize>(track: Option<&Track<N>>, expected: impl Fn(f64) -> [f64; N], most: f64) {
    let track = track.expect("told");
    assert_eq!(track.times_s.len(), 40);
    for (index, time) in track.times_s.iter().enumerate() {
        let seconds = f64::from(20 * u32::try_from(index).expect("few")) / 1e3;
        assert_eq!(*time, seconds, "sample {index}");
        for (column, expected) in track.columns.iter().zip(expected(*time)) {
            assert!((column[index] - expected).abs() <= most, "sample {index}: {} is not {expected}", column[index]);
        }
    }
}

fn assert_rates(track: Option<&Track<3>>, axes: Axes) {
    assert_eq!(track.expect("told").axes, Some(axes));
    assert_is(track, |t| rates(t, axes), DOUBLE);
}

#[test]
fn transforms_and_an_imu_of_ros_2_are_one_body() {
    let found = read("ros2_zstd.mcap");
    assert_eq!(found.start_ns, 1_700_000_000_123_456_789, "the first stamp");
    assert_eq!(found.bodies.len(), 1);
    let base = body(&found, "base_link");
    assert_is(base.attitude.as_ref(), attitude, DOUBLE);
    assert_is(base.position.as_ref(), position, 0.0);
    assert_rates(base.angular_velocity.as_ref(), Axes::Body);
    assert_eq!(found.remarks, ["/imu: taken for base_link, in its axes", "told once, so taken to rest: camera"]);
}

#[test]
fn odometry_poses_twists_and_wrenches_of_ros_2_are_in_their_frames() {
    let found = read("ros2_lz4.mcap");
    let odometry = body(&found, "/odom");
    assert_is(odometry.attitude.as_ref(), attitude, DOUBLE);
    assert_rates(odometry.angular_velocity.as_ref(), Axes::Body);
    assert_eq!(odometry.velocity.as_ref().expect("told").axes, Some(Axes::Body));
    assert_is(odometry.velocity.as_ref(), |_| [1.0, 2.0, 3.0], 0.0);
    let pose = body(&found, "/pose");
    assert_is(pose.attitude.as_ref(), attitude, DOUBLE);
    assert_rates(pose.angular_velocity.as_ref(), Axes::World);
    assert_is(pose.moment.as_ref(), |t| [0.1, 0.2, t], 0.0);
    assert_eq!(pose.moment.as_ref().expect("told").axes, Some(Axes::World));
    assert_eq!((found.bodies.len(), found.start_ns), (2, 0));
}

#[test]
fn messages_of_foxglove_are_read_from_protobuf_and_json() {
    let found = read("foxglove_protobuf.mcap");
    for name in ["top", "/pose", "/poses[1]", "/odometry"] {
        assert_is(body(&found, name).attitude.as_ref(), attitude, DOUBLE);
        assert_is(body(&found, name).position.as_ref(), position, 0.0);
    }
    assert_rates(body(&found, "/odometry").angular_velocity.as_ref(), Axes::Body);
    assert_is(body(&found, "/poses[0]").position.as_ref(), |t| [5.0, t, 0.0], 0.0);
    assert_eq!(found.bodies.len(), 5);
    let found = read("foxglove_json.mcap");
    assert_is(body(&found, "top").attitude.as_ref(), attitude, DOUBLE);
    assert_eq!(body(&found, "top").attitude.as_ref().expect("told").resolution, f64::EPSILON);
}

#[test]
fn one_body_may_be_asked_for() {
    let found = observe(&file("foxglove_protobuf.mcap"), &of_frame("top")).expect("told");
    assert_eq!((found.bodies.len(), found.bodies[0].name.as_str()), (1, "top"));
    let mapping = Mapping { world: Some("map".into()), ..Mapping::default() };
    let found = observe(&file("ros2_lz4.mcap"), &mapping).expect("told");
    assert_eq!((found.bodies.len(), found.bodies[0].name.as_str()), (1, "/pose"));
    let refused = observe(&file("foxglove_protobuf.mcap"), &of_frame("bottom")).expect_err("not there").to_string();
    assert!(refused.contains("no \"bottom\", only of top, /pose, /poses[0]"), "{refused}");
}

#[test]
fn transforms_of_rerun_are_read_in_every_form() {
    let found = read("rerun.rrd");
    let names: Vec<_> = found.bodies.iter().map(|body| body.name.as_str()).collect();
    assert_eq!(names, ["/world/back", "/world/matrix", "/world/top"]);
    for body in &found.bodies {
        let track = body.attitude.as_ref().expect("told");
        assert_eq!(track.resolution, 1.0 / 16_777_216.0);
        // A matrix and an axis tell a turn, not the sign of its quaternion: it continues from the first.
        let sign = (track.columns[0][0] * attitude(0.0)[0]).signum();
        assert_is(Some(track), |t| attitude(t).map(|part| sign * part), SINGLE);
    }
    assert_is(body(&found, "/world/top").position.as_ref(), position, SINGLE);
}

#[test]
fn a_timeline_that_counts_tells_no_times() {
    let refused = observe(&file("rerun_frames.rrd"), &Mapping::default()).expect_err("no times").to_string();
    assert!(refused.contains("its timeline frame counts"), "{refused}");
    for (timeline, expected) in [("frame", "counts: it tells no times"), ("sim", "no timeline \"sim\"")] {
        let mapping = Mapping { timeline: Some(timeline.into()), ..Mapping::default() };
        let refused = observe(&file("rerun_frames.rrd"), &mapping).expect_err("no times").to_string();
        assert!(refused.contains(expected), "{refused}");
    }
    let mapping = Mapping { timeline: Some("log_time".into()), ..Mapping::default() };
    let found = observe(&file("rerun_frames.rrd"), &mapping).expect("logged at some times");
    assert!(found.start_ns > 1_700_000_000_000_000_000, "{}", found.start_ns);
}

/// A recording of this crate has every sample in scalars: read as those of another, they are the same.
#[test]
fn scalars_of_rerun_are_read_by_a_mapping() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("run.rrd");
    let plan = crate::planned::single(300);
    let formats = crate::faults::formats();
    let (_, open) = formats.into_iter().find(|(name, _)| *name == "rrd").expect("in this build");
    crate::faults::record(&plan, open, PartFile::create(&path, false).expect("a free name")).expect("room");
    let name = &plan.bodies[0].name;
    let quaternion = [1, 2, 3, 4].map(|part| format!("/body/{name}/plots/attitude:{part}"));
    let body = |quaternion| vec![BodyMapping { quaternion: Some(quaternion), ..BodyMapping::default() }];
    let mapping = |body| Mapping { body, ..Mapping::default() };
    let found = observe(&path, &mapping(body(quaternion.clone()))).expect("told");
    let (found, expected) = (&found.bodies[0], &observe(&path, &Mapping::default()).expect("told").bodies[0]);
    let [found, expected] = [found, expected].map(|body| body.attitude.as_ref().expect("told"));
    assert_eq!(found.columns, expected.columns);
    for (found, expected) in found.times_s.iter().zip(&expected.times_s) {
        assert!((found - expected).abs() <= 5e-10, "{found} s is not {expected} s to the ns");
    }
    let mut fifth = quaternion;
    fifth[3] = format!("/body/{name}/plots/attitude:5");
    let refused = observe(&path, &mapping(body(fifth))).expect_err("it has four").to_string();
    assert!(refused.contains("attitude:5\": the columns are"), "{refused}");
}

/// Cut at a byte or damaged in it (every so many, to be quick): an error with the file's name, or what is left; never
/// a panic.
#[test]
fn damaged_containers_do_no_harm() {
    let folder = tempdir().expect("a folder");
    let files = [
        ("ros2_zstd.mcap", 31),
        ("ros2_lz4.mcap", 61),
        ("foxglove_protobuf.mcap", 31),
        ("foxglove_json.mcap", 31),
        ("rerun.rrd", 131),
    ];
    for (name, every) in files {
        let bytes = fs::read(file(name)).expect("committed");
        let path = folder.path().join(name);
        let attempt = |bytes: &[u8]| -> Result<Observation, RecordingError> {
            fs::write(&path, bytes).expect("room");
            observe(&path, &Mapping::default())
        };
        for place in (0..bytes.len()).step_by(every) {
            let cut = attempt(&bytes[..place]).expect_err("cut").to_string();
            assert!(cut.contains(name), "{cut}");
            let mut damaged = bytes.clone();
            damaged[place] ^= 0xff;
            if let Err(error) = attempt(&damaged) {
                assert!(error.to_string().contains(name), "{error}");
            }
        }
    }
}
