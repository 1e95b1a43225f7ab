//! What columns mean is found, not assumed.

use polhode::comparison::verify::{Cause, Verdict, Verification};
use polhode::recording::{Axes, Observed, Track};
use polhode::scenario::TorqueSpecs;

use super::engine::{book, causes, evenly, exact, verified};

fn motion() -> Observed {
    exact(&book(TorqueSpecs::default()), &evenly(1000, 0.01))
}

fn rows<const N: usize>(track: &mut Track<N>, change: impl Fn(usize, [f64; N]) -> [f64; N]) {
    for k in 0..track.times_s.len() {
        let row = change(k, track.columns.each_ref().map(|column| column[k]));
        for (column, value) in track.columns.iter_mut().zip(row) {
            column[k] = value;
        }
    }
}

fn found(observed: &Observed) -> Verification {
    verified(observed, Some(&book(TorqueSpecs::default())))
}

fn in_world(observed: &mut Observed, told: Option<Axes>) {
    let q = observed.attitude.clone().expect("attitudes").columns;
    let rates = observed.angular_velocity.as_mut().expect("rates");
    rows(rates, |k, omega| {
        let q = super::engine::quaternion(q.each_ref().map(|column| column[k]));
        (nalgebra::UnitQuaternion::new_normalize(q) * nalgebra::Vector3::from(omega)).into()
    });
    rates.axes = told;
}

#[test]
fn rates_in_world_axes_are_found_without_being_told() {
    let mut observed = motion();
    in_world(&mut observed, None);
    let found = found(&observed);
    assert_eq!(found.verdict, Verdict::Clean, "{:?}", found.reasons);
    assert_eq!(found.candidates.chosen.axes, Axes::World);
    assert!(found.candidates.is_decided);
}

#[test]
fn rates_in_other_axes_than_told_are_a_fault() {
    let mut observed = motion();
    in_world(&mut observed, Some(Axes::Body));
    let found = found(&observed);
    assert_eq!(found.verdict, Verdict::Wrong);
    assert_eq!(found.causes[0].cause, Cause::OtherFrameThanTold { found: Axes::World });
}

#[test]
fn a_conjugated_quaternion() {
    let mut observed = motion();
    rows(observed.attitude.as_mut().expect("it"), |_, [w, x, y, z]| [w, -x, -y, -z]);
    assert_eq!(causes(&found(&observed)), ["quaternion_conjugated"]);
}

#[test]
fn a_quaternion_with_its_scalar_last() {
    let mut observed = motion();
    rows(observed.attitude.as_mut().expect("it"), |_, [w, x, y, z]| [x, y, z, w]);
    assert_eq!(causes(&found(&observed)), ["quaternion_order"]);
}

#[test]
fn rates_in_degrees() {
    let mut observed = motion();
    rows(observed.angular_velocity.as_mut().expect("it"), |_, omega| omega.map(f64::to_degrees));
    assert_eq!(causes(&found(&observed)), ["degrees"]);
}

#[test]
fn a_time_base_that_is_not_that_of_the_attitudes() {
    for factor in [0.5, 0.97, 2.0] {
        let mut observed = motion();
        rows(observed.angular_velocity.as_mut().expect("it"), |_, omega| omega.map(|rate| rate / factor));
        let found = verified(&observed, None);
        let [finding] = found.causes.as_slice() else { panic!("{factor}: {:?}", found.causes) };
        let Cause::TimeScale { factor: seen } = finding.cause else { panic!("{factor}: {finding:?}") };
        assert!((seen / factor - 1.0).abs() < 2e-3, "{seen} is not {factor}");
    }
}

#[test]
fn signs_and_repeated_samples_are_harmless() {
    let mut observed = motion();
    rows(observed.attitude.as_mut().expect("it"), |k, q| if k % 5 == 3 { q.map(|part| -part) } else { q });
    for column in &mut observed.attitude.as_mut().expect("it").columns {
        column[500] = column[499];
    }
    for column in &mut observed.angular_velocity.as_mut().expect("it").columns {
        column[500] = column[499];
    }
    let found = found(&observed);
    assert_eq!(found.verdict, Verdict::Clean, "{:?}", found.reasons);
    assert_eq!(found.clock.repeated, 1);
    assert!(found.length.expect("attitudes").sign_flips >= 398);
}

#[test]
fn frames_that_were_dropped_are_seen_as_jumps() {
    let whole = motion();
    let cut = |column: &Vec<f64>| {
        column.iter().enumerate().filter(|(k, _)| !(400..405).contains(k)).map(|(_, v)| *v).collect()
    };
    let mut observed = whole.clone();
    let attitude = observed.attitude.as_mut().expect("it");
    attitude.columns = attitude.columns.each_ref().map(cut);
    attitude.times_s.truncate(995);
    let rates = observed.angular_velocity.as_mut().expect("it");
    rates.columns = rates.columns.each_ref().map(cut);
    rates.times_s.truncate(995);
    let found = verified(&observed, None);
    assert_eq!(found.verdict, Verdict::Wrong);
    assert_eq!(causes(&found)[0], "dropped_frames");
    assert_eq!(found.kinematics.expect("both").first_jump_s, Some(4.0));
}

#[test]
fn a_steady_spin_does_not_tell_the_frame_and_says_so() {
    let body = book(TorqueSpecs::default());
    let mut observed = exact(&body, &evenly(500, 0.01));
    rows(observed.angular_velocity.as_mut().expect("it"), |_, _| [0.0, 0.0, 3.0]);
    rows(observed.attitude.as_mut().expect("it"), |k, _| {
        #[expect(clippy::cast_precision_loss, reason = "500 at most")]
        let half = 0.5 * 3.0 * 0.01 * k as f64;
        [libm::cos(half), 0.0, 0.0, libm::sin(half)]
    });
    observed.angular_velocity.as_mut().expect("it").axes = None;
    let found = found(&observed);
    assert_eq!(found.verdict, Verdict::Clean, "{:?}", found.reasons);
    assert!(!found.candidates.is_decided && found.inertia.is_none());
}

#[test]
fn samples_too_far_apart_do_not_tell_without_a_body() {
    let body = book(TorqueSpecs::default());
    let found = verified(&exact(&body, &evenly(60, 0.9)), None);
    assert_eq!(found.verdict, Verdict::CannotTell);
    assert!(found.reasons[0].contains("samples to a turn"), "{:?}", found.reasons);
}
