use std::fs;
use std::path::{Path, PathBuf};

use polhode::comparison::{Comparison, Difference, Side, Tolerances};
use polhode::recording::foreign::{Mapping, observe};
use polhode::recording::{Conversion, Recorder, Recording, recover};
use polhode::scenario::Plan;
use polhode::telemetry::{BodySamples, Channel};
use tempfile::tempdir;

/// Two bodies with three points, more than one batch; the second has a name that the first's probe has too.
const SCENE: &str = r#"
title = "Probes"
duration_s = 9.0
sample_every_s = 0.001

[[body]]
name = "box"
mass_kg = 2.0
principal_moments_kg_m2 = [1.0, 2.0, 2.6]
angular_velocity_rad_s = [0.7, -0.4, 1.1]
velocity_m_s = [0.1, 0.0, 0.2]
gravity_m_s2 = [0.0, 0.0, -9.81]

[[body.probe]]
name = "plots"
point_m = [0.3, -0.2, 0.1]

[[body.imu]]
name = "state"
point_m = [0.1, 0.0, -0.4]
attitude = [0.5, 0.5, -0.5, 0.5]

[[body]]
name = "plots"
principal_moments_kg_m2 = [1.0, 2.0, 3.0]
angular_velocity_rad_s = [0.01, 5.0, 0.01]

[[body.probe]]
name = "tip"
point_m = [0.0, 0.0, 1.0]
frame = "body"
"#;

const FORMATS: &[&str] = &[
    #[cfg(feature = "mcap")]
    "mcap",
    #[cfg(feature = "rerun")]
    "rrd",
    "csv",
];

/// Runs `plan` to each format of this build.
fn run(plan: &Plan, folder: &Path) -> Vec<PathBuf> {
    let paths: Vec<_> = FORMATS.iter().map(|extension| folder.join(format!("probes.{extension}"))).collect();
    let mut recorder = Recorder::create(plan, &paths, false).expect("free names");
    let mut run = plan.start().expect("a motion");
    while let Some(samples) = run.next_batch().expect("finite states") {
        recorder.write(samples).expect("room");
    }
    recorder.finish().expect("room");
    paths
}

/// All columns, as bits.
fn columns(path: &Path) -> Vec<Vec<u64>> {
    let mut recording = Recording::open(path).expect("whole");
    let mut all =
        vec![Vec::new(); recording.heading().bodies.iter().flat_map(|body| &body.channels).map(|c| c.width()).sum()];
    while let Some(samples) = recording.next_batch().expect("whole") {
        for (all, column) in all.iter_mut().zip(samples.bodies.iter().flat_map(BodySamples::columns)) {
            all.extend(column.iter().map(|value| value.to_bits()));
        }
    }
    assert!(recording.is_whole());
    all
}

/// After the bodies, under names of their own, whatever a name may be mistaken for; to the bit.
#[test]
fn points_are_recorded_beside_the_bodies_in_every_format() {
    let folder = tempdir().expect("a folder");
    let plan = super::plan(SCENE);
    let expected: Vec<Vec<u64>> = plan
        .watched()
        .flat_map(|watched| super::recorded(&plan, watched.name()).columns().to_vec())
        .map(|column| column.into_iter().map(f64::to_bits).collect())
        .collect();
    for path in run(&plan, folder.path()) {
        let heading = Recording::open(&path).expect("whole").heading().clone();
        let names: Vec<_> = heading.bodies.iter().map(|body| (body.name.as_str(), body.is_point())).collect();
        let points = [("box/plots", true), ("box/state", true), ("plots/tip", true)];
        assert_eq!(names, [[("box", false), ("plots", false)].as_slice(), &points].concat(), "{path:?}");
        assert_eq!(heading.bodies[2].channels, [Channel::Position, Channel::Velocity, Channel::Acceleration]);
        assert_eq!(heading.bodies[3].channels, [Channel::Gyroscope, Channel::Accelerometer]);
        let in_body = [Channel::PositionBody, Channel::VelocityBody, Channel::AccelerationBody];
        assert_eq!(heading.bodies[4].channels, in_body);
        assert!(columns(&path) == expected, "{path:?}");
    }
}

