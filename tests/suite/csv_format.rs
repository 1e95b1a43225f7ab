//! `.csv`: a header with units, and numbers that read back to the bit.

use std::fs;
use std::path::Path;

use polhode::recording::csv_file::CsvFile;
use polhode::recording::{PartFile, Recording, Sink, Subject, contents};
use polhode::scenario::Plan;
use polhode::telemetry::Channel;
use tempfile::tempdir;

use crate::planned::{assert_same_samples, bits, plan, samples, single};

fn record(plan: &Plan, path: &Path) -> String {
    let file = PartFile::create(path, true).expect("a name");
    let mut sink = CsvFile::create(&Subject::of(plan), file).expect("room");
    for samples in samples(plan, 512) {
        sink.write(&samples).expect("room");
    }
    Box::new(sink).finish().expect("room").publish().expect("a name");
    fs::read_to_string(path).expect("text")
}

#[test]
fn numbers_read_back_to_the_bit() {
    let folder = tempdir().expect("a folder");
    let plan = plan(2000);
    let text = record(&plan, &folder.path().join("pair.csv"));
    let samples = &samples(&plan, 2000)[0];
    for (index, line) in text.lines().skip(1).enumerate() {
        let numbers: Vec<f64> = line.split(',').map(|number| number.parse().expect("a number")).collect();
        let mut expected = vec![samples.times_s[index].to_bits()];
        expected.extend(samples.bodies.iter().flat_map(|body| bits(body, index)));
        assert_eq!(numbers.into_iter().map(f64::to_bits).collect::<Vec<_>>(), expected, "line {}", index + 2);
    }
    assert_eq!(text.lines().count(), 2001);
}

#[test]
fn a_recording_gives_back_what_was_recorded() {
    let folder = tempdir().expect("a folder");
    for plan in [plan(20_000), single(3)] {
        let path = folder.path().join("run.csv");
        record(&plan, &path);
        let recording = Recording::open(&path).expect("whole");
        let bodies = recording.heading().bodies.iter().map(|body| (body.name.clone(), body.channels.clone()));
        let name = |name: &str| if plan.bodies.len() > 1 { name.to_owned() } else { "body".to_owned() };
        let expected = plan.bodies.iter().map(|body| (name(&body.name), body.channels.clone()));
        assert_eq!(bodies.collect::<Vec<_>>(), expected.collect::<Vec<_>>());
        assert_same_samples(recording, &plan);
    }
}

#[test]
fn columns_are_named_with_units() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("run.csv");
    let mut plan = plan(3);
    let text = record(&plan, &path);
    assert!(text.starts_with("time_s,upper.attitude_w,upper.attitude_x,"), "{text}");
    assert!(text.lines().next().is_some_and(|header| header.ends_with("lower.rotational_energy_j")), "{text}");
    plan.bodies.remove(0);
    plan.bodies[0].channels = vec![Channel::AngularVelocity];
    let text = record(&plan, &path);
    let header = "time_s,angular_velocity_x_rad_s,angular_velocity_y_rad_s,angular_velocity_z_rad_s\n";
    assert!(text.starts_with(header), "{text}");
}

#[test]
fn contents_count_the_lines() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("one.csv");
    record(&single(1500), &path);
    let contents = contents(&path).expect("a csv");
    assert_eq!(contents.format, "csv");
    let first = &contents.entries[1];
    assert_eq!((first.name.as_str(), first.count), ("attitude_w", 1500));
    assert_eq!((first.from_s, first.to_s), (Some(0.0), Some(1.499)));
}

#[test]
fn what_is_no_recording_is_refused_with_its_line() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("bad.csv");
    let refusal = |text: &[u8]| {
        fs::write(&path, text).expect("room");
        contents(&path).expect_err("not a recording").to_string()
    };
    for (text, reason) in [
        (&b""[..], "there is no first line"),
        (b"a,b\n1,2\n", "the first column is \"a\""),
        (b"time_s,b\n1,2\n", "column 2, \"b\", begins no channel"),
        (b"time_s,total_energy_j,total_energy_j\n", "column 3, \"total_energy_j\", is there twice"),
        (b"time_s,position_x_m,position_z_m\n", "\"position_y_m\" of the same body is missing"),
        (
            b"time_s,a.total_energy_j,b.total_energy_j,a.energy_drift_per_1e15\n",
            "the columns of a body stand side by side",
        ),
        (b"time_s,total_energy_j\n1,2\n3\n", "line 3 has 1 values in 2 columns"),
        (b"time_s,total_energy_j\n1,2,3\n", "line 2 has 3 values in 2 columns"),
        (b"time_s,total_energy_j\n1,x\n", "line 2 has \"x\" for a number"),
        (b"time_s,total_energy_j\n1,2", "line 2 is cut off"),
        (b"time_s,total_energy_j\n\xff\n", "line 2 is not text"),
        (b"time_s,total_energy_j\n1,2\n1,2\n", "sample 1 is at 1 s, after one at 1 s"),
        (b"time_s,total_energy_j\n-1,2\n", "times are from 0"),
        (b"time_s,total_energy_j\nNaN,2\n", "times are from 0"),
    ] {
        assert!(refusal(text).contains(reason), "{reason}: {}", refusal(text));
    }
}
