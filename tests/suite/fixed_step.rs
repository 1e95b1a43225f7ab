//! What each method with a fixed step promises: its order on every smooth torque, and what it keeps for how long.

use nalgebra::Vector3;
use polhode::body::{AngularVelocity, State};
use polhode::dynamics::{Load, Problem, Torque, Window, momentum_in_world, potential_energy, rotational_energy};
use polhode::propagation::{Coverage, FixedStep, FixedStepMethod, PropagationError, Propagator, States, Taylor};

use crate::motions::{MOMENTS, RATES, differences, every_torque, grid, problem, profile, row, run, state};

const END: f64 = 6.0;
/// How far a measured order may be from the stated one.
const ORDER_LIMIT: f64 = 0.2;
/// Change of the momentum over 20,000 steps of several rotations each, relative: a rounding a step.
const MOMENTUM_LIMIT: f64 = 4e-12;
/// What Gauss changes of |L| and the energy in as many steps: its roundings are carried on.
const COMPENSATED_LIMIT: f64 = 4e-15;
/// How far |q| may be from 1.
const UNIT_LIMIT: f64 = 2e-15;
/// A heavy top held at its reference point: conservative and the same backwards.
const WEIGHT: Torque = Torque::ForceWorld { force: Vector3::new(0.0, 0.0, -2.0), arm: Vector3::new(0.1, -0.2, 0.3) };

fn stepped(problem: &Problem, method: FixedStepMethod, step: f64, times: &[f64]) -> States {
    run(FixedStep::new(problem, method, step).expect("covered"), times)
}

/// Nothing, and every torque; of these what the method covers, and is not exact for anyway.
fn torques_for(method: FixedStepMethod) -> Vec<(&'static str, Vec<Torque>)> {
    let is_exact_when_free = matches!(method, FixedStepMethod::Kicks2 | FixedStepMethod::Kicks4);
    let torque_free = method.information().coverage == Coverage::TorqueFree;
    let rotors = method.information().coverage == Coverage::Everything;
    let covered = |torque: &Torque| !torque_free && (rotors || !torque.is_internal());
    let acting =
        every_torque().into_iter().filter(|(_, torque)| covered(torque)).map(|(name, torque)| (name, vec![torque]));
    let free = (!is_exact_when_free).then(|| ("none", Vec::new()));
    free.into_iter().chain(acting).collect()
}

/// The longer of the two steps that show the order, s: short enough for the next term, long enough for rounding.
fn coarse_step(method: FixedStepMethod) -> f64 {
    match method.information().order {
        1 => 1.0 / 1024.0,
        2 => 1.0 / 64.0,
        4 => 1.0 / 32.0,
        6 => 1.0 / 16.0,
        _ => 1.0 / 3.0,
    }
}

#[test]
fn every_method_is_of_its_order_on_every_smooth_torque() {
    let mut missed = Vec::new();
    for method in FixedStepMethod::ALL {
        let times = grid(END, 3);
        for (name, torques) in torques_for(method) {
            let problem = problem(MOMENTS, RATES, &torques);
            let exact = run(Taylor::new(&problem, 1e-16).expect("covered"), &times);
            let at = |step: f64| differences(&stepped(&problem, method, step, &times), &exact).0;
            let step = coarse_step(method);
            let (coarse, fine) = (at(step), at(0.5 * step));
            let order = libm::log2(coarse / fine);
            println!("{:20} {name:17} order {order:.2}  {coarse:.1e} {fine:.1e}", method.information().name);
            if (order - f64::from(method.information().order)).abs() > ORDER_LIMIT {
                missed.push((method, name, order));
            }
        }
    }
    assert!(missed.is_empty(), "{missed:?}");
}

/// Steps end on the edges: a torque that begins and ends between samples costs no accuracy.
#[test]
fn windows_are_hit() {
    let times = grid(END, 3);
    let mut problem = problem(MOMENTS, RATES, &[every_torque()[0].1.clone()]);
    for method in
        FixedStepMethod::ALL.into_iter().filter(|method| method.information().coverage != Coverage::TorqueFree)
    {
        let mut error_within = |window: Window| {
            problem.loads[0].window = window;
            let exact = run(Taylor::new(&problem, 1e-16).expect("covered"), &times);
            differences(&stepped(&problem, method, coarse_step(method), &times), &exact).0
        };
        let (always, pulsed) = (error_within(Window::ALWAYS), error_within(Window { start: 2.3, end: 4.1 }));
        assert!(pulsed < 4.0 * always, "{method:?}: {always:e} becomes {pulsed:e}");
    }
}

