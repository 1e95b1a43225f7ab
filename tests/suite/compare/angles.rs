use polhode::comparison::Comparison;
use polhode::scenario::Scenario;
use polhode::telemetry::Channel;
use tempfile::tempdir;

use super::{channel, compared, exact, plan, record, scene};

/// A phase of −π and one of π are one place on the polhode: on which side of the seam a rounding puts it says nothing.
#[test]
fn angles_apart_by_whole_turns_are_the_same() {
    let folder = tempdir().expect("a folder");
    let channels = ["polhode_phase", "figure_angles"].map(str::to_owned).to_vec();
    let a = record(&plan(&Scenario { channels: Some(channels.clone()), ..scene() }), &folder.path().join("a.csv"));
    let text = std::fs::read_to_string(&a).expect("there");
    let turned = |line: &str| {
        let mut values = line.split(',');
        let time = values.next().expect("a time").to_owned();
        let values = values.map(|value| (value.parse::<f64>().expect("a number") - std::f64::consts::TAU).to_string());
        std::iter::once(time).chain(values).collect::<Vec<_>>().join(",")
    };
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for line in lines.iter_mut().skip(1).step_by(3) {
        *line = turned(line);
    }
    let b = folder.path().join("b.csv");
    std::fs::write(&b, lines.join("\n") + "\n").expect("room");
    let report = compared(&Comparison::default(), &a, &b);
    assert!(report.is_same() && !report.is_same_to_the_bit(), "{}", report.verdict());
    assert!(channel(&report, Channel::PolhodePhase).worst_difference() < 2e-15);
    assert!(!compared(&exact(), &a, &b).is_same());
    // Interpolated across the seam as well: what is between samples is no jump of 2π.
    let other = Scenario { channels: Some(channels), sample_every_s: Some(0.011), ..scene() };
    let c = record(&plan(&other), &folder.path().join("c.csv"));
    let resampled = Comparison { is_resampled: true, ..Comparison::default() };
    let found = compared(&resampled, &b, &c);
    assert!(channel(&found, Channel::PolhodePhase).worst_difference() < 1e-6, "{}", found.verdict());
}
