//! Whether two motions are the same, and where, since when and by which law they differ.

mod angles;

use std::path::{Path, PathBuf};

use polhode::comparison::{
    CompareError, Comparison, Difference, Finding, Law, Report, Rule, Side, Tolerance, Tolerances,
};
use polhode::recording::Recorder;
use polhode::scenario::{BodySpec, EventKind, Method, MomentSpec, Plan, Scenario, TorqueSpecs};
use polhode::telemetry::Channel;
use tempfile::tempdir;

fn asymmetric() -> BodySpec {
    BodySpec {
        name: "stone".into(),
        principal_moments_kg_m2: Some([1.0, 2.0, 2.6]),
        angular_velocity_rad_s: Some([0.7, -0.4, 1.1]),
        ..BodySpec::default()
    }
}

fn scene() -> Scenario {
    Scenario {
        name: "stone".into(),
        duration_s: Some(90.0),
        sample_every_s: Some(0.01),
        body: vec![asymmetric()],
        ..Scenario::default()
    }
}

fn plan(scenario: &Scenario) -> Plan {
    Plan::new(scenario).expect("a plan")
}

fn record(plan: &Plan, path: &Path) -> PathBuf {
    let mut recorder = Recorder::create(plan, &[path], false).expect("a free name");
    let mut run = plan.start().expect("a motion");
    while let Some(samples) = run.next_batch().expect("finite states") {
        recorder.write(samples).expect("room");
    }
    recorder.finish().expect("room");
    path.into()
}

fn compared(comparison: &Comparison, a: &Path, b: &Path) -> Report {
    comparison.run(Side::open(a).expect("whole"), Side::open(b).expect("whole")).expect("times in common")
}

fn exact() -> Comparison {
    Comparison { tolerances: Tolerances::exact(), ..Comparison::default() }
}

fn within(channel: Channel, absolute: f64, relative: f64) -> Tolerances {
    Tolerances::default().with(channel, Rule::Within(Tolerance::new(absolute, relative).expect("a tolerance")))
}

fn channel(report: &Report, wanted: Channel) -> &polhode::comparison::ChannelReport {
    report.channels().find(|(_, channel)| channel.channel == wanted).expect("compared").1
}

#[test]
fn a_run_is_the_same_in_every_format_to_the_bit() {
    let folder = tempdir().expect("a folder");
    let formats = [
        "csv",
        #[cfg(feature = "mcap")]
        "mcap",
        #[cfg(feature = "rerun")]
        "rrd",
    ];
    let plan = plan(&scene());
    let paths = formats.map(|format| record(&plan, &folder.path().join(format!("stone.{format}"))));
    for (a, b) in paths.iter().flat_map(|a| paths.iter().map(move |b| (a, b))) {
        let report = compared(&exact(), a, b);
        assert!(report.is_same() && report.is_same_to_the_bit(), "{}", report.verdict());
        assert_eq!(report.common.samples, 9001);
        assert_eq!(report.verdict(), "same to the bit, at 9001 times");
    }
}

#[test]
fn one_ulp_is_found_with_its_place_and_time() {
    let folder = tempdir().expect("a folder");
    let a = record(&plan(&scene()), &folder.path().join("a.csv"));
    let text = std::fs::read_to_string(&a).expect("there");
    let header: Vec<_> = text.lines().next().expect("a header").split(',').collect();
    let column = header.iter().position(|name| *name == "angular_velocity_z_rad_s").expect("recorded");
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let mut values: Vec<String> = lines[4322].split(',').map(str::to_owned).collect();
    let value: f64 = values[column].parse().expect("a number");
    values[column] = value.next_up().to_string();
    lines[4322] = values.join(",");
    let b = folder.path().join("b.csv");
    std::fs::write(&b, lines.join("\n") + "\n").expect("room");

    let report = compared(&exact(), &a, &b);
    assert!(!report.is_same());
    let found = channel(&report, Channel::AngularVelocity);
    let first = found.bits.first.expect("a difference");
    assert_eq!((found.bits.differing, found.bits.most_ulps), (1, 1));
    assert_eq!((first.time_s, first.component, first.values), (4321.0 * 0.01, 2, [value, value.next_up()]));
    assert_eq!(report.channels().filter(|(_, channel)| channel.finding() != Finding::Same).count(), 1);
    assert_eq!(report.verdict(), "differs: angular_velocity of body has other bits from 43.21 s on, 1 ulp at most");
    // Far below what is different where nothing is said of bits.
    assert!(compared(&Comparison::default(), &a, &b).is_same());
}

