//! The closed form of the Lagrange top: thirty-digit trajectories, agreement with Taylor series, continuity.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use polhode::body::{AngularVelocity, Attitude};
use polhode::dynamics::{Load, Problem, Torque, Window};
use polhode::numerics::DoubleDouble;
use polhode::propagation::{LagrangeTop, PropagationError, States, Taylor};
use proptest::prelude::*;

use crate::forced_oracle;
use crate::motions::{grid, problem, row, run};
use crate::reference::{Case, cases, tops};

/// rad. Every case keeps it: any time, any tilt, however near two roots are.
const ATTITUDE_LIMIT_RAD: f64 = 1.2e-15;
/// Of the largest |ω| of a case.
const OMEGA_LIMIT: f64 = 1.2e-15;

/// The case with its quaternion bit for bit, to be normalised beyond the last of them.
fn exactly(case: &Case) -> Problem {
    let [w, x, y, z] = case.q0;
    let mut problem = forced_oracle::problem(case);
    let attitude = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
    problem.initial.attitude = Attitude::from_world_from_body(attitude);
    problem
}

fn errors(case: &Case, states: &States) -> [f64; 2] {
    let (mut attitude, mut omega, mut largest) = (0.0_f64, 0.0_f64, 0.0_f64);
    for (i, sample) in case.samples.iter().enumerate() {
        let size = Vector3::from(sample.omega.map(DoubleDouble::hi)).norm();
        let found = sample.omega_error(row(&states.angular_velocity, i)) * size;
        assert!(found.is_finite(), "{} at {} s", case.name, sample.t);
        attitude = attitude.max(sample.attitude_error(row(&states.attitude, i)));
        (omega, largest) = (omega.max(found), largest.max(size));
    }
    [attitude, omega / largest]
}

#[test]
fn every_case_is_right_to_rounding() {
    let mut missed = Vec::new();
    let mut tops = tops();
    assert!(tops.len() >= 20, "{} tops", tops.len());
    tops.extend(cases().into_iter().filter(|case| case.name == "heavy_top_looping"));
    for case in tops {
        let top = LagrangeTop::new(&exactly(&case)).expect("a Lagrange top");
        let times: Vec<f64> = case.samples.iter().map(|sample| sample.t).collect();
        let [attitude, omega] = errors(&case, &run(top, &times));
        println!("{:24} {attitude:9.2e} rad {omega:9.2e}, floor {:9.2e} rad", case.name, case.floor_rad);
        if attitude > ATTITUDE_LIMIT_RAD || omega > OMEGA_LIMIT {
            missed.push(case.name);
        }
    }
    assert!(missed.is_empty(), "beyond the limits: {missed:?}");
}

/// A top of these moments with its force at an arm along one axis.
fn top(moments: [f64; 3], rates: [f64; 3], force: [f64; 3], arm: [f64; 3]) -> Problem {
    problem(moments, rates, &[Torque::ForceWorld { force: force.into(), arm: arm.into() }])
}

/// The largest angle between two runs, rad.
fn apart(left: &States, right: &States) -> f64 {
    (0..left.len())
        .map(|i| {
            let [p, q] = [left, right].map(|states| Attitude::new(row(&states.attitude, i)).expect("unit"));
            p.angle_to(q)
        })
        .fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn random_tops_agree_with_taylor(
        (transverse, share) in (0.5..2.0_f64, 0.05..1.95_f64),
        rates in prop::array::uniform3(-6.0..6.0_f64),
        force in prop::array::uniform3(-5.0..5.0_f64),
        (axis, length) in (0..3_usize, -1.0..1.0_f64),
        q in prop::array::uniform4(-1.0..1.0_f64),
    ) {
        prop_assume!(q.iter().map(|part| part * part).sum::<f64>() > 0.01 && length.abs() > 1e-3);
        let (mut moments, mut arm) = ([transverse; 3], [0.0; 3]);
        (moments[axis], arm[axis]) = (share * transverse, length);
        let mut problem = top(moments, rates, force, arm);
        let [w, x, y, z] = q;
        problem.initial.attitude =
            Attitude::from_world_from_body(UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z)));
        let times = grid(5.0, 20);
        let closed = run(LagrangeTop::new(&problem).expect("a top"), &times);
        let stepped = run(Taylor::new(&problem, 1e-16).expect("covered"), &times);
        let angle = apart(&closed, &stepped);
        prop_assert!(angle < 2e-13, "{angle:e} rad");
        for i in 0..times.len() {
            let [a, b] = [&closed, &stepped].map(|states| Vector3::from(row(&states.angular_velocity, i)));
            prop_assert!((a - b).norm() < 1e-12, "{a} {b}");
            let (p, q) = (row(&closed.attitude, i), row(&stepped.attitude, i));
            prop_assert!((0..4).all(|k| (p[k] - q[k]).abs() < 1e-12), "sign: {p:?} {q:?}");
        }
    }
}

