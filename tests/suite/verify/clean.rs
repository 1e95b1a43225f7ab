use polhode::body::AngularVelocity;
use polhode::comparison::verify::Verdict;
use polhode::recording::{Axes, Track};
use polhode::scenario::{MomentSpec, Plan, Scenario, TorqueSpecs, library};
use polhode::telemetry::Channel;

use super::engine::{book, causes, evenly, exact, single, verified};

fn assert_clean(what: &str, found: &polhode::comparison::verify::Verification) {
    assert_eq!(found.verdict, Verdict::Clean, "{what}: {:?} {:?}", found.reasons, found.causes);
    assert!(causes(found).is_empty(), "{what}: {:?}", found.causes);
    assert!(found.habits.is_empty(), "{what}: {:?}", found.habits);
}

#[test]
fn exact_motion_is_clean_however_it_is_sampled() {
    let body = book(TorqueSpecs::default());
    for (count, step) in [(600, 1.0 / 60.0), (4000, 0.0025), (100, 0.1), (40, 0.7), (30, 3.3)] {
        let found = verified(&exact(&body, &evenly(count, step)), Some(&body));
        assert_clean(&format!("every {step} s"), &found);
        let laws = found.laws.expect("of a body");
        assert!(laws.defect < 4.0 * laws.floor, "{laws:?}");
        assert!(found.distance.expect("of attitudes").worst_rad < 1e-11);
    }
}

#[test]
fn exact_motion_in_32_bits_is_clean() {
    let body = book(TorqueSpecs::default());
    let mut observed = exact(&body, &evenly(1200, 1.0 / 60.0));
    let (attitude, rates) = (observed.attitude.as_mut().expect("it"), observed.angular_velocity.as_mut().expect("it"));
    for column in attitude.columns.iter_mut().chain(&mut rates.columns) {
        for value in column {
            *value = single(*value);
        }
    }
    let found = verified(&observed, Some(&body));
    assert_clean("f32", &found);
    assert!(!found.laws.expect("of a body").energy_per_turn.is_seen(), "rounding is no gain");
}

#[test]
fn without_a_body_attitude_and_rates_are_still_held_to_each_other_and_tell_the_body() {
    let body = book(TorqueSpecs::default());
    let found = verified(&exact(&body, &evenly(900, 1.0 / 60.0)), None);
    assert_clean("no body", &found);
    let fit = found.inertia.expect("it tumbles");
    let due = [0.002 / 0.006, 0.0042 / 0.006, 1.0];
    for (ratio, due) in fit.ratios.into_iter().zip(due) {
        assert!((ratio - due).abs() < 1e-9, "{fit:?}");
    }
}

#[test]
fn attitudes_alone_are_enough() {
    let body = book(TorqueSpecs::default());
    let mut observed = exact(&body, &evenly(2000, 0.005));
    observed.angular_velocity = None;
    assert_clean("attitudes alone", &verified(&observed, Some(&body)));
}

#[test]
fn rates_alone_are_held_to_the_laws() {
    let body = book(TorqueSpecs::default());
    let mut observed = exact(&body, &evenly(600, 1.0 / 60.0));
    observed.attitude = None;
    assert_clean("rates alone", &verified(&observed, Some(&body)));
}

/// As its own grid samples it, and at every seventh sample of that.
#[test]
fn every_scene_is_clean() {
    for name in library::names() {
        let plan = Plan::new(&Scenario::named(name, &[]).expect("a scene")).expect("a plan");
        for body in &plan.bodies {
            for stride in [1, 7] {
                let samples = (plan.grid.len() / stride).min(3000);
                let times: Vec<f64> = (0..samples).map(|k| plan.grid.time(k * stride)).collect();
                if times.len() >= 8 {
                    let found = verified(&exact(body, &times), Some(body));
                    // Under loads that are not recorded attitudes alone must tell, and take eight samples to a turn.
                    let is_coarse = stride > 1 && !body.problem.loads.is_empty();
                    if is_coarse && found.reasons.iter().any(|reason| reason.contains("samples to a turn")) {
                        continue;
                    }
                    assert_clean(&format!("{name}, {}, every {stride}", body.name), &found);
                }
            }
        }
    }
}

/// A torque that only the file tells: recorded beside the motion, no scene at hand.
#[test]
fn the_moment_that_a_file_records_is_taken_to_act() {
    let spec = MomentSpec { moment_n_m: [0.002, -0.003, 0.001], start_s: None, end_s: None };
    let body = book(TorqueSpecs { constant_world: vec![spec], ..TorqueSpecs::default() });
    let times = evenly(800, 0.005);
    let mut observed = exact(&body, &times);
    let moments = body.sample(&[Channel::MomentBody], &times).expect("sampled");
    let columns = moments.channel(Channel::MomentBody).expect("asked for");
    observed.moment = Some(Track {
        times_s: times,
        columns: std::array::from_fn(|i| columns[i].clone()),
        axes: Some(Axes::Body),
        resolution: f64::EPSILON / 2.0,
    });
    let free = book(TorqueSpecs::default());
    assert_clean("recorded moment", &verified(&observed, Some(&free)));
    observed.moment = None;
    assert_eq!(verified(&observed, Some(&free)).verdict, Verdict::Wrong, "something acts, and nobody said so");
}

/// Montgomery's law, Ω by quadrature, against closed-form attitudes: about the axes of the least and of the greatest moment.
#[test]
fn the_turn_about_l_is_montgomerys() {
    for omega in [[2.0, 4.0, 1.5], [5.0, 1.0, 0.3], [-5.0, 1.0, 0.3], [0.2, 1.0, 4.0], [0.2, -1.0, -4.0]] {
        let mut body = book(TorqueSpecs::default());
        body.problem.initial.angular_velocity = AngularVelocity::new(omega).expect("finite");
        let found = verified(&exact(&body, &evenly(6000, 0.002)), Some(&body)).montgomery.expect("free motion");
        assert!(found.periods >= 2, "{found:?}");
        assert!(found.worst_rad < 1e-11, "{omega:?}: {found:?}");
    }
}
