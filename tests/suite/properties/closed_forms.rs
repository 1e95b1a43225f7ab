//! The other closed forms: Lagrange's top, the brake along L, the torque along a spin.

use nalgebra::{UnitQuaternion, Vector3};
use polhode::body::State;
use polhode::dynamics::{Load, Problem, Torque, Window};
use polhode::propagation::{AxialTorque, BrakedRotation, FreeRotation, LagrangeTop};
use proptest::prelude::*;

use super::cases;
use super::motions::{Apart, at, energy, momentum, precise, sensitivity, speed};
use super::starts::{attitude, decades, free, problem, rates, signed, vector};

/// A top of any shape, size, tilt and spin, from slow to fast.
pub fn top() -> impl Strategy<Value = Problem> {
    let shape = (decades(-6.0, 6.0), decades(-6.0, 0.3), 0..3_usize);
    let tilt = prop_oneof![3 => attitude().boxed(), 1 => near_upright().boxed()];
    (shape, rates_of_tops(), tilt, (vector(-3.0, 3.0), signed(-3.0, 1.0))).prop_map(
        |((transverse, ratio, axis), rates, attitude, (force, length))| {
            let (mut moments, mut arm) = ([transverse; 3], Vector3::zeros());
            moments[axis] = transverse * ratio.min(2.0);
            arm[axis] = length;
            // In units of what gravity makes of the top: √(F r / I).
            let unit = (force.norm() * length.abs() / transverse).sqrt();
            let top = problem(moments, rates.map(|rate| rate * unit), attitude);
            under(&top, Torque::ForceWorld { force, arm })
        },
    )
}

fn rates_of_tops() -> impl Strategy<Value = [f64; 3]> {
    let part = || prop_oneof![3 => signed(-2.0, 1.0), 1 => signed(-12.0, 0.0), 1 => Just(0.0)];
    [part(), part(), part()]
}

/// Tilted from the vertical by little or nothing, about x or y.
fn near_upright() -> impl Strategy<Value = UnitQuaternion<f64>> {
    let tilt = || prop_oneof![signed(-20.0, -1.0), Just(0.0)];
    (tilt(), tilt(), any::<bool>()).prop_map(|(x, y, hangs)| {
        let turn = UnitQuaternion::from_scaled_axis(Vector3::new(x, y, 0.0));
        if hangs { turn * UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(0.0, 1.0, 0.0, 0.0)) } else { turn }
    })
}

/// How fast a top moves, 1/s.
pub fn pace(top: &Problem) -> f64 {
    let Torque::ForceWorld { force, arm } = top.loads[0].torque else { return speed(top) };
    (force.norm() * arm.norm() / top.moments.vector().max()).sqrt() + speed(top)
}

fn under(problem: &Problem, torque: Torque) -> Problem {
    Problem { loads: vec![Load { torque, window: Window::ALWAYS }], ..problem.clone() }
}

fn top_state(top: &Problem, time: f64) -> State {
    at(LagrangeTop::new(top).expect("a top"), time)
}

fn braked() -> impl Strategy<Value = Problem> {
    (free(), decades(-12.0, 2.0)).prop_map(|(problem, brake)| {
        let rate = brake * speed(&problem);
        under(&problem, Torque::MomentumBrake { rate })
    })
}

fn along_spin() -> impl Strategy<Value = Problem> {
    let start = (super::starts::moments(), attitude());
    (start, 0..3_usize, signed(-9.0, 9.0), signed(-9.0, 3.0)).prop_map(|((moments, attitude), axis, spin, push)| {
        let (mut rates, mut moment) = ([0.0; 3], Vector3::zeros());
        rates[axis] = spin;
        moment[axis] = push * moments[axis] * spin * spin;
        under(&problem(moments, rates, attitude), Torque::ConstantBody { moment })
    })
}