#[test]
fn an_attitude_and_its_negative_are_the_same() {
    let folder = tempdir().expect("a folder");
    let plan = plan(&Scenario { channels: Some(vec!["attitude".into()]), ..scene() });
    let a = record(&plan, &folder.path().join("a.csv"));
    let text = std::fs::read_to_string(&a).expect("there");
    let negative = |line: &str| {
        let mut values = line.split(',');
        let time = values.next().expect("a time").to_owned();
        let values = values.map(|value| (-value.parse::<f64>().expect("a number")).to_string());
        std::iter::once(time).chain(values).collect::<Vec<_>>().join(",")
    };
    let lines = text.lines().enumerate().map(|(n, line)| if n > 2000 { negative(line) } else { line.to_owned() });
    let b = folder.path().join("b.csv");
    std::fs::write(&b, lines.collect::<Vec<_>>().join("\n") + "\n").expect("room");

    let strict = Comparison { tolerances: within(Channel::Attitude, 0.0, 0.0), ..Comparison::default() };
    let report = compared(&strict, &a, &b);
    assert!(report.is_same(), "{}", report.verdict());
    assert_eq!(channel(&report, Channel::Attitude).bits.differing, 9001 - 2000);
    assert!(!compared(&exact(), &a, &b).is_same(), "its bits are others");
}

#[test]
fn the_error_of_fixed_steps_grows_linearly_and_is_found_where_it_begins() {
    let folder = tempdir().expect("a folder");
    // Over many of the polhode's periods, within which the difference also swings.
    let long = Scenario { duration_s: Some(900.0), sample_every_s: Some(0.1), ..scene() };
    let stepped = Scenario { method: Method::Splitting2, step_s: Some(0.01), ..long.clone() };
    let a = record(&plan(&stepped), &folder.path().join("a.csv"));
    let exact = plan(&long);
    // A splitting keeps the invariants nearly, and turns at a slightly wrong rate.
    let report = Comparison::default().run(Side::open(&a).expect("whole"), Side::Scene(&exact)).expect("times");
    let attitude = channel(&report, Channel::Attitude);
    let growth = attitude.growth.expect("a law");
    let Law::Power { exponent } = growth.law else { panic!("{growth:?}") };
    assert!((exponent - 1.0).abs() < 0.1, "{growth:?}");
    // By hand, from the trace: of so few samples it holds each.
    assert!(!report.is_same());
    let first = attitude.first_out_s.expect("order 2 is worse than 1e-9 rad");
    let columns = |plan: &Plan, times: &[f64]| plan.bodies[0].sample(&[Channel::Attitude], times).expect("finite");
    let angle = |time: f64| {
        let [one, other] = [&plan(&stepped), &exact].map(|plan| columns(plan, &[time]));
        let value = |samples: &polhode::telemetry::BodySamples| -> [f64; 4] {
            let columns = samples.channel(Channel::Attitude).expect("asked for");
            std::array::from_fn(|k| columns[k][0])
        };
        polhode::propagation::attitude_angle(value(&one), value(&other))
    };
    assert!(angle(first) > 1e-9 && angle(first - 0.1) <= 1e-9, "{first} s");
    assert!(report.verdict().contains(" of stone leaves ") || report.verdict().contains(" of body leaves "));
}

#[test]
fn near_the_separatrix_a_difference_grows_exponentially_at_the_rate_of_the_middle_axis() {
    // Close to the middle axis a disturbance grows at ω₂ √((I₃−I₂)(I₂−I₁)/(I₁I₃)).
    let body = |offset: f64| BodySpec {
        principal_moments_kg_m2: Some([1.0, 2.0, 3.0]),
        angular_velocity_rad_s: Some([0.0, 5.0, offset]),
        ..BodySpec::default()
    };
    let scene = |offset: f64| plan(&Scenario { duration_s: Some(7.0), body: vec![body(offset)], ..scene() });
    let rate = 5.0 * (1.0 * 1.0 / (1.0 * 3.0_f64)).sqrt();
    let (a, b) = (scene(1e-12), scene(1e-12 + 1e-14));
    let report = Comparison::default().run(Side::Scene(&a), Side::Scene(&b)).expect("times in common");
    let growth = channel(&report, Channel::AngularVelocity).growth.expect("a law");
    let Law::Exponential { rate_per_s } = growth.law else { panic!("{growth:?}") };
    assert!((rate_per_s / rate - 1.0).abs() < 0.02, "{rate_per_s}, not {rate}");
}

