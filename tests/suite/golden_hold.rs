//! What another crate's tests say of its simulation by a golden.

use std::path::PathBuf;

use polhode::golden::{self, Golden, GoldenError, HoldError, Limits, Pose, Quantity};
use polhode::recording::Recorder;
use polhode::scenario::{BodySpec, Plan, Scenario};
use tempfile::TempDir;

const MOMENTS: [f64; 3] = [1.0, 2.0, 3.0];

fn start() -> Pose {
    Pose::wxyz([0.8, 0.0, 0.6, 0.0]).turning_in_body([1.0, 2.0, 1.5])
}

/// What is exact: the golden itself, asked by time.
fn truth(golden: &Golden) -> impl Fn(f64) -> Pose + '_ {
    |time_s| golden.poses()[golden.times_s().iter().position(|known| *known == time_s).expect("a time of it")]
}

fn tumbling() -> Golden {
    Golden::free(MOMENTS, start(), 2.0, 0.01).expect("a motion")
}

fn scene(bodies: u32, channels: &[&str]) -> Plan {
    let body = |number: u32| BodySpec {
        name: format!("body_{number}"),
        principal_moments_kg_m2: Some(MOMENTS),
        angular_velocity_rad_s: Some([1.0, 2.0, f64::from(number)]),
        ..BodySpec::default()
    };
    let channels = (!channels.is_empty()).then(|| channels.iter().map(|name| (*name).to_owned()).collect());
    let scenario = Scenario {
        name: "free".into(),
        duration_s: Some(2.0),
        sample_every_s: Some(0.125),
        channels,
        body: (0..bodies).map(body).collect(),
        ..Scenario::default()
    };
    Plan::new(&scenario).expect("a plan")
}

fn recorded(plan: &Plan, format: &str) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(format!("golden.{format}"));
    let mut recorder = Recorder::create(plan, &[&path], false).expect("a free name");
    let mut run = plan.start().expect("a path");
    while let Some(samples) = run.next_batch().expect("a motion") {
        recorder.write(samples).expect("room");
    }
    recorder.finish().expect("room");
    (folder, path)
}

fn formats() -> Vec<&'static str> {
    let mut formats = vec!["csv"];
    formats.extend(cfg!(feature = "mcap").then_some("mcap"));
    formats.extend(cfg!(feature = "rerun").then_some("rrd"));
    formats
}

#[test]
fn the_exact_motion_holds_without_any_error_and_is_asked_for_in_order() {
    for format in formats() {
        let plan = scene(1, &[]);
        let (_folder, path) = recorded(&plan, format);
        let exact = Golden::planned(&plan, "body_0").expect("a motion");
        let mut asked = Vec::new();
        let report = golden::hold(&path, Limits::attitude(0.0).angular_velocity(0.0), |time_s| {
            asked.push(time_s);
            truth(&exact)(time_s)
        });
        let report = report.unwrap_or_else(|error| panic!("{format}: {error}"));
        assert_eq!(asked, exact.times_s(), "{format}: each time once, ascending");
        assert_eq!((report.rows.len(), report.first), (17, None));
        assert_eq!(report.attitude.map(|worst| worst.difference), Some(0.0));
        assert_eq!(report.angular_velocity.map(|worst| worst.difference), Some(0.0));
        assert_eq!(report.growth, None, "where nothing differs nothing grows");
    }
}

#[test]
fn signs_lengths_and_orders_of_quaternions_do_not_count_but_axes_do() {
    let golden = tumbling();
    let truth = truth(&golden);
    let limits = Limits::attitude(1e-15).angular_velocity(1e-14);
    let held = golden.hold(limits, |time_s| {
        let [w, x, y, z] = truth(time_s).attitude_wxyz().map(|part| -3.0 * part);
        let rates = truth(time_s).angular_velocity_in_world().expect("it turns");
        Pose::xyzw([x, y, z, w]).turning_in_world(rates)
    });
    let report = held.expect("the same motion");
    assert!((report.off_unit - 2.0).abs() < 1e-15 * 4.0, "{}", report.off_unit);
    assert!(report.to_string().contains("off unit length by up to 2.0e0"), "{report}");
    let in_wrong_axes = golden.hold(limits, |time_s| {
        let pose = truth(time_s);
        Pose::wxyz(pose.attitude_wxyz()).turning_in_world(pose.angular_velocity_in_body().expect("it turns"))
    });
    let Err(HoldError::Diverged(report)) = in_wrong_axes else { panic!("ω of the body is none of the world") };
    assert_eq!(report.first.expect("a divergence").quantity, Quantity::AngularVelocity);
    assert!(report.to_string().contains("rad/s in world axes"), "{report}");
    assert_eq!(report.attitude.map(|worst| worst.difference < 1e-15), Some(true));
}

