//! Tables of numbers that any program may have written, read by a mapping.

use std::fs;

use polhode::recording::csv_file::CsvFile;
use polhode::recording::foreign::{BodyMapping, Mapping, Observation, RateUnit, Sense, TimeUnit, observe};
use polhode::recording::{Axes, PartFile, RecordingError, Sink, Subject};
use polhode::telemetry::Channel;
use tempfile::tempdir;

use crate::planned::{plan, samples};

fn observed(text: &str, mapping: &Mapping) -> Result<Observation, RecordingError> {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("run.csv");
    fs::write(&path, text).expect("room");
    observe(&path, mapping)
}

/// What is wrong, in words.
fn refusal(text: &str, mapping: &Mapping) -> String {
    observed(text, mapping).expect_err("a refusal").to_string()
}

fn names<const N: usize>(text: &str) -> Option<[String; N]> {
    text.split_whitespace().map(str::to_owned).collect::<Vec<_>>().try_into().ok()
}

fn quaternion(text: &str) -> Mapping {
    let body = BodyMapping { quaternion: names(text), ..BodyMapping::default() };
    Mapping { body: vec![body], ..Mapping::default() }
}

#[test]
fn a_recording_of_this_program_tells_its_columns_to_the_bit() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("pair.csv");
    let plan = plan(5000);
    let mut sink =
        Box::new(CsvFile::create(&Subject::of(&plan), PartFile::create(&path, true).expect("a name")).expect("room"));
    for samples in samples(&plan, 1000) {
        sink.write(&samples).expect("room");
    }
    sink.finish().expect("room").publish().expect("a name");
    let found = observe(&path, &Mapping::default()).expect("whole");
    let expected = &samples(&plan, 5000)[0];
    assert_eq!(found.bodies.len(), 2);
    for (body, samples) in found.bodies.iter().zip(&expected.bodies) {
        let attitude = body.attitude.as_ref().map(|track| track.columns.as_slice());
        assert_eq!(attitude, samples.channel(Channel::Attitude));
        let rates = body.angular_velocity.as_ref().map(|track| track.columns.as_slice());
        assert_eq!(rates, samples.channel(Channel::AngularVelocity));
    }
    let rates = found.bodies.iter().find_map(|body| body.angular_velocity.as_ref()).expect("recorded");
    assert_eq!(rates.times_s, expected.times_s);
    assert_eq!((rates.axes, rates.resolution), (Some(Axes::Body), f64::EPSILON / 2.0));
    assert_eq!((found.start_ns, found.time_resolution_s), (0, 0.0));
}

/// The same three samples in the layouts of six programs.
#[test]
fn every_layout_gives_the_same_numbers() {
    let by_number = quaternion("2 3 4 5");
    let texts = [
        ("t,qw,qx,qy,qz\n0,1,0,0,0\n0.5,0.8,0.6,0,0\n1,0.6,0,0.8,0\n", Mapping::default()),
        (
            "\u{feff}\"t\"; \"qz\"; \"qy\"; \"qx\"; \"qw\"\r\n0;0;0;0;1\r\n0.5;0;0;0.6;0.8\r\n1;0;0.8;0;0.6",
            Mapping::default(),
        ),
        ("# made by hand\n# t qw qx qy qz\n0 1 0 0 0\n0.5  0.8\t0.6 0 0\n\n 1 .6 0 .8 0 \n", Mapping::default()),
        (
            "0\t1\t0\t0\t0\n0.5\t0.8\t0.6\t0\t0\n1\t0.6\t0\t0.8\t0\n",
            Mapping { time: Some("1".into()), ..by_number.clone() },
        ),
        (
            "frame,ms,q0,q1,q2,q3,note\n1,0,0,0,0,1,start\n2,500,0.6,0,0,0.8,\"a, b\"\n3,1000,0,0.8,0,0.6,\n",
            Mapping { time: Some("ms".into()), time_unit: TimeUnit::Millisecond, ..quaternion("q3 q0 q1 q2") },
        ),
        (
            "1.7e9,1,0,0,0\n1700000000.5,0.8,0.6,0,0\n1700000001,0.6,0,0.8,0\n",
            Mapping { time: Some("1".into()), ..by_number },
        ),
    ];
    for (text, mapping) in texts {
        let found = observed(text, &mapping).unwrap_or_else(|error| panic!("{text}: {error}"));
        let attitude = found.bodies[0].attitude.as_ref().expect("told");
        assert_eq!(attitude.times_s, [0.0, 0.5, 1.0], "{text}");
        assert_eq!(attitude.columns, [[1.0, 0.8, 0.6], [0.0, 0.6, 0.0], [0.0, 0.0, 0.8], [0.0; 3]], "{text}");
        let start = if text.starts_with("1.7e9") { 1_700_000_000_000_000_000 } else { 0 };
        assert_eq!(found.start_ns, start, "{text}");
    }
}