#[test]
fn what_a_side_lacks_is_named() {
    let folder = tempdir().expect("a folder");
    let channels = |names: &[&str]| Some(names.iter().map(ToString::to_string).collect());
    let with = |names: &[&str], file: &str| {
        record(&plan(&Scenario { channels: channels(names), ..scene() }), &folder.path().join(file))
    };
    let a = with(&["attitude", "angular_velocity", "rotational_energy"], "a.csv");
    let b = with(&["attitude", "angular_velocity", "slip"], "b.csv");
    let report = compared(&Comparison::default(), &a, &b);
    let lone = |side: usize, channel| Difference::Channel { side, body: "body".into(), channel };
    assert_eq!(report.differences, [lone(0, Channel::RotationalEnergy), lone(1, Channel::Slip)]);
    assert!(!report.is_same() && report.is_same_to_the_bit());
    assert!(report.verdict().starts_with("differs: rotational_energy of body is in "), "{}", report.verdict());
    // Unless only what both have is asked for.
    let asked = Comparison { channels: vec![Channel::Attitude, Channel::AngularVelocity], ..Comparison::default() };
    assert!(compared(&asked, &a, &b).is_same());
    let none = Comparison { channels: vec![Channel::Tilt], ..Comparison::default() };
    let refused = none.run(Side::open(&a).expect("whole"), Side::open(&b).expect("whole"));
    assert!(matches!(refused, Err(CompareError::NothingInCommon { .. })));
}

#[test]
fn other_rates_meet_where_they_do_and_a_side_that_ends_early_differs() {
    let folder = tempdir().expect("a folder");
    let every = |seconds: f64, until: f64, file: &str| {
        let scene = Scenario { sample_every_s: Some(seconds), duration_s: Some(until), ..scene() };
        record(&plan(&scene), &folder.path().join(file))
    };
    let (fine, coarse) = (every(0.01, 90.0, "fine.csv"), every(0.03, 90.0, "coarse.csv"));
    let report = compared(&Comparison::default(), &fine, &coarse);
    assert!(report.is_same(), "{}", report.verdict());
    assert_eq!((report.common.samples, report.sides[0].alone.samples, report.sides[1].alone.samples), (3001, 6000, 0));
    // 3 · 0.01 and 0.03 are other numbers in the same ns.
    assert!(report.times_apart_s > 0.0 && report.times_apart_s < 1e-13, "{}", report.times_apart_s);
    assert_eq!(compared(&exact(), &fine, &coarse).differences, [Difference::Times { side: 0 }]);

    let short = every(0.01, 60.0, "short.csv");
    assert_eq!(compared(&Comparison::default(), &fine, &short).differences, [Difference::Span]);
    let window = Comparison { to_s: Some(60.0), ..Comparison::default() };
    assert!(compared(&window, &fine, &short).is_same());

    let odd = every(0.011_3, 90.0, "odd.csv");
    let seldom = compared(&Comparison::default(), &fine, &odd);
    assert!(seldom.is_same() && seldom.common.samples == 80, "{seldom:?}");
    let never = every(std::f64::consts::FRAC_1_PI, 90.0, "never.csv");
    let refused = Comparison::default().run(Side::open(&fine).expect("whole"), Side::open(&never).expect("whole"));
    let Err(error @ CompareError::NoCommonTimes { common: 1, .. }) = refused else { panic!("{refused:?}") };
    assert!(error.to_string().contains("--resample"), "{error}");
}

#[test]
fn a_scene_is_computed_at_the_times_of_a_recording() {
    let folder = tempdir().expect("a folder");
    let plan = plan(&scene());
    let a = record(&plan, &folder.path().join("a.csv"));
    for sides in [[0, 1], [1, 0]] {
        let side = |number: usize| if number == 0 { Side::open(&a).expect("whole") } else { Side::Scene(&plan) };
        let report = exact().run(side(sides[0]), side(sides[1])).expect("times in common");
        assert!(report.is_same(), "{}", report.verdict());
    }
    // Its clock put back by whole samples, with a scene that starts there.
    let shifted = Comparison { shift_s: -0.5, ..Comparison::default() };
    let report = shifted.run(Side::Scene(&plan), Side::Scene(&plan)).expect("times in common");
    assert!(!report.is_same());
    assert_eq!((report.sides[0].alone.samples, report.common.samples), (50, 9001 - 50));
}