/// A thruster on a turning body: the translation depends on the rotation.
#[test]
fn positions_are_of_the_same_order() {
    let thrust = Torque::ForceBody { force: Vector3::new(1.0, 0.5, -0.7), arm: Vector3::new(0.1, -0.2, 0.3) };
    let mut problem = problem(MOMENTS, RATES, &[thrust]);
    (problem.wants_translation, problem.gravity) = (true, Vector3::new(0.0, 0.0, -9.8));
    let times = grid(END, 3);
    let exact = run(Taylor::new(&problem, 1e-16).expect("covered"), &times);
    for method in FixedStepMethod::ALL {
        let information = method.information();
        if information.coverage == Coverage::TorqueFree {
            continue;
        }
        let at = |step: f64| {
            let found = stepped(&problem, method, step, &times);
            (Vector3::from(row(&found.position, 3)) - Vector3::from(row(&exact.position, 3))).norm()
        };
        let order = libm::log2(at(coarse_step(method)) / at(0.5 * coarse_step(method)));
        println!("{:20} position order {order:.2}", information.name);
        assert!((order - f64::from(information.order)).abs() < ORDER_LIMIT, "{method:?}: order {order}");
    }
}

/// The energy, J, at every sample.
fn energies(problem: &Problem, states: &States) -> Vec<f64> {
    (0..states.len())
        .map(|i| {
            let state = state(states, i);
            let potential = problem
                .loads
                .iter()
                .filter_map(|Load { torque, .. }| potential_energy(torque, problem.moments, 0.0, &state));
            rotational_energy(problem.moments, &state) + potential.sum::<f64>()
        })
        .collect()
}

fn largest_change(values: &[f64]) -> f64 {
    values.iter().map(|value| (value / values[0] - 1.0).abs()).fold(0.0, f64::max)
}

#[test]
fn symmetric_methods_run_back_to_where_they_started() {
    let times = grid(20.0, 1);
    for method in FixedStepMethod::ALL {
        let information = method.information();
        let torques = if information.coverage == Coverage::TorqueFree { vec![] } else { vec![WEIGHT] };
        let problem = problem(MOMENTS, RATES, &torques);
        let end = state(&stepped(&problem, method, 0.1, &times), 1);
        let reversed = State { angular_velocity: AngularVelocity::from_vector(-end.angular_velocity.in_body()), ..end };
        let back = state(&stepped(&Problem { initial: reversed, ..problem.clone() }, method, 0.1, &times), 1);
        let missed = back.attitude.angle_to(problem.initial.attitude);
        println!("{:20} {missed:e} rad", information.name);
        assert_eq!(missed < 1e-12, information.is_symmetric, "{method:?}: {missed:e} rad");
    }
}

/// Those that are not of first order: Euler's would leave the motion long before the end.
fn enduring() -> impl Iterator<Item = FixedStepMethod> {
    FixedStepMethod::ALL.into_iter().filter(|method| method.information().order > 1)
}

#[test]
fn naive_euler_gains_energy() {
    let problem = problem(MOMENTS, RATES, &[]);
    let energies = energies(&problem, &stepped(&problem, FixedStepMethod::EulerNaive, 0.01, &grid(60.0, 60)));
    assert!(energies.is_sorted(), "{energies:?}");
    println!("{}", energies[60] / energies[0]);
    assert!(energies[60] > 1.05 * energies[0], "{} J from {} J", energies[60], energies[0]);
}

/// Free motion and kicks are symplectic: they err in the energy by no more after a long time than after a short one.
///
/// Runge–Kutta methods drift; Gauss on (ω, q) wanders, for it keeps quadratic invariants and a top's energy is none.
#[test]
fn splittings_bound_the_energy_error_of_a_heavy_top() {
    let problem = problem(MOMENTS, RATES, &[WEIGHT]);
    let times = grid(2000.0, 4000);
    for method in enduring().filter(|method| method.information().coverage != Coverage::TorqueFree) {
        let information = method.information();
        let energies = energies(&problem, &stepped(&problem, method, 0.25, &times));
        let (early, whole) = (largest_change(&energies[..400]), largest_change(&energies));
        println!("{:20} energy error {early:.2e} in 200 s, {whole:.2e} in 2000 s", information.name);
        let is_bounded = whole < 2.0 * early;
        assert_eq!(
            is_bounded,
            information.coverage == Coverage::ListedLoads,
            "{method:?}: {early:e} becomes {whole:e}"
        );
    }
}

