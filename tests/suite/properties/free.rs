//! Torque-free rotation: any body, any start, any span.

use nalgebra::{UnitQuaternion, Vector3};
use polhode::body::{AngularVelocity, Attitude, PrincipalMoments, State};
use polhode::propagation::FreeRotation;
use proptest::prelude::*;

use super::cases;
use super::motions::{Apart, energy, free_state, from, momentum, parting, precise, sensitivity, speed};
use super::starts::{attitude, decades, free};

/// Of a state: both ends of a comparison are rounded.
const ROUNDING: f64 = 4e-15;

proptest! {
    #![proptest_config(cases(512))]

    #[test]
    fn energy_and_momentum_stay(problem in free(), turns in decades(-3.0, 12.0)) {
        let state = free_state(&problem, turns / speed(&problem));
        let drift = (momentum(&problem, &state) - momentum(&problem, &problem.initial)).norm();
        // An attitude is off by a rounding, and so is ω of its size: along the largest moment that is I |ω| ε.
        let scale = problem.moments.vector().max() * speed(&problem);
        prop_assert!(drift <= ROUNDING * scale, "L drifts by {:e}", drift / scale);
        let (start, end) = (energy(&problem, &problem.initial), energy(&problem, &state));
        prop_assert!((end - start).abs() <= ROUNDING * scale * speed(&problem), "E drifts by {:e}", end / start - 1.0);
    }

    #[test]
    fn a_state_on_the_way_starts_the_same_motion(problem in free(), first in decades(-3.0, 4.0), more in decades(-3.0, 1.0)) {
        let (first, more) = (first / speed(&problem), more / parting(&problem));
        let way = from(&problem, free_state(&problem, first));
        let found = Apart::of(&free_state(&way, more), &free_state(&problem, first + more));
        let limit = sensitivity(&way, |start| free_state(start, more));
        // The sum of the times is rounded.
        let late = f64::EPSILON * (first + more) * parting(&problem);
        prop_assert!(found.angle <= 8.0 * limit.angle + ROUNDING + late, "{found:?} {limit:?}");
        prop_assert!(found.rate <= 8.0 * limit.rate + (ROUNDING + late) * speed(&problem), "{found:?} {limit:?}");
    }

    #[test]
    fn back_again_is_where_it_began(problem in free(), turns in decades(-3.0, 1.0)) {
        let time = turns / parting(&problem);
        let there = free_state(&problem, time);
        let reversed = |state: State| State {
            angular_velocity: AngularVelocity::from_vector(-state.angular_velocity.in_body()), ..state
        };
        let back = from(&problem, reversed(there));
        let found = Apart::of(&free_state(&back, time), &reversed(problem.initial));
        let limit = sensitivity(&back, |start| free_state(start, time));
        prop_assert!(found.angle <= 8.0 * limit.angle + ROUNDING, "{found:?} {limit:?}");
        prop_assert!(found.rate <= 8.0 * limit.rate + ROUNDING * speed(&problem), "{found:?} {limit:?}");
    }

    #[test]
    fn a_turned_world_turns_the_attitude_alone(problem in free(), turn in attitude(), turns in decades(-3.0, 12.0)) {
        let time = turns / speed(&problem);
        let turned = State {
            attitude: Attitude::from_world_from_body(turn * problem.initial.attitude.world_from_body()), ..problem.initial
        };
        let (plain, turned) = (free_state(&problem, time), free_state(&from(&problem, turned), time));
        prop_assert_eq!(plain.angular_velocity, turned.angular_velocity);
        let expected = Attitude::from_world_from_body(turn * plain.attitude.world_from_body());
        prop_assert!(expected.angle_to(turned.attitude) < ROUNDING);
    }

    #[test]
    fn axes_in_another_order_are_the_same_body(problem in free(), half_turn in 0..3_usize, turns in decades(-3.0, 12.0)) {
        let time = turns / speed(&problem);
        // Axes x, y, z become y, z, x, and then two of them turn round.
        let mut signs = [-1.0; 3];
        signs[half_turn] = 1.0;
        let other = |v: Vector3<f64>| Vector3::new(signs[0] * v.y, signs[1] * v.z, signs[2] * v.x);
        let third = UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(0.5, 0.5, 0.5, 0.5));
        let half = UnitQuaternion::from_axis_angle(&Vector3::ith_axis(half_turn), std::f64::consts::PI);
        let body_from_other = third * half;
        let renamed = |state: &State| State {
            attitude: Attitude::from_world_from_body(state.attitude.world_from_body() * body_from_other),
            angular_velocity: AngularVelocity::from_vector(other(state.angular_velocity.in_body())),
            ..*state
        };
        let moments = problem.moments.vector();
        let mut same = from(&problem, renamed(&problem.initial));
        same.moments = PrincipalMoments::new([moments.y, moments.z, moments.x]).expect("the same body");
        let (expected, found) = (renamed(&free_state(&problem, time)), free_state(&same, time));
        prop_assert!(Apart::of(&expected, &found).is_within(ROUNDING, speed(&problem)), "{expected:?} {found:?}");
    }

    #[test]
    fn rates_alone_are_those_with_attitude(mut problem in free(), turns in decades(-3.0, 12.0)) {
        let times = [0.0, turns / speed(&problem)];
        let together = crate::motions::run(FreeRotation::new(&problem).expect("nothing acts"), &times);
        problem.wants_attitude = false;
        let alone = crate::motions::run(FreeRotation::new(&problem).expect("nothing acts"), &times);
        prop_assert_eq!(alone.angular_velocity, together.angular_velocity);
    }
}

proptest! {
    #![proptest_config(cases(96))]

    #[test]
    fn the_closed_form_is_the_motion(problem in free(), turns in decades(-2.0, 1.5)) {
        let time = turns / speed(&problem);
        if let Some(exact) = precise(&problem, time) {
            let found = Apart::of(&free_state(&problem, time), &exact);
            // What FreeRotation promises, and half a rounding of the reference.
            prop_assert!(found.is_within(1.3e-15, speed(&problem)), "{found:?}");
        }
    }
}
