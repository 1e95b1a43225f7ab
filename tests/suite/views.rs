//! What people are shown: flips at their exact times, axes that lean, pictures as often as the eye needs them.

use polhode::dynamics::Problem;
use polhode::propagation::FreeRotation;
use polhode::recording::picture::Picture;
use polhode::scenario::{EventKind, Plan, Scenario, library};
use polhode::telemetry::Channel;
use std::f64::consts::{PI, TAU};

fn plan(name: &str) -> Plan {
    Plan::new(&Scenario::named(name, &[]).expect("a scene of the library")).expect("it plans")
}

fn flips(plan: &Plan, body: usize) -> Vec<f64> {
    let flips = plan.events.iter().filter(|event| event.body == body && event.kind == EventKind::Flip);
    flips.map(|event| event.time_s).collect()
}

/// ω along the middle axis is steepest where it is zero: a time that is off by an ulp shows in it by as much.
#[test]
fn at_a_flip_the_spin_about_the_middle_axis_is_zero() {
    for (name, component, period) in
        [("dzhanibekov", 2, 17.447_952_691_173_37), ("tennis_racket", 1, 3.676_300_508_550_02)]
    {
        let plan = plan(name);
        let times = flips(&plan, 0);
        assert!(times.len() >= 4, "{name}: {times:?}");
        let rates = plan.bodies[0].sample(&[Channel::AngularVelocity], &times).expect("it propagates");
        let largest = plan.bodies[0].problem.initial.angular_velocity.in_body().amax();
        for (time, rate) in times.iter().zip(&rates.columns()[component]) {
            let turned = largest * largest * time * 2.0 * f64::EPSILON;
            assert!(rate.abs() < turned.max(1e-14), "{name} at {time}: {rate:e}");
        }
        for pair in times.windows(3) {
            assert!((pair[2] - pair[0] - period).abs() < 1e-13 * period, "{name}: {pair:?}");
        }
    }
}

/// About the other two axes ω along the middle one changes sign as well, but nothing turns over.
#[test]
fn only_a_spin_about_the_middle_axis_flips() {
    let plan = plan("dzhanibekov_three_axes");
    let counts = [0, 1, 2].map(|body| flips(&plan, body).len());
    assert_eq!(counts, [0, 4, 0]);
    let crosses = |problem: &Problem| FreeRotation::reversals(problem).expect("free").is_some();
    assert!(plan.bodies.iter().all(|body| crosses(&body.problem)));
}

/// The wobble of a free symmetric body is regular: its axis leans by acos(L₃/|L|) and goes round at |L|/I₁.
#[test]
fn a_free_symmetric_body_leans_and_goes_round_evenly() {
    for name in ["feynman_plate", "free_precession_oblate", "free_precession_prolate", "earth_euler"] {
        let plan = plan(name);
        let body = &plan.bodies[0];
        assert!(body.channels.contains(&Channel::Tilt), "{name}");
        let moments = body.properties.moments.vector();
        let momentum = body.problem.initial.angular_velocity.in_body().component_mul(&moments);
        let (tilt, rate) = (libm::acos(momentum.z / momentum.norm()), momentum.norm() / moments.x);
        let times: Vec<_> = (0..100).map(|look| plan.grid.end() * f64::from(look) / 99.0).collect();
        let samples = body.sample(&[Channel::Tilt, Channel::PrecessionRate], &times).expect("it propagates");
        let [tilts, rates] = samples.columns() else { panic!("two scalars") };
        assert!(tilts.iter().all(|found| (found - tilt).abs() < 4e-15), "{name}: {tilts:?}, not {tilt}");
        assert!(rates.iter().all(|found| (found / rate - 1.0).abs() < 4e-15), "{name}: {rates:?}, not {rate}");
    }
}

