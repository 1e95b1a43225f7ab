//! The forms of the solution meet: where one ends and the next begins, the motion does not jump.

use polhode::body::{AngularVelocity, State};
use polhode::dynamics::Problem;
use proptest::prelude::*;

use super::cases;
use super::motions::{Apart, free_state, from, parting, sensitivity, speed};
use super::starts::{attitude, decades, free, problem, rates, signed, stepped};

/// The motion of `near` is that of `problem`, as far as roundings of the start and `more` let it be.
fn assert_near(problem: &Problem, near: &Problem, time: f64, more: f64) {
    let found = Apart::of(&free_state(problem, time), &free_state(near, time));
    // Of the one that is not quite even, where roundings part the moments.
    let limit = sensitivity(near, |start| free_state(start, time));
    let (angle, rate) = (8.0 * limit.angle + more + 4e-15, 8.0 * limit.rate + (more + 4e-15) * speed(problem));
    assert!(found.angle <= angle && found.rate <= rate, "{found:?} {limit:?} {problem:?} {near:?}");
}

proptest! {
    #![proptest_config(cases(256))]

    #[test]
    fn moments_that_meet(
        transverse in decades(-6.0, 6.0), ratio in decades(-12.0, 0.3), rates in rates(), attitude in attitude(),
        (axis, other, bits) in (0..3_usize, any::<bool>(), prop_oneof![Just(-1), Just(1), -3..4_i32]),
        turns in decades(-3.0, 1.0),
    ) {
        let mut even = [transverse; 3];
        even[axis] *= ratio.min(2.0);
        let mut near = even;
        let changed = (axis + if other { 1 } else { 2 }) % 3;
        near[changed] = stepped(near[changed], bits);
        let even = problem(even, rates, attitude);
        prop_assume!(polhode::body::PrincipalMoments::new(near).is_ok());
        let near = problem(near, rates, attitude);
        assert_near(&even, &near, turns / parting(&near), 0.0);
    }

    #[test]
    fn spins_about_an_axis(
        moments in super::starts::moments(), (axis, size) in (0..3_usize, decades(-9.0, 9.0)), attitude in attitude(),
        parts in [signed(-140.0, -60.0), signed(-140.0, -60.0)], turns in decades(-3.0, 1.0),
    ) {
        let mut rates = [0.0; 3];
        rates[axis] = size;
        let spin = problem(moments, rates, attitude);
        rates[(axis + 1) % 3] = size * parts[0];
        rates[(axis + 2) % 3] = size * parts[1];
        // About a middle axis it grows by less than e^(turns · I₂/√(I₁I₃)), and L is I₃/I₁ times as far off.
        let time = turns / size;
        let mut sorted = moments;
        sorted.sort_by(f64::total_cmp);
        let growth = libm::exp((turns * sorted[2] / sorted[0]).min(100.0));
        assert_near(&spin, &problem(moments, rates, attitude), time, 1e-50 * growth);
    }

    #[test]
    fn rates_a_rounding_apart(problem in free(), (axis, bits) in (0..3_usize, -2..3_i32), turns in decades(-3.0, 1.0)) {
        let mut rates: [f64; 3] = problem.initial.angular_velocity.in_body().into();
        rates[axis] = stepped(rates[axis], if rates[axis] == 0.0 { bits.abs() } else { bits });
        let near = State { angular_velocity: AngularVelocity::new(rates).expect("finite"), ..problem.initial };
        assert_near(&problem, &from(&problem, near), turns / parting(&problem), 0.0);
    }

    #[test]
    fn instants_next_to_each_other(problem in free(), turns in decades(-3.0, 9.0)) {
        // ω and its rate of change are bounded by the moments: |ω̇| ≤ (I₃/I₁) |ω|².
        let time = turns / speed(&problem);
        let (here, next) = (free_state(&problem, time), free_state(&problem, stepped(time, 1)));
        let found = Apart::of(&here, &next);
        let moments = problem.moments.vector();
        let fastest = speed(&problem) * moments.max() / moments.min();
        let step = (stepped(time, 1) - time) * fastest;
        prop_assert!(found.angle <= 4e-15 + 2.0 * step && found.rate <= (4e-15 + 2.0 * step) * fastest, "{found:?}");
        prop_assert!((here.attitude.world_from_body().coords - next.attitude.world_from_body().coords).norm() <= 4e-15 + step);
    }
}