/// A clock that is 1e-4 too fast is off by 1e-4 |ω| t: at 1 s by 2.69e-4 rad.
#[test]
fn the_report_says_where_it_first_diverges_and_how_it_grows() {
    let golden = tumbling();
    let fast = |time_s: f64| {
        let time_s = time_s * (1.0 + 1e-4);
        let rates = start().angular_velocity_in_body().expect("it turns");
        let moved = Golden::free(MOMENTS, start(), time_s.max(1e-3), time_s.max(1e-3)).expect("a motion");
        if time_s == 0.0 { start().turning_in_body(rates) } else { moved.poses()[1] }
    };
    let Err(error) = golden.hold(Limits::attitude(1e-4), fast) else { panic!("it is too fast") };
    assert_eq!(format!("{error}"), format!("{error:?}"), "what a test prints is the report");
    let HoldError::Diverged(report) = error else { panic!("{error}") };
    let first = report.first.expect("a divergence");
    let crossing = 1.0 / 7.25_f64.sqrt();
    assert!((first.time_s - crossing).abs() < 0.03, "{} s is not {crossing}", first.time_s);
    assert!(first.difference > 1e-4 && first.difference < 1.1e-4, "{first:?}");
    assert_eq!((first.limit, golden.times_s()[first.sample]), (1e-4, first.time_s));
    let worst = report.attitude.expect("a difference");
    assert!((worst.difference / (2e-4 * 7.25_f64.sqrt()) - 1.0).abs() < 0.05 && worst.at_s > 1.9, "{worst:?}");
    let text = report.to_string();
    for words in
        ["not the motion of a free body: attitude first out of its limit at", "grows as t^1.0", "limit 1e-4 rad"]
    {
        assert!(text.contains(words), "{words}: {text}");
    }
    let rows: Vec<_> = text.lines().skip_while(|line| !line.contains("time s")).skip(1).collect();
    assert_eq!(rows.len(), 7, "three before, three after: {text}");
    assert!(rows[3].starts_with("  > "), "{text}");
    assert!(golden.hold(Limits::attitude(1e-4).until(0.3), fast).is_ok(), "until then it is good enough");
    assert!(golden.hold(Limits::none(), fast).is_ok_and(|report| report.attitude == Some(worst)), "told, not judged");
}

#[test]
fn what_is_no_number_is_as_wrong_as_can_be() {
    let golden = tumbling();
    let truth = truth(&golden);
    let wrong = [
        Pose::wxyz([f64::NAN, 0.0, 0.0, 0.0]),
        Pose::wxyz([0.0; 4]),
        Pose::wxyz([f64::INFINITY, 0.0, 0.0, 0.0]),
        truth(0.0).turning_in_world([f64::NAN, 0.0, 0.0]),
        Pose::wxyz(truth(0.0).attitude_wxyz()),
    ];
    for pose in wrong {
        let held = golden.hold(Limits::attitude(4.0).angular_velocity(100.0), |_| pose);
        let Err(HoldError::Diverged(report)) = held else { panic!("{pose:?} passes") };
        let first = report.first.expect("a divergence");
        assert_eq!((first.time_s, first.difference), (0.0, f64::INFINITY), "{pose:?}");
        assert!(!report.to_string().is_empty());
    }
    let no_limit = golden.hold(Limits::attitude(f64::NAN), truth);
    assert!(matches!(no_limit, Err(HoldError::Diverged(_))), "no number is no limit");
}

#[test]
fn goldens_that_cannot_be_had_say_why() {
    let two = scene(2, &[]);
    let (_folder, path) = recorded(&two, "csv");
    let which = Golden::open(&path).expect_err("two bodies").to_string();
    assert!(which.ends_with("golden.csv holds the bodies body_0, body_1: name one of them"), "{which}");
    assert!(Golden::open_body(&path, "body_1").is_ok_and(|golden| golden.name() == "golden.csv (body_1)"));
    assert!(matches!(Golden::open_body(&path, "body_2"), Err(GoldenError::WhichBody { .. })));
    assert!(matches!(Golden::planned(&two, "body"), Err(GoldenError::WhichBody { .. })));

    let (_folder, path) = recorded(&scene(1, &["angular_velocity"]), "csv");
    assert!(matches!(Golden::open(&path), Err(GoldenError::NoAttitude { .. })));
    let (_folder, path) = recorded(&scene(1, &["attitude"]), "csv");
    let silent = Golden::open(&path).expect("an attitude");
    let held = silent.hold(Limits::attitude(1.0).angular_velocity(1.0), |_| start());
    assert!(matches!(held, Err(HoldError::Golden(GoldenError::NothingToLimit { .. }))));
    let none = silent.hold(Limits::attitude(1.0).until(-1.0), |_| start());
    assert!(matches!(none, Err(HoldError::Golden(GoldenError::Empty { .. }))), "nothing compared is nothing held");

    let absent = golden::hold("absent.csv", Limits::none(), |_| start()).expect_err("no file").to_string();
    assert!(absent.starts_with("cannot read absent.csv"), "{absent}");
    assert!(matches!(
        Golden::free(MOMENTS, Pose::wxyz([1.0, 0.0, 0.0, 0.0]), 1.0, 0.1),
        Err(GoldenError::NoAngularVelocity)
    ));
    let impossible = Golden::free([1.0, 1.0, 3.0], start(), 1.0, 0.1).expect_err("no body has these");
    assert!(impossible.to_string().contains("principal_moments_kg_m2"), "{impossible}");
}

#[cfg(feature = "serde")]
#[test]
fn scenes_are_goldens_too() {
    let golden = Golden::scene("dzhanibekov").expect("a scene");
    assert_eq!((golden.name(), golden.times_s().len()), ("dzhanibekov", 7001));
    assert!(matches!(Golden::scene("lagrange_top"), Err(GoldenError::WhichBody { .. })));
    assert!(matches!(Golden::scene("dzhanibekow"), Err(GoldenError::Scenario(_))));
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/scenarios/dzhanibekov.toml");
    assert_eq!(Golden::scene_file(file).expect("a scene").poses(), golden.poses());
}