#[test]
fn units_axes_and_sense_are_as_the_mapping_says() {
    let body = BodyMapping {
        attitude_sense: Sense::BodyFromWorld,
        angular_velocity: names("p q r"),
        angular_velocity_axes: Some(Axes::Body),
        angular_velocity_unit: RateUnit::TurnPerMinute,
        ..quaternion("w x y z").body.remove(0)
    };
    let found =
        observed("time,w,x,y,z,p,q,r\n0,0.8,0.6,0,0,60,0,30\n", &Mapping { body: vec![body], ..Mapping::default() });
    let found = found.expect("told").bodies.remove(0);
    let attitude = found.attitude.expect("told");
    assert_eq!(attitude.columns.map(|column| column[0]), [0.8, -0.6, -0.0, -0.0]);
    let rates = found.angular_velocity.expect("told");
    assert_eq!(rates.columns.map(|column| column[0]), [std::f64::consts::TAU, 0.0, std::f64::consts::PI]);
    assert_eq!(rates.axes, Some(Axes::Body));
}

/// A turn about z by 90°, told in each of the forms.
#[test]
fn attitudes_in_every_form_are_the_same() {
    let quarter = (std::f64::consts::FRAC_PI_8).tan();
    let forms = [
        (BodyMapping { mrp: names("2 3 4"), ..BodyMapping::default() }, format!("0 0 0 {quarter}")),
        (BodyMapping { matrix: names("2 3 4 5 6 7 8 9 10"), ..BodyMapping::default() }, "0 0 -1 0 1 0 0 0 0 1".into()),
        (
            BodyMapping {
                matrix: names("2 3 4 5 6 7 8 9 10"),
                attitude_sense: Sense::BodyFromWorld,
                ..BodyMapping::default()
            },
            "0 0 1 0 -1 0 0 0 0 1".into(),
        ),
        (
            BodyMapping {
                euler_angles: names("2 3 4"),
                euler_sequence: Some("ZYX".into()),
                euler_unit: polhode::recording::foreign::AngleUnit::Degree,
                ..BodyMapping::default()
            },
            "0 90 0 0".into(),
        ),
    ];
    for (body, text) in forms {
        let mapping = Mapping { body: vec![body], time: Some("1".into()), ..Mapping::default() };
        let found = observed(&text, &mapping).unwrap_or_else(|error| panic!("{text}: {error}"));
        let attitude = found.bodies[0].attitude.as_ref().expect("told");
        for (column, expected) in attitude.columns.iter().zip([0.5_f64.sqrt(), 0.0, 0.0, 0.5_f64.sqrt()]) {
            assert!((column[0] - expected).abs() < 2.0 * f64::EPSILON, "{text}: {}", column[0]);
        }
    }
}