#[test]
fn what_interpolation_makes_is_told_from_what_differs() {
    let folder = tempdir().expect("a folder");
    let every = |seconds: f64, rate: f64, file: &str| {
        let body = BodySpec { angular_velocity_rad_s: Some([0.7, -0.4, rate]), ..asymmetric() };
        let scene = Scenario { sample_every_s: Some(seconds), body: vec![body], ..scene() };
        record(&plan(&scene), &folder.path().join(file))
    };
    let resampled = |tolerances: Tolerances| Comparison { tolerances, is_resampled: true, ..Comparison::default() };
    let (a, b) = (every(0.01, 1.1, "a.csv"), every(0.011_3, 1.1, "b.csv"));
    let report = compared(&resampled(Tolerances::default()), &a, &b);
    // The last of A is after the last of B.
    assert!(report.common.samples > 8999 && report.sides[0].alone.samples <= 1, "{:?}", report.common);
    for (_, channel) in report.channels().filter(|(_, channel)| channel.rule != Rule::Shown) {
        let (error, worst) = (channel.interpolation.expect("interpolated"), channel.worst_difference());
        let name = channel.channel.row().name;
        // The same motion: what is between them is interpolation, and what is told of it covers it, not much larger.
        let rounding = 1e-14 * channel.size;
        assert!(worst <= error + rounding && error <= 10.0 * worst + rounding, "{name}: {worst} of {error}");
    }
    let all = |relative: f64| {
        let rule = Rule::Within(Tolerance::new(0.0, relative).expect("a tolerance"));
        let judged = Channel::ALL.into_iter().filter(|channel| Tolerances::default().of(*channel) != Rule::Shown);
        judged.fold(Tolerances::default(), |tolerances, channel| tolerances.with(channel, rule))
    };
    // Below what interpolation can tell nothing is said; above it they are the same.
    let report = compared(&resampled(all(1e-12)), &a, &b);
    assert_eq!(report.finding(), Finding::Undecided, "{}", report.verdict());
    assert!(report.verdict().starts_with("cannot tell: "), "{}", report.verdict());
    assert_eq!(compared(&resampled(all(1e-8)), &a, &b).finding(), Finding::Same);
    // A motion that is another by 1e-6 is told from it at once.
    let other = compared(&resampled(Tolerances::default()), &a, &every(0.011_3, 1.1 + 1e-6, "c.csv"));
    assert_eq!(other.finding(), Finding::Different);
    assert_eq!(channel(&other, Channel::AngularVelocity).first_out_s, Some(0.0));
}

#[test]
fn tolerances_are_said_in_words_and_in_files() {
    let default = Tolerances::default;
    let set =
        default().assign("angular_velocity=1e-12,1e-9").and_then(|set| set.assign("slip = exact")).expect("known");
    let rule = Rule::Within(Tolerance::new(1e-12, 1e-9).expect("a tolerance"));
    assert_eq!((set.of(Channel::AngularVelocity), set.of(Channel::Slip)), (rule, Rule::Exact));
    assert_eq!(set.of(Channel::Attitude), default().of(Channel::Attitude));
    for (assignment, message) in [
        ("angular_velocty=1", "\"angular_velocty\" is no channel; did you mean \"angular_velocity\"?"),
        ("attitude", "\"attitude\" is no tolerance: they read NAME=ABSOLUTE"),
        ("attitude=small", "\"attitude=small\" is no tolerance"),
        ("attitude=-1", "a tolerance of -1.0: it is a number from 0 on"),
        ("attitude=NaN", "a tolerance of NaN"),
        ("attitude=1,inf", "a tolerance of inf"),
    ] {
        let refused = default().assign(assignment).expect_err(assignment).to_string();
        assert!(refused.starts_with(message), "{refused}");
    }
}

#[cfg(feature = "serde")]
#[test]
fn files_of_tolerances_have_units_and_no_unknown_keys() {
    let parse = |text: &str| Tolerances::default().parse(text, "limits.toml");
    let text = "attitude_rad = 1e-6\nangular_velocity_rad_s = { absolute = 1e-12, relative = 1e-9 }\n\
                total_energy_j = { relative = 1e-12 }\ntilt_rad = \"exact\"\nenergy_drift_per_1e15 = 2\n";
    let set = parse(text).expect("good");
    let within = |absolute, relative| Rule::Within(Tolerance::new(absolute, relative).expect("a tolerance"));
    assert_eq!(set.of(Channel::Attitude), within(1e-6, 0.0));
    assert_eq!(set.of(Channel::AngularVelocity), within(1e-12, 1e-9));
    assert_eq!(set.of(Channel::TotalEnergy), within(0.0, 1e-12));
    assert_eq!(set.of(Channel::EnergyDrift), within(2.0, 0.0));
    assert_eq!(set.of(Channel::Tilt), Rule::Exact);
    for (text, message) in [
        ("\nattitude = 1e-6", "limits.toml:2:1: \"attitude\" is no channel; did you mean \"attitude_rad\"?"),
        ("tilt_rad = -1", "limits.toml:1:12: tilt_rad: a tolerance of -1.0: it is a number from 0 on"),
        ("tilt_rad = { absolut = 1 }", "limits.toml:1:12: tilt_rad: \"absolut\" is no key of a tolerance"),
        ("tilt_rad = {}", "limits.toml:1:12: tilt_rad: a tolerance is a number"),
        ("tilt_rad = \"large\"", "limits.toml:1:12: tilt_rad: \"large\": a tolerance is a number"),
        ("tilt_rad = ", "limits.toml:1:"),
    ] {
        let refused = parse(text).expect_err(text).to_string();
        assert!(refused.starts_with(message), "{refused}");
    }
}

