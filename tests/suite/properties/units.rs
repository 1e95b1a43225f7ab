//! Units do not matter: kilograms and seconds by powers of two change no bit, by other factors no more than roundings do.

use polhode::body::{AngularVelocity, PrincipalMoments, State};
use polhode::dynamics::{Load, Problem, Torque, Window};
use polhode::propagation::{Dop853, FreeRotation, LagrangeTop, Propagator, Taylor};
use proptest::prelude::*;

use super::motions::{Apart, at, free_state, parting, sensitivity, speed};
use super::starts::{decades, free};
use super::stepped::loaded;
use super::{cases, closed_forms};

/// Kilograms times one number, and per-second quantities times another.
fn in_units(problem: &Problem, mass: f64, rate: f64) -> Problem {
    let (spin, torque) = (problem.initial.angular_velocity.in_body() * rate, mass * rate * rate);
    let loads = problem.loads.iter().map(|load| {
        let scaled = match load.torque {
            Torque::ConstantBody { moment } => Torque::ConstantBody { moment: moment * torque },
            Torque::ConstantWorld { moment } => Torque::ConstantWorld { moment: moment * torque },
            Torque::LinearDamping { coefficient } => Torque::LinearDamping { coefficient: coefficient * mass * rate },
            Torque::MomentumBrake { rate: brake } => Torque::MomentumBrake { rate: brake * rate },
            Torque::ForceBody { force, arm } => Torque::ForceBody { force: force * torque, arm },
            Torque::ForceWorld { force, arm } => Torque::ForceWorld { force: force * torque, arm },
            Torque::ProfileBody { .. }
            | Torque::ProfileWorld { .. }
            | Torque::ForceProfileBody { .. }
            | Torque::ForceProfileWorld { .. }
            | Torque::Rotor { .. } => unreachable!("loads that are constants"),
            Torque::MagneticDipole { dipole, field } => Torque::MagneticDipole { dipole: dipole * torque, field },
            Torque::GravityGradient { mean_motion } => Torque::GravityGradient { mean_motion: mean_motion * rate },
            Torque::General(_) => unreachable!("none is drawn"),
        };
        Load { torque: scaled, window: Window { start: load.window.start / rate, end: load.window.end / rate } }
    });
    Problem {
        moments: PrincipalMoments::new((problem.moments.vector() * mass).into()).expect("the same body"),
        initial: State { angular_velocity: AngularVelocity::from_vector(spin), ..problem.initial },
        loads: loads.collect(),
        ..problem.clone()
    }
}

/// The state at `time` by `motion` is bit for bit the same in units of powers of two.
fn same_bits<P: Propagator>(problem: &Problem, time: f64, powers: (i32, i32), motion: impl Fn(&Problem) -> P) {
    let (mass, rate) = (libm::ldexp(1.0, powers.0), libm::ldexp(1.0, powers.1));
    let (plain, scaled) = (at(motion(problem), time), at(motion(&in_units(problem, mass, rate)), time / rate));
    assert_eq!(plain.attitude, scaled.attitude);
    assert_eq!(plain.angular_velocity.in_body(), scaled.angular_velocity.in_body() / rate);
}

proptest! {
    #![proptest_config(cases(256))]

    #[test]
    fn free_motions_have_no_unit(problem in free(), powers in (-200..200_i32, -200..200_i32), turns in decades(-3.0, 9.0)) {
        same_bits(&problem, turns / speed(&problem), powers, |problem| FreeRotation::new(problem).expect("nothing acts"));
    }

    #[test]
    fn steps_have_no_unit(problem in loaded(), powers in (-100..100_i32, -100..100_i32), turns in decades(-2.0, 0.5)) {
        let time = turns / speed(&problem);
        same_bits(&problem, time, powers, |problem| Taylor::new(problem, 1e-14).expect("covered"));
        same_bits(&problem, time, powers, |problem| Dop853::new(problem, 1e-10).expect("covered"));
    }

    #[test]
    fn tops_have_no_unit(top in closed_forms::top(), powers in (-100..100_i32, -100..100_i32), turns in decades(-3.0, 3.0)) {
        let time = turns / closed_forms::pace(&top);
        same_bits(&top, time, powers, |problem| LagrangeTop::new(problem).expect("a top"));
    }

    #[test]
    fn any_unit_moves_a_motion_by_roundings(
        problem in free(), mass in decades(-9.0, 9.0), rate in decades(-9.0, 9.0), turns in decades(-3.0, 1.0),
    ) {
        let time = turns / parting(&problem);
        let (plain, mut scaled) = (free_state(&problem, time), free_state(&in_units(&problem, mass, rate), time / rate));
        scaled.angular_velocity = AngularVelocity::from_vector(scaled.angular_velocity.in_body() / rate);
        let (found, limit) = (Apart::of(&plain, &scaled), sensitivity(&problem, |start| free_state(start, time)));
        let late = 2.0 * f64::EPSILON * turns + 4e-15;
        prop_assert!(found.angle <= 8.0 * limit.angle + late, "{found:?} {limit:?}");
        prop_assert!(found.rate <= 8.0 * limit.rate + late * speed(&problem), "{found:?} {limit:?}");
    }
}