/// With the scene to the bytes of a run, without it column by column, as a part that was cut off too.
#[test]
fn points_are_converted_and_recovered() {
    let folder = tempdir().expect("a folder");
    let plan = super::plan(SCENE);
    let recorded = run(&plan, folder.path());
    for from in &recorded {
        let format = from.extension().and_then(|format| format.to_str()).expect("an extension");
        for expected in &recorded {
            let to = expected.extension().and_then(|format| format.to_str()).expect("an extension");
            let path = folder.path().join(format!("{format}.{to}"));
            let conversion = Conversion::of(from).expect("whole");
            assert_eq!(conversion.plan().is_some(), format != "csv", "{:?}", conversion.remark());
            conversion.write(&[&path], false).expect("room");
            assert!(columns(&path) == columns(expected), "{from:?} to {to}");
            let is_same = fs::read(&path).expect("there") == fs::read(expected).expect("there");
            assert!(is_same || format == "csv", "{from:?} to {to}");
        }
        let part = folder.path().join(format!("killed.{format}.part"));
        fs::copy(from, &part).expect("room");
        let recovered = recover(&part, None, false).expect("samples");
        assert!(fs::read(&recovered.file.path).expect("there") == fs::read(from).expect("there"), "{format}");
    }
}

/// One digest of all formats; compared, they are the same, and so is the scene.
#[test]
fn points_are_compared_and_digested() {
    let folder = tempdir().expect("a folder");
    let plan = super::plan(SCENE);
    let recorded = run(&plan, folder.path());
    let comparison = Comparison { tolerances: Tolerances::exact(), ..Comparison::default() };
    let side = |path: &Path| Side::open(path).expect("whole");
    for path in &recorded {
        #[cfg(any(feature = "mcap", feature = "rerun"))]
        {
            use polhode::comparison::digest;
            assert_eq!(digest(path).expect("whole"), digest(&recorded[0]).expect("whole"));
        }
        for report in [comparison.run(side(path), side(&recorded[0])), comparison.run(side(path), Side::Scene(&plan))] {
            let report = report.expect("times in common");
            assert!(report.is_same() && report.bodies.len() == 5, "{path:?}");
        }
    }
    let moved = super::plan(&SCENE.replace("point_m = [0.0, 0.0, 1.0]", "point_m = [0.0, 0.0, 1.1]"));
    let report = comparison.run(side(&recorded[0]), Side::Scene(&moved)).expect("times in common");
    let differing = |name: &str| {
        let body = report.bodies.iter().find(|body| body.name() == name).expect("compared");
        body.channels.iter().any(|channel| channel.worst_difference() > 0.05)
    };
    assert!(!report.is_same() && differing("plots/tip") && !differing("box/plots") && !differing("box"));
    let without = super::plan(SCENE.split("[[body.probe]]\nname = \"tip\"").next().expect("a beginning"));
    let report = comparison.run(side(&recorded[0]), Side::Scene(&without)).expect("times in common");
    let lacking = |difference: &Difference| matches!(difference, Difference::Body { name, .. } if name == "plots/tip");
    assert!(!report.is_same() && report.differences.iter().any(lacking));
}

/// What is verified is the bodies: a point has no inertia and obeys no law of its own.
#[test]
fn points_are_not_verified_as_bodies() {
    let folder = tempdir().expect("a folder");
    for path in run(&super::plan(SCENE), folder.path()) {
        let observation = observe(&path, &Mapping::default()).expect("bodies");
        let names: Vec<_> = observation.bodies.iter().map(|body| body.name.as_str()).collect();
        assert_eq!(names, ["box", "plots"], "{path:?}");
    }
}