/// An upright top of moments 2, 2, 1 under a weight of 4 at 1 above the pivot; the threshold is ω₃ = 2 √(4 · 2) = √32.
fn upright(tilt: f64, spin: f64) -> Problem {
    let mut problem = top([2.0, 2.0, 1.0], [0.0, 0.0, spin], [0.0, 0.0, -4.0], [0.0, 0.0, 1.0]);
    let (sin, cos) = libm::sincos(0.5 * tilt);
    problem.initial.attitude =
        Attitude::from_world_from_body(UnitQuaternion::new_normalize(Quaternion::new(cos, sin, 0.0, 0.0)));
    problem
}

#[test]
fn tilts_through_upright_change_the_motion_continuously() {
    let times = grid(2.0, 20);
    for spin in [0.0, 3.0, 5.6, 5.7, 9.0] {
        let still = run(LagrangeTop::new(&upright(0.0, spin)).expect("a top"), &times);
        for exponent in [-9, -12, -15, -30, -60, -100, -200] {
            let tilt = libm::pow(10.0, f64::from(exponent));
            let moving = run(LagrangeTop::new(&upright(tilt, spin)).expect("a top"), &times);
            let angle = apart(&still, &moving);
            assert!(angle < 100.0 * tilt + 2e-15, "spin {spin}, tilt {tilt:e}: {angle:e} rad apart");
        }
    }
}

#[test]
fn a_top_that_rises_for_ever_is_the_limit_of_those_that_do_not() {
    // No spin, level, with just the energy to come upright: ω² = 2 F r/J = 4, about the level axis.
    let level = |rate: f64| {
        let mut problem = top([2.0, 2.0, 1.0], [rate, 0.0, 0.0], [0.0, 0.0, -4.0], [0.0, 0.0, 1.0]);
        problem.initial.attitude = Attitude::new([0.5; 4]).expect("a unit quaternion");
        problem
    };
    let times = grid(3.0, 30);
    for sign in [1.0, -1.0] {
        let exact = run(LagrangeTop::new(&level(2.0 * sign)).expect("a top"), &times);
        for nudge in [1e-15, -1e-15, 1e-12, -1e-12] {
            let near = run(LagrangeTop::new(&level(2.0 * sign * (1.0 + nudge))).expect("a top"), &times);
            let angle = apart(&exact, &near);
            assert!(angle < 1e3 * nudge.abs() + 4e-15, "{nudge:e}: {angle:e} rad apart");
        }
    }
}

#[test]
fn regular_precession_is_the_limit_of_small_nutation() {
    // A level top that precesses evenly: C ω₃ Ω = F r.
    let start = |more: f64| {
        let mut problem = top([2.0, 2.0, 1.0], [0.0, 0.5 + more, 8.0], [0.0, 0.0, -4.0], [0.0, 0.0, 1.0]);
        problem.initial.attitude = Attitude::new([0.5; 4]).expect("a unit quaternion");
        problem
    };
    let times = grid(50.0, 50);
    let exact = run(LagrangeTop::new(&start(0.0)).expect("a top"), &times);
    for more in [1e-16, 1e-13, -1e-13, 1e-10] {
        let near = run(LagrangeTop::new(&start(more)).expect("a top"), &times);
        let angle = apart(&exact, &near);
        assert!(angle < 200.0 * more.abs() + 4e-15, "{more:e}: {angle:e} rad apart");
    }
    for i in 0..times.len() {
        let omega = Vector3::from(row(&exact.angular_velocity, i));
        assert!((omega.xy().norm() - 0.5).abs() < 1e-15, "{omega}");
    }
}