#[test]
fn what_is_not_clear_is_refused_with_its_place() {
    let default = Mapping::default();
    let cases = [
        ("t,q0,q1,q2,q3\n0,1,0,0,0\n", &default, "which of them is w?"),
        ("t,a,b\n0,1,0\n", &default, "a mapping has to name them"),
        ("qw,qx,qy,qz\n1,0,0,0\n", &default, "no column is called time_s or time or t"),
        ("t,qw,qx,qy,qz\n0,1,0,0\n", &default, "line 2 has 4 values in 5 columns"),
        ("t,qw,qx,qy,qz\n0,1,0,0,0\n\n0,1,0,0,0\n", &default, "line 4 is at 0 s, after one at 0 s"),
        ("t,qw,qx,qy,qz\n0,1,0,zero,0\n", &default, "line 2 has \"zero\" for a number in column 4"),
        ("t,qw,qx,qy,qz\n0,1,0,,0\n", &default, "line 2 has \"\" for a number in column 4"),
        ("t,qw,qx,qy,qz\n0,1,0,nan,0\n", &default, "line 2 has nan in column 4: not finite"),
        ("t,qw,qx,qy,qz\ninf,1,0,0,0\n", &default, "line 2 has \"inf\" for a time"),
        ("t;qw;qx;qy;qz\n0;1,0;0;0;0\n", &default, "line 2 has \"1,0\" for a number in column 2"),
        ("t,qw,qx,qy,qz\n0,\"1,0,0,0\n", &default, "line 2 has a quote that is not closed"),
        ("t,qw,qx,qy,qz\n", &default, "it has no line of numbers"),
        ("# nothing\n", &default, "it has no line of columns"),
        ("t,w,x,y,z\n0,1,0,0,0\n", &quaternion("w x y t"), "\"t\": that is the column of time"),
        ("t,w,w,y,z\n0,1,0,0,0\n", &quaternion("w x y z"), "quaternion names \"w\": there are several"),
        ("t,w,x,y,z\n0,1,0,0,0\n", &quaternion("w x y zz"), "\"zz\": the columns are t, w, x, y, z"),
        ("t,w,x,y,z\n0,1,0,0,0\n", &quaternion("w x y 6"), "\"6\": the columns are 1 to 5"),
    ];
    for (text, mapping, expected) in cases {
        let found = refusal(text, mapping);
        assert!(found.contains(expected) && found.contains("run.csv"), "{text}: {found}");
    }
}

/// A thousand tables, each damaged in one byte or cut: numbers or an error, never a panic.
#[test]
fn damaged_tables_do_no_harm() {
    let text = "# t qw qx qy qz\n1.7e9 1 0 0 0\n\"1700000001.25\" 0.8 .6 0 0\n1700000002 -1e-3 5E+1 0 0\n";
    for place in 0..text.len() {
        for byte in [b'"', b'\n', b'e', b'-', b'9', b',', 0xff] {
            let mut damaged = text.as_bytes().to_vec();
            damaged[place] = byte;
            let folder = tempdir().expect("a folder");
            let path = folder.path().join("run.txt");
            fs::write(&path, &damaged[..]).expect("room");
            if let Ok(found) = observe(&path, &Mapping::default()) {
                let attitude = found.bodies[0].attitude.as_ref().expect("columns");
                assert!(attitude.columns.iter().all(|column| column.len() == attitude.times_s.len()));
            }
            fs::write(&path, &damaged[..place]).expect("room");
            let _ = observe(&path, &Mapping::default());
        }
    }
}

#[cfg(feature = "serde")]
#[test]
fn a_mapping_is_read_from_toml_or_from_a_line() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("map.toml");
    let text = "time = \"t\"\n[[body]]\nquaternion = [\"w\", \"x\", \"y\", \"z\"]\nangular_velocity = [\"p\", \"q\", \"r\"]\n\
                angular_velocity_axes = \"body\"\nangular_velocity_unit = \"deg/s\"\n";
    fs::write(&path, text).expect("room");
    let line =
        "time=t, quaternion = w x y z,angular_velocity=p q r, angular_velocity_axes=body, angular_velocity_unit=deg/s";
    assert_eq!(Mapping::read(&path).expect("a mapping"), Mapping::of_columns(line).expect("a mapping"));
    fs::write(&path, text.replace("angular_velocity_axes", "axes")).expect("room");
    let refused = Mapping::read(&path).expect_err("an unknown key").to_string();
    assert!(refused.contains("unknown field `axes`") && refused.contains("line 5"), "{refused}");
    for (line, expected) in [
        ("quaternion=w x y", "invalid length 3"),
        ("time=t, time=u", "time is there twice"),
        ("quaternion", "no assignment"),
        ("omega=a b c", "unknown field `omega`"),
        ("angular_velocity_axes=earth", "unknown variant `earth`"),
    ] {
        let refused = Mapping::of_columns(line).expect_err("a refusal");
        assert!(refused.contains(expected), "{line}: {refused}");
    }
}
