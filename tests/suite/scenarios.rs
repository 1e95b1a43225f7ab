//! The scenes that come with the program: complete, honest about their sources, and true to the numbers they promise.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path as FilePath;

use polhode::propagation::FixedStepMethod;
use polhode::scenario::{Path, Plan, Scenario, library};
use polhode::study::certify;
use polhode::telemetry::Channel;

/// More than this takes long to record and to load.
const MOST_SAMPLES: u64 = 100_000;

/// Two roundings of ω and two of the attitude each way, 1e-15.
const MOST_SLIP: f64 = 9.0;

fn plan(name: &str) -> Plan {
    let scenario = Scenario::named(name, &[]).unwrap_or_else(|error| panic!("{name}: {error}"));
    Plan::new(&scenario).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn library_holds_every_file_of_the_folder_and_no_other() {
    let folder = FilePath::new(env!("CARGO_MANIFEST_DIR")).join("scenarios");
    let files: BTreeSet<String> = fs::read_dir(folder)
        .expect("the folder of scenes")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned())
        .collect();
    let names: Vec<String> = library::names().map(str::to_owned).collect();
    assert!(names.is_sorted(), "{names:?}");
    assert_eq!(names.into_iter().collect::<BTreeSet<_>>(), files);
}

#[test]
fn scenes_say_what_they_show_and_where_it_comes_from() {
    for name in library::names() {
        let text = library::text(name).expect("a scene of that name");
        assert!(text.starts_with("# "), "{name}: the first line says what to see");
        let plan = plan(name);
        let title = plan.title.chars().count();
        assert!((1..=60).contains(&title) && plan.title != name, "{name}: title of {title} letters");
        assert!(plan.summary.split_whitespace().count() >= 20, "{name}: summary");
        let provenance = &plan.provenance;
        assert!(!provenance.source.is_empty() && !provenance.note.is_empty(), "{name}: provenance");
        assert!(provenance.url.starts_with("https://"), "{name}: {}", provenance.url);
        assert!(plan.grid.len() <= MOST_SAMPLES, "{name}: {} samples", plan.grid.len());
        assert!(plan.checks.len() >= 3, "{name}: {} checks", plan.checks.len());
    }
}

/// An ulp or two of each of attitude, ω and I⁻¹L: slender bodies turn the most of them into slip.
#[test]
fn energy_ellipsoids_of_free_bodies_roll_without_slipping() {
    let mut rolling = 0;
    for name in library::names() {
        let plan = plan(name);
        let times: Vec<f64> = (0..=200).map(|part| plan.grid.end() * f64::from(part) / 200.0).collect();
        for body in plan.bodies.iter().filter(|body| body.problem.loads.is_empty()) {
            let samples = body.sample(&[Channel::Slip], &times).unwrap_or_else(|error| panic!("{name}: {error}"));
            let slips = &samples.channel(Channel::Slip).expect("watched")[0];
            let largest = slips.iter().copied().fold(0.0, f64::max);
            assert!(largest <= MOST_SLIP, "{name}: {}: {largest} × 1e-15", body.name);
            rolling += 1;
        }
    }
    assert!(rolling >= 9, "{rolling} bodies");
}

#[test]
fn scenes_pass_their_own_checks() {
    let mut failed = Vec::new();
    for name in library::names() {
        for outcome in plan(name).measure_checks().unwrap_or_else(|error| panic!("{name}: {error}")) {
            let (expected, measured, tolerance) = (outcome.expected, outcome.measured, outcome.tolerance);
            let line = format!(
                "{name}: {}: measured {measured:?}, expected {expected:?}, {:.1e} apart, {tolerance:.0e} allowed",
                outcome.name,
                measured - expected
            );
            println!("{line}");
            if !outcome.passed {
                failed.push(line);
            }
        }
    }
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}