/// A start at `tilt` from upright, or from hanging, with ω across the axis and along it.
fn degenerate(tilt: f64, from_below: bool, across: f64, spin: f64) -> Problem {
    let mut problem = upright(tilt, spin);
    let [w, x, ..] = problem.initial.attitude.wxyz();
    let [w, x] = if from_below { [-x, w] } else { [w, x] };
    problem.initial.attitude =
        Attitude::from_world_from_body(UnitQuaternion::new_unchecked(Quaternion::new(w, x, 0.0, 0.0)));
    problem.initial.angular_velocity = AngularVelocity::new([across, -0.5 * across, spin]).expect("finite");
    problem
}

#[test]
fn degenerate_starts_agree_with_taylor() {
    let values = [0.0, 1e-170, 1e-100, 1e-9, 1.0];
    let times = grid(2.0, 8);
    // What Taylor's steps cannot tell from nothing, they are not given.
    let told = |value: f64| if value.abs() < 1e-50 { 0.0 } else { value };
    for (tilt, across) in values.into_iter().flat_map(|tilt| values.map(|across| (tilt, across))) {
        for (from_below, spin) in
            [false, true].into_iter().flat_map(|below| [0.0, -1e-9, 1.0, -30.0].map(|s| (below, s)))
        {
            let closed = run(LagrangeTop::new(&degenerate(tilt, from_below, across, spin)).expect("a top"), &times);
            let plain = degenerate(told(tilt), from_below, told(across), spin);
            let angle = apart(&closed, &run(Taylor::new(&plain, 1e-16).expect("covered"), &times));
            assert!(angle < 1e-13, "tilt {tilt:e}, {from_below}, across {across:e}, spin {spin:e}: {angle:e} rad");
        }
    }
}

#[test]
fn scales_of_moments_and_time_do_not_matter() {
    let times = grid(5.0, 10);
    let problem = top([2.0, 2.0, 1.0], [0.5, -1.0, 3.0], [1.0, 2.0, -4.0], [0.0, 0.0, 1.0]);
    let states = run(LagrangeTop::new(&problem).expect("a top"), &times);
    for exponent in [-60.0, -20.0, 20.0, 60.0] {
        // Moments and force alike; then rates, with forces by their square.
        let by = libm::exp2(exponent);
        let heavy = top([2.0 * by, 2.0 * by, by], [0.5, -1.0, 3.0], [by, 2.0 * by, -4.0 * by], [0.0, 0.0, 1.0]);
        assert!(apart(&states, &run(LagrangeTop::new(&heavy).expect("a top"), &times)) < 1e-15);
        let square = by * by;
        let force = [square, 2.0 * square, -4.0 * square];
        let fast = top([2.0, 2.0, 1.0], [0.5 * by, -by, 3.0 * by], force, [0.0, 0.0, 1.0]);
        let soon: Vec<f64> = times.iter().map(|time| time / by).collect();
        assert!(apart(&states, &run(LagrangeTop::new(&fast).expect("a top"), &soon)) < 1e-15);
    }
}

#[test]
fn what_is_no_top_is_refused() {
    let force = [0.0, 0.0, -4.0];
    let good = top([2.0, 2.0, 1.0], [0.0, 1.0, 8.0], force, [0.0, 0.0, 1.0]);
    assert!(LagrangeTop::covers(&good));
    let mut windowed = good.clone();
    windowed.loads[0].window = Window { start: 0.0, end: 5.0 };
    let mut moving = good.clone();
    moving.wants_translation = true;
    let mut twice = good.clone();
    twice.loads.push(Load { torque: Torque::LinearDamping { coefficient: 0.1 }, window: Window::ALWAYS });
    let bad = [
        windowed,
        moving,
        twice,
        top([2.0, 2.0, 1.0], [0.0, 1.0, 8.0], force, [1.0, 0.0, 0.0]),
        top([2.0, 2.0, 1.0], [0.0, 1.0, 8.0], force, [0.0, 1e-9, 1.0]),
        top([2.0, 2.0, 1.0], [0.0, 1.0, 8.0], [0.0; 3], [0.0, 0.0, 1.0]),
        top([2.0, 2.000_000_1, 1.0], [0.0, 1.0, 8.0], force, [0.0, 0.0, 1.0]),
    ];
    for problem in bad {
        assert!(!LagrangeTop::covers(&problem), "{problem:?}");
        assert!(matches!(LagrangeTop::new(&problem), Err(PropagationError::NotCovered { .. })));
    }
}