/// Four tops with one spin: their precession is steady, turns back, just stops, and is uneven.
#[test]
fn tops_go_round_as_their_names_say() {
    let plan = plan("lagrange_top");
    let times: Vec<_> = (0..2000).map(|look| 5.0 * f64::from(look) / 1999.0).collect();
    let ranges = plan.bodies.iter().map(|body| {
        let samples = body.sample(&[Channel::Tilt, Channel::PrecessionRate], &times).expect("it propagates");
        let columns = samples.columns();
        assert!((columns[0][0] - PI / 6.0).abs() < 1e-15, "{}: they lean by 30° at first", body.name);
        let least = columns[1].iter().copied().fold(f64::INFINITY, f64::min);
        let most = columns[1].iter().copied().fold(f64::NEG_INFINITY, f64::max);
        (least, most)
    });
    let [steady, looping, cusped, wavy] = ranges.collect::<Vec<_>>().try_into().expect("four tops");
    assert!(steady.1 - steady.0 < 1e-13 && (steady.0 - 3.112_950_499_310_956).abs() < 1e-13, "{steady:?}");
    assert!(looping.0 < -1.0 && looping.1 > 1.0, "{looping:?}");
    assert!(cusped.0.abs() < 1e-2 && cusped.1 > 1.0, "{cusped:?}");
    assert!(wavy.0 > 0.1 && wavy.1 > wavy.0 + 1.0, "{wavy:?}");
}

/// The boom that is let go 30° from the vertical swings to 30° on the other side, and through it.
#[test]
fn in_orbit_the_tilt_is_that_of_the_boom_from_the_vertical() {
    let plan = plan("gravity_gradient");
    let times: Vec<_> = (0..2000).map(|look| plan.grid.end() * f64::from(look) / 1999.0).collect();
    for (body, degrees) in plan.bodies.iter().zip([0.0, 30.0, 85.0_f64]) {
        let samples = body.sample(&[Channel::Tilt], &times).expect("it propagates");
        let largest = samples.columns()[0].iter().copied().fold(0.0, f64::max);
        assert!((largest - degrees.to_radians()).abs() < 1e-4, "{}: {largest}", body.name);
        assert!(!body.channels.contains(&Channel::PrecessionRate), "the vertical turns itself");
    }
}

/// At most 60 pictures in a second of playback, and a turn of the fastest body in 24 or more of them.
#[test]
fn pictures_are_as_many_as_the_eye_and_the_fastest_turn_need() {
    for name in library::names() {
        let plan = plan(name);
        let picture = Picture::of(&plan).expect("it propagates");
        let interval = plan.grid.mean_interval();
        let apart = interval * f64::from(u32::try_from(picture.stride).expect("few"));
        let times: Vec<_> = (0..=400).map(|look| plan.grid.end() * f64::from(look) / 400.0).collect();
        let rates = plan.bodies.iter().flat_map(|body| {
            let samples = body.sample(&[Channel::AngularVelocity], &times).expect("it propagates");
            let [x, y, z] = samples.columns() else { panic!("a vector") };
            let size = |index: usize| libm::sqrt(x[index] * x[index] + y[index] * y[index] + z[index] * z[index]);
            (0..times.len()).map(size).collect::<Vec<_>>()
        });
        let fastest = rates.fold(0.0, f64::max);
        // Where the samples themselves are fewer, all of them are drawn.
        let follows = apart * fastest <= TAU / 24.0 * (1.0 + 1e-3) || picture.stride == 1;
        assert!(follows, "{name}: {} turns from picture to picture", apart * fastest / TAU);
        let per_second = picture.playback_speed / apart;
        let needs_more = (apart + interval) * fastest > TAU / 24.0 * (1.0 - 1e-3);
        assert!(per_second <= 60.0 * (1.0 + 1e-9) || needs_more, "{name}: {per_second} pictures in a second");
    }
}

/// What the checks have found is told once each, when the check looks, and a failed one is told as such.
#[test]
fn outcomes_join_the_events() {
    let plan = plan("dzhanibekov");
    let before = plan.events.len();
    let mut outcomes = plan.measure_checks().expect("it propagates");
    outcomes[3].passed = false;
    let plan = plan.with_outcomes(outcomes);
    assert_eq!(plan.events.len(), before + plan.checks.len());
    assert!(plan.events.is_sorted_by(|a, b| a.time_s <= b.time_s));
    let failed: Vec<_> = plan.events.iter().filter(|event| event.kind == EventKind::Failed).collect();
    assert_eq!(failed.len(), 1);
    assert_eq!(failed[0].time_s, 8.723_976_345_586_683);
    assert!(failed[0].text.ends_with("FAILED"), "{}", failed[0].text);
}