/// L in the world to rounding by splitting, kicks and Moser–Veselov; |L| and the energy by the others that promise it.
#[test]
fn free_bodies_keep_momentum_and_energy() {
    let problem = problem(MOMENTS, RATES, &[]);
    let times = grid(2000.0, 4000);
    for method in enduring() {
        let states = stepped(&problem, method, 0.1, &times);
        for i in 0..states.len() {
            let length = row(&states.attitude, i).map(|component| component * component).iter().sum::<f64>().sqrt();
            assert!((length - 1.0).abs() < UNIT_LIMIT, "{method:?}: |q| = {length}");
        }
        let momenta = (0..states.len()).map(|i| momentum_in_world(problem.moments, &state(&states, i)));
        let sizes: Vec<f64> = momenta.clone().map(|momentum| momentum.norm()).collect();
        let start = momentum_in_world(problem.moments, &problem.initial);
        let turned = momenta.map(|momentum| (momentum - start).norm() / start.norm()).fold(0.0, f64::max);
        let energies = energies(&problem, &states);
        let (size, early, whole) =
            (largest_change(&sizes), largest_change(&energies[..400]), largest_change(&energies));
        println!("{:20} |L| {size:.1e}  L {turned:.1e}  energy {early:.1e} {whole:.1e}", method.information().name);
        match method {
            FixedStepMethod::Rk4 | FixedStepMethod::Rkmk4 => assert!(size > 1e-6 && whole > 5.0 * early, "{method:?}"),
            FixedStepMethod::Gauss4 | FixedStepMethod::Gauss6 => {
                assert!(size < COMPENSATED_LIMIT && whole < COMPENSATED_LIMIT, "{method:?}: {size:e}, {whole:e}");
            }
            _ => {
                assert!(turned < MOMENTUM_LIMIT, "{method:?}: {turned:e}");
                assert!(whole < 1.1 * early + MOMENTUM_LIMIT, "{method:?}: {early:e} becomes {whole:e}");
            }
        }
    }
}

/// The discrete motion of Moser and Veselov lies on the polhode, whatever the step.
#[test]
fn discrete_moser_veselov_keeps_the_energy() {
    let problem = problem(MOMENTS, RATES, &[]);
    for method in
        FixedStepMethod::ALL.into_iter().filter(|method| method.information().coverage == Coverage::TorqueFree)
    {
        let energies = energies(&problem, &stepped(&problem, method, 0.4, &grid(400.0, 1000)));
        let change = largest_change(&energies);
        assert!(change < MOMENTUM_LIMIT, "{method:?}: {change:e}");
    }
}

/// The step of kicks is set by the torque: between kicks nothing is approximated.
#[test]
fn kicks_without_a_torque_are_exact() {
    let problem = problem(MOMENTS, RATES, &[]);
    let times = grid(END, 3);
    let exact = run(Taylor::new(&problem, 1e-16).expect("covered"), &times);
    let (attitude, _) = differences(&stepped(&problem, FixedStepMethod::Kicks2, 2.0, &times), &exact);
    assert!(attitude < 2e-15, "{attitude:e} rad");
}

#[test]
fn what_a_method_does_not_cover_is_refused() {
    let torque_free = problem(MOMENTS, RATES, &[]);
    let gyrostat = problem(MOMENTS, RATES, &[Torque::Rotor { momentum: profile(1.0) }]);
    let heavy = problem(MOMENTS, RATES, &[WEIGHT]);
    for method in FixedStepMethod::ALL {
        let information = method.information();
        let found = FixedStep::new(&heavy, method, 0.1);
        assert_eq!(found.is_ok(), information.coverage != Coverage::TorqueFree, "{method:?}");
        let found = FixedStep::new(&gyrostat, method, 0.1);
        assert_eq!(found.is_ok(), information.coverage == Coverage::Everything, "{method:?}");
        for step in [0.0, -0.1, f64::NAN, f64::INFINITY] {
            let refused = FixedStep::new(&torque_free, method, step).err();
            let title = information.title;
            assert!(
                matches!(refused, Some(PropagationError::NotCovered { method, .. }) if method == title),
                "{method:?} takes a step of {step}"
            );
        }
    }
}

/// A step too long for the iteration is an error, not a wrong motion.
#[test]
fn implicit_methods_say_when_they_find_no_solution() {
    let problem = problem(MOMENTS, RATES, &[]);
    for method in [FixedStepMethod::Gauss4, FixedStepMethod::Dmv2] {
        let mut propagator = FixedStep::new(&problem, method, 5.0).expect("covered");
        let error = propagator.fill(&[5.0], &mut States::default()).expect_err("no solution");
        assert!(matches!(error, PropagationError::NoConvergence { time: 0.0, step: 5.0 }), "{error}");
    }
}