#[test]
fn bodies_take_a_closed_form_where_one_is_known_and_taylor_series_elsewhere() {
    for name in library::names() {
        for body in plan(name).bodies {
            let is_as_expected = match body.path {
                Path::ClosedForm => body.problem.loads.is_empty(),
                Path::LagrangeTop => ["compass_needle", "lagrange_top", "sleeping_top"].contains(&name),
                Path::AxialTorque => name == "spin_up",
                Path::MomentumBrake => name == "momentum_brake",
                Path::Taylor { .. } => {
                    let is_solved =
                        ["compass_needle", "lagrange_top", "momentum_brake", "sleeping_top", "spin_up"].contains(&name);
                    !is_solved && !body.problem.loads.is_empty()
                }
                _ => false,
            };
            assert!(is_as_expected, "{name}: {} by {}", body.name, body.path.name());
        }
    }
}

#[test]
fn brakes_take_a_closed_form_unless_they_have_a_window() {
    let scene = |window: &str| {
        let text = format!(
            "duration_s = 1.0\nsample_every_s = 0.1\n[[body]]\nprincipal_moments_kg_m2 = [1.0, 2.0, 2.5]\n\
             angular_velocity_rad_s = [0.1, 5.0, 0.1]\n[[body.torque.momentum_brake]]\nrate_per_s = 0.1\n{window}"
        );
        let scenario = Scenario::parse(&text, "brake.toml", &[]).expect("a scene");
        Plan::new(&scenario).expect("a plan").bodies.remove(0)
    };
    assert_eq!(scene("").path, Path::MomentumBrake);
    assert!(matches!(scene("end_s = 0.5").path, Path::Taylor { .. }));
}

#[test]
fn scenes_run_to_their_last_sample() {
    for name in library::names() {
        let plan = plan(name);
        let mut run = plan.start().unwrap_or_else(|error| panic!("{name}: {error}"));
        let (mut count, mut last) = (0, f64::NAN);
        while let Some(samples) = run.next_batch().unwrap_or_else(|error| panic!("{name}: {error}")) {
            count += samples.len() as u64;
            last = *samples.times_s.last().expect("a batch is not empty");
        }
        assert_eq!(count, plan.grid.len(), "{name}");
        assert_eq!(last.to_bits(), plan.grid.end().to_bits(), "{name}");
    }
}

/// The names of the table are those of the scene language.
#[test]
fn every_method_with_a_fixed_step_can_be_asked_for() {
    let text = library::text("dzhanibekov").expect("the scene");
    for method in FixedStepMethod::ALL {
        let name = method.information().name;
        let overrides = [format!("method={name}"), "step_s=0.001".to_owned()];
        let scenario = Scenario::parse(text, "dzhanibekov", &overrides).expect(name);
        let body = &Plan::new(&scenario).expect(name).bodies[0];
        assert_eq!(body.path, Path::FixedStep { method, step: 0.001 });
        assert!(body.propagator().is_ok(), "{name}");
    }
}

#[test]
fn any_key_can_be_overridden() {
    let text = library::text("dzhanibekov").expect("the scene");
    let overrides =
        ["duration_s=2", "method=rk4", "step_s=0.001", "body.0.angular_velocity_rad_s=[0, 0.5, 6]"].map(str::to_owned);
    let scenario = Scenario::parse(text, "dzhanibekov", &overrides).expect("a scene with overrides");
    assert_eq!(scenario.duration_s, Some(2.0));
    assert_eq!(scenario.body[0].angular_velocity_rad_s, Some([0.0, 0.5, 6.0]));
    let plan = Plan::new(&scenario).expect("a plan");
    assert!(matches!(plan.bodies[0].path, Path::FixedStep { method: FixedStepMethod::Rk4, .. }));
    assert_eq!(plan.grid.len(), 401);

    let overrides = ["body.0.angular_velocity=[0, 0.5, 6]".to_owned()];
    let message = Scenario::parse(text, "dzhanibekov", &overrides).expect_err("no such key").to_string();
    assert!(message.contains("dzhanibekov (with --set)") && message.contains("angular_velocity"), "{message}");
}

#[test]
fn examples_of_the_manual_are_scenes_that_pass_their_checks() {
    let manual = fs::read_to_string(FilePath::new(env!("CARGO_MANIFEST_DIR")).join("docs/scenarios.md"))
        .expect("the manual of scenes");
    let examples: Vec<&str> = manual.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    assert!(examples.len() >= 5, "{} examples", examples.len());
    for example in examples {
        let scenario = Scenario::parse(example, "docs/scenarios.md", &[]).unwrap_or_else(|error| panic!("{error}"));
        // The mesh of the example is the reader's own.
        if scenario.body.iter().any(|body| body.mesh.is_some()) {
            continue;
        }
        let plan = Plan::new(&scenario).unwrap_or_else(|error| panic!("{error}"));
        for outcome in plan.measure_checks().expect("checks that can be measured") {
            assert!(outcome.passed, "{}: {} {}", outcome.name, outcome.measured, outcome.expected);
        }
    }
}

