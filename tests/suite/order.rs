//! Each method shows its order on each smooth torque.

use nalgebra::Vector3;
use polhode::body::{Moment, State};
use polhode::dynamics::{Problem, TorqueModel};
use polhode::propagation::{Coverage, Dop853, FixedStep, FixedStepMethod, Propagator, States, Taylor};

use crate::motions::{MOMENTS, RATES, differences, every_torque, grid, problem, run};

const TIGHTEST: f64 = 1e-16;
const END: f64 = 6.0;

/// The worst attitude error, rad, against Taylor at its tightest, and the steps it took.
fn error(problem: &Problem, mut propagator: impl Propagator) -> (f64, f64) {
    let times = grid(END, 3);
    let exact = run(Taylor::new(problem, TIGHTEST).expect("covered"), &times);
    let mut found = States::default();
    propagator.fill(&times, &mut found).expect("a finite motion");
    let steps = u32::try_from(propagator.effort().steps).expect("a short run");
    (differences(&found, &exact).0, f64::from(steps))
}

#[test]
fn rk4_is_of_order_4() {
    for (name, torque) in every_torque() {
        let problem = problem(MOMENTS, RATES, &[torque]);
        let at = |step: f64| error(&problem, FixedStep::new(&problem, FixedStepMethod::Rk4, step).expect("covered")).0;
        let order = libm::log2(at(1.0 / 32.0) / at(1.0 / 64.0));
        assert!((order - 4.0).abs() < 0.3, "{name}: order {order}");
    }
}

/// Adaptive: the error goes like the tolerance, the steps like its eighth root.
#[test]
fn dop853_is_of_order_8() {
    for (name, torque) in every_torque() {
        let problem = problem(MOMENTS, RATES, &[torque]);
        let at = |tolerance: f64| error(&problem, Dop853::new(&problem, tolerance).expect("covered"));
        let ((coarse, few), (fine, many)) = (at(1e-9), at(1e-13));
        let order = libm::log2(coarse / fine) / libm::log2(many / few);
        assert!((7.5..9.5).contains(&order), "{name}: order {order}");
    }
}

#[test]
fn taylor_errors_are_near_their_tolerance() {
    for (name, torque) in every_torque() {
        let problem = problem(MOMENTS, RATES, &[torque]);
        for tolerance in [1e-6, 1e-8, 1e-10, 1e-12] {
            let (found, _) = error(&problem, Taylor::new(&problem, tolerance).expect("covered"));
            assert!(found < 100.0 * tolerance, "{name}: {found:e} at {tolerance:e}");
        }
    }
}

/// A spring about the world's z axis, in no list of torques.
struct Spring;

impl TorqueModel for Spring {
    fn moment(&self, time: f64, state: &State) -> Moment {
        let strength = 0.3 * (1.0 + 0.5 * libm::cos(time));
        let axis = state.attitude.to_body(&Vector3::z());
        Moment::from_vector(axis.cross(&Vector3::new(0.0, 0.3, 1.0)) * strength)
    }
}

#[test]
fn a_users_own_torque_converges() {
    let problem = problem(MOMENTS, RATES, &[]);
    let times = grid(END, 3);
    let fine = run(Dop853::with_model(&problem, Box::new(Spring), 1e-14).expect("covered"), &times);
    for method in FixedStepMethod::ALL {
        let information = method.information();
        let with_spring = |step: f64| FixedStep::with_model(&problem, Box::new(Spring), method, step);
        if information.coverage != Coverage::Everything {
            assert!(with_spring(0.1).is_err(), "{method:?} takes a model");
            continue;
        }
        let at = |step: f64| differences(&run(with_spring(step).expect("covered"), &times), &fine).0;
        let step = match information.order {
            1 => 1.0 / 1024.0,
            4 => 1.0 / 32.0,
            _ => 1.0 / 8.0,
        };
        let order = libm::log2(at(step) / at(0.5 * step));
        assert!((order - f64::from(information.order)).abs() < 0.3, "{method:?}: order {order}");
    }
}

/// Between steps the interpolant is as good as they are.
#[test]
fn dop853_is_accurate_between_its_steps() {
    for (name, torque) in every_torque() {
        let mut problem = problem(MOMENTS, RATES, &[torque]);
        problem.wants_translation = true;
        let times = grid(END, 997);
        let exact = run(Taylor::new(&problem, TIGHTEST).expect("covered"), &times);
        let found = run(Dop853::new(&problem, 1e-10).expect("covered"), &times);
        let (attitude, rates) = differences(&found, &exact);
        assert!(attitude < 1e-8 && rates < 1e-8, "{name}: {attitude:e} rad, {rates:e} rad/s");
        for (found, exact) in found.position.iter().flatten().zip(exact.position.iter().flatten()) {
            assert!((found - exact).abs() < 1e-8, "{name}: {found} for {exact}");
        }
    }
}