proptest! {
    #![proptest_config(cases(256))]

    #[test]
    fn tops_keep_energy_and_two_momenta(top in top(), turns in decades(-3.0, 9.0)) {
        let Torque::ForceWorld { force, arm } = top.loads[0].torque else { unreachable!("as made") };
        let axis = arm.iamax();
        let state = top_state(&top, turns / pace(&top));
        let moments = top.moments.vector();
        let potential = |state: &State| -force.dot(&state.attitude.to_world(&arm));
        let scale = moments.max() * pace(&top) * pace(&top);
        let total = |state: &State| energy(&top, state) + potential(state);
        let drift = (total(&state) - total(&top.initial)).abs() / scale;
        prop_assert!(drift <= 1e-14, "E drifts by {drift:e}");
        let upward = force.normalize();
        let along = |state: &State| momentum(&top, state).dot(&upward);
        let drift = (along(&state) - along(&top.initial)).abs() / (scale / pace(&top));
        prop_assert!(drift <= 1e-14, "L along the force drifts by {drift:e}");
        let spin = |state: &State| state.angular_velocity.in_body()[axis];
        prop_assert!((spin(&state) - spin(&top.initial)).abs() <= 4e-16 * spin(&top.initial).abs());
    }

    #[test]
    fn a_brake_takes_from_momentum_its_size_alone(problem in braked(), turns in decades(-3.0, 6.0)) {
        let time = turns / speed(&problem);
        let Torque::MomentumBrake { rate } = problem.loads[0].torque else { unreachable!("as made") };
        let state = at(BrakedRotation::new(&problem).expect("covered"), time);
        let left = libm::exp(-rate * time);
        let off = (momentum(&problem, &state) - left * momentum(&problem, &problem.initial)).norm();
        let scale = problem.moments.vector().max() * speed(&problem) * left;
        // The exponent is rounded here, not there.
        prop_assert!(off <= (6e-15 + 2e-16 * rate * time) * scale + f64::MIN_POSITIVE, "{:e}", off / scale);
    }

    #[test]
    fn a_brake_on_a_ball_only_slows_it(size in decades(-9.0, 9.0), rates in rates(), attitude in attitude(), brake in decades(-6.0, 1.0)) {
        let ball = problem([size; 3], rates, attitude);
        let (rate, time) = (brake * speed(&ball), 1.0 / speed(&ball));
        let found = at(BrakedRotation::new(&under(&ball, Torque::MomentumBrake { rate })).expect("covered"), time);
        let turned = -libm::expm1(-rate * time) / rate;
        let expected = at(FreeRotation::new(&ball).expect("nothing acts"), turned);
        prop_assert!(found.attitude.angle_to(expected.attitude) < 4e-15);
    }

    #[test]
    fn a_push_along_a_spin_adds_up(problem in along_spin(), turns in decades(-3.0, 3.0)) {
        let Torque::ConstantBody { moment } = problem.loads[0].torque else { unreachable!("as made") };
        let axis = moment.iamax();
        let (spin, push) = (problem.initial.angular_velocity.in_body()[axis], moment[axis] / problem.moments.vector()[axis]);
        let time = turns / speed(&problem);
        let state = at(AxialTorque::new(&problem).expect("covered"), time);
        let expected = spin + push * time;
        let scale = spin.abs() + (push * time).abs();
        prop_assert!((state.angular_velocity.in_body()[axis] - expected).abs() <= 1e-15 * scale);
        let angle = time * (spin + 0.5 * push * time);
        let turn = UnitQuaternion::from_axis_angle(&Vector3::ith_axis(axis), angle);
        let expected = polhode::body::Attitude::from_world_from_body(problem.initial.attitude.world_from_body() * turn);
        // The angle is rounded here, not there.
        let room = 4e-15 + 1e-15 * time * scale;
        prop_assert!(state.attitude.angle_to(expected) <= room, "{:e}", state.attitude.angle_to(expected));
    }
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn tops_move_as_in_double_double(top in top(), turns in decades(-2.0, 1.0)) {
        let time = turns / pace(&top);
        if let Some(exact) = precise(&top, time) {
            let found = Apart::of(&top_state(&top, time), &exact);
            // Near an upright axis within ten roundings of the inputs, as LagrangeTop promises.
            let limit = sensitivity(&top, |start| top_state(start, time));
            prop_assert!(found.angle <= 2.4e-15 + 10.0 * limit.angle, "{found:?} {limit:?}");
            prop_assert!(found.rate <= 2.4e-15 * pace(&top) + 10.0 * limit.rate, "{found:?} {limit:?}");
        }
    }

    #[test]
    fn brakes_slow_as_in_double_double(problem in braked(), turns in decades(-2.0, 1.0)) {
        let Torque::MomentumBrake { rate } = problem.loads[0].torque else { unreachable!("as made") };
        // Until L has died away by e^100: of squares of what is left later, the reference loses the second half.
        let time = (turns / speed(&problem)).min(100.0 / rate);
        if let Some(exact) = precise(&problem, time) {
            let found = Apart::of(&at(BrakedRotation::new(&problem).expect("covered"), time), &exact);
            prop_assert!(found.is_within(2.3e-15, speed(&problem)), "{found:?}");
        }
    }
}