/// Of attitude, rad, and of ω and L, relative: the steppers' roundings over a whole scene.
const CERTIFIED: f64 = 2e-14;
/// The same where a swing all but reaches upright, again and again, and of a top that comes near motions which are not
/// stable: there a rounding of the start grows a thousandfold.
const CERTIFIED_NEAR_UPRIGHT: f64 = 2e-13;
/// The same under controllers that switch hundreds of times, and leave a spin that goes on for a hundred turns.
const CERTIFIED_UNDER_CONTROL: f64 = 1e-13;
/// Where a cord grows taut with a jerk, again and again: each multiplies what roundings did.
const CERTIFIED_JERKED: f64 = 1e-12;
/// Some hundred times as many turns as the reference can follow: its certificate must say that it does not reach.
const BEYOND_REACH: &str = "gravity_probe_b";
/// Of position, m, where distances are metres: so much of what is allowed to the attitude.
const CERTIFIED_M: f64 = 0.1;

#[test]
fn every_scene_is_certified_to_rounding_to_its_end() {
    for name in library::names() {
        let plan = plan(name);
        let certificates = certify(&plan).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(certificates.len(), plan.bodies.len(), "{name}");
        for (body, certificate) in plan.bodies.iter().zip(certificates) {
            println!("{name}, {}: {certificate:?}", body.name);
            assert_eq!(certificate.is_whole, name != BEYOND_REACH, "{name}: {certificate:?}");
            if !certificate.is_whole {
                continue;
            }
            let relative = [
                certificate.attitude_rad,
                Some(certificate.angular_velocity_relative),
                certificate.angular_momentum_relative,
            ];
            let is_touchy = ["swing_85", "pitch_85", "cross"].contains(&body.name.as_str());
            let limit = match name {
                _ if plan.tolerance_rad.is_some() => plan.tolerance_rad.unwrap_or_default(),
                _ if is_touchy => CERTIFIED_NEAR_UPRIGHT,
                "tether" => CERTIFIED_JERKED,
                "detumbling" => CERTIFIED_UNDER_CONTROL,
                _ => CERTIFIED,
            };
            assert!(relative.iter().flatten().all(|error| *error < limit), "{name}, {}: {certificate:?}", body.name);
            assert!(
                certificate.position_m.is_none_or(|error| error < CERTIFIED_M * limit),
                "{name}, {}: {certificate:?}",
                body.name
            );
            assert_eq!(certificate.position_m.is_some(), body.problem.wants_translation, "{name}");
            assert!(certificate.reference_uncertainty < 1e-18, "{name}: {certificate:?}");
            assert!((0.0..=certificate.covered_to_s).contains(&certificate.worst_at_s), "{name}: {certificate:?}");
            assert_eq!(certificate.covered_to_s.to_bits(), plan.grid.end().to_bits(), "{name}");
            assert_eq!(certificate.method, body.path.name(), "{name}");
            assert_eq!(certificate.reference, "Taylor series in double-double", "{name}");
            assert!(certificate.keeps(plan.tolerance_rad.unwrap_or(limit.max(1e-13))), "{name}: {certificate:?}");
        }
    }
}