#[test]
fn bodies_of_other_names_are_paired_where_that_is_said() {
    let pair = |names: [&str; 2]| {
        let bodies = names.map(|name| BodySpec { name: name.into(), ..asymmetric() });
        plan(&Scenario { duration_s: Some(1.0), body: bodies.to_vec(), ..scene() })
    };
    let (a, b) = (pair(["one", "two"]), pair(["two", "three"]));
    let run = |comparison: &Comparison| comparison.run(Side::Scene(&a), Side::Scene(&b));
    let report = run(&Comparison::default()).expect("one in common");
    let lone = |side, name: &str| Difference::Body { side, name: name.into() };
    assert_eq!(report.differences, [lone(0, "one"), lone(1, "three")]);
    let names = |b: &str| Comparison { names: vec![("one".into(), b.into())], ..Comparison::default() };
    let report = run(&names("three")).expect("both");
    assert!(report.is_same() && report.bodies.len() == 2, "{}", report.verdict());
    let refused = run(&names("thre")).expect_err("no such body").to_string();
    assert_eq!(refused, "stone has no body \"thre\": did you mean \"three\"?");
}

#[test]
fn loads_and_flips_at_other_times_are_named() {
    let pushed = |end: f64| {
        let push = MomentSpec { moment_n_m: [0.1, 0.0, 0.0], start_s: Some(1.0), end_s: Some(end) };
        let torque = TorqueSpecs { constant_body: vec![push], ..TorqueSpecs::default() };
        plan(&Scenario { duration_s: Some(4.0), body: vec![BodySpec { torque, ..asymmetric() }], ..scene() })
    };
    let (a, b) = (pushed(2.0), pushed(2.5));
    let report = Comparison::default().run(Side::Scene(&a), Side::Scene(&b)).expect("times in common");
    let [event] = report.events.as_slice() else { panic!("{:?}", report.events) };
    assert_eq!((event.kind, event.number, event.times_s), (EventKind::Load, 2, [Some(2.0), Some(2.5)]));
    // Until the earlier end nothing differs; there the moment does, as a window ends before its end.
    assert_eq!(report.channels().filter_map(|(_, channel)| channel.first_out_s).reduce(f64::min), Some(2.0));

    let flipping = |offset: f64| {
        let body = BodySpec { angular_velocity_rad_s: Some([0.0, 5.0, offset]), ..asymmetric() };
        plan(&Scenario { duration_s: Some(20.0), body: vec![body], ..scene() })
    };
    let (a, b) = (flipping(1e-3), flipping(1e-4));
    let report = Comparison::default().run(Side::Scene(&a), Side::Scene(&b)).expect("times in common");
    let first = report.events.first().expect("flips");
    let [Some(early), Some(late)] = first.times_s else { panic!("{first:?}") };
    assert!(first.kind == EventKind::Flip && early < late, "{first:?}");
    assert_eq!(Comparison::default().run(Side::Scene(&a), Side::Scene(&a)).expect("the same").events, []);
}

#[test]
fn a_number_against_none_is_a_difference_and_the_same_bits_are_none() {
    let folder = tempdir().expect("a folder");
    let write = |file: &str, value: &str| {
        let path = folder.path().join(file);
        let text = format!("time_s,rotational_energy_j\n0,1\n0.5,{value}\n1,1\n");
        std::fs::write(&path, text).expect("room");
        path
    };
    let (one, none, endless) = (write("one.csv", "1"), write("none.csv", "NaN"), write("endless.csv", "inf"));
    for (a, b) in [(&one, &none), (&one, &endless), (&none, &endless)] {
        let report = compared(&Comparison::default(), a, b);
        let energy = channel(&report, Channel::RotationalEnergy);
        assert_eq!((energy.first_out_s, energy.worst_difference()), (Some(0.5), f64::INFINITY));
    }
    assert!(compared(&Comparison::default(), &none, &none).is_same());
    assert!(compared(&exact(), &endless, &endless).is_same());
}