/// A table says the same from a file as from the scene, and another table under the same name is told from it.
#[test]
fn tables_come_from_files_or_from_the_scene() {
    let folder = tempfile::tempdir().expect("a folder");
    let head = "duration_s = 3\nsample_every_s = 0.5\n[[body]]\nprincipal_moments_kg_m2 = [1, 2, 2.5]\n\
                [[body.torque.table]]\nframe = \"body\"\ninterpolation = \"cubic\"\nafter = \"hold\"\n";
    let scene = |table: &str| {
        let path = folder.path().join("scene.toml");
        fs::write(&path, format!("{head}{table}")).expect("written");
        Plan::new(&Scenario::read(&path, &[]).expect("a scene")).expect("a plan")
    };
    let file = |last: &str| {
        let text =
            format!("\u{feff}# Measured.\r\ntime_s, x, y, z\r\n0.5, 0, 0, 1e-1\r\n\r\n1, 0, 0.5, 2\r\n2,0,{last},1");
        fs::write(folder.path().join("table.csv"), text).expect("written");
        scene("file = \"table.csv\"\n")
    };
    let from_file = file("0.25");
    let from_rows = scene("rows = [[0.5, 0, 0, 0.1], [1, 0, 0.5, 2], [2, 0, 0.25, 1]]\n");
    assert_eq!(from_file.bodies[0].problem, from_rows.bodies[0].problem);
    assert_ne!(file("0.125").identity, from_file.identity);
    assert_eq!(file("0.25").identity, from_file.identity);
}

/// At the start, L means that of body and rotors, as recordings have it.
#[test]
fn momentum_at_the_start_is_that_of_body_and_rotors() {
    let text = "duration_s = 3\nsample_every_s = 0.5\n[[body]]\nprincipal_moments_kg_m2 = [1, 2, 2.5]\n\
                angular_momentum_n_m_s = [0.5, -1, 2]\n[[body.rotor]]\naxis = [0, 0, 1]\nmomentum_n_m_s = 0.75\n";
    let plan = Plan::new(&Scenario::parse(text, "gyrostat.toml", &[]).expect("a scene")).expect("a plan");
    let samples = plan.bodies[0].sample(&[Channel::AngularVelocity, Channel::AngularMomentumBody], &[0.0]);
    let samples = samples.expect("a finite motion");
    let first: Vec<f64> = samples.columns().iter().map(|column| column[0]).collect();
    assert_eq!(first, [0.5, -0.5, 0.5, 0.5, -1.0, 2.0]);
}

/// The edges of pulses are events, and a rotor's are not.
#[test]
fn pulses_are_on_the_log() {
    let text = "duration_s = 3\nsample_every_s = 0.5\n[[body]]\nmass_kg = 2\nprincipal_moments_kg_m2 = [1, 2, 2.5]\n\
                [[body.rotor]]\naxis = [0, 0, 1]\ntimes_s = [0.5, 1]\nmomenta_n_m_s = [0, 1]\n\
                [[body.force.thruster]]\ndirection = [0, 1, 0]\nthrust_n = 2\npoint_m = [0.5, 0, 0]\n\
                period_s = 0.75\nduty = 0.25\nstart_s = 0.25\nend_s = 2.0\n";
    let plan = Plan::new(&Scenario::parse(text, "pulses.toml", &[]).expect("a scene")).expect("a plan");
    let times: Vec<f64> = plan.events.iter().map(|event| event.time_s).collect();
    assert_eq!(times, [0.25, 0.4375, 1.0, 1.1875, 1.75, 1.9375, 2.0]);
}

/// Of a force at the centre of mass, the integral of the table over the mass.
#[test]
fn a_force_by_a_table_moves_the_body() {
    for (frame, at_start) in [("world", [0.0, 0.0, 1.0]), ("body", [0.0, 0.0, -1.0])] {
        let text = format!(
            "duration_s = 3\nsample_every_s = 0.5\n[[body]]\nmass_kg = 4\nprincipal_moments_kg_m2 = [1, 2, 2.5]\n\
             attitude = [0, 1, 0, 0]\n[[body.force.table]]\nframe = \"{frame}\"\npoint_m = [0, 0, 0]\n\
             rows = [[0.5, 0, 0, 0], [1.5, 0, 0, 8], [2.5, 0, 0, 0]]\n"
        );
        let plan = Plan::new(&Scenario::parse(&text, "force.toml", &[]).expect("a scene")).expect("a plan");
        let samples = plan.bodies[0].sample(&[Channel::Velocity], &[1.5, 3.0]).expect("a finite motion");
        let velocity = |row: usize| [0, 1, 2].map(|axis: usize| samples.columns()[axis][row]);
        assert_eq!(velocity(0), at_start, "{frame}");
        assert_eq!(velocity(1), at_start.map(|component| 2.0 * component), "{frame}");
    }
}
