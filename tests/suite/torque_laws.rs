//! What torques must do, whatever the method: impulse laws, conserved quantities, published and derived values.

use nalgebra::Vector3;
use polhode::body::{Attitude, State};
use polhode::dynamics::{
    Load, Problem, Torque, Window, jacobi_integral, momentum_in_world, potential_energy, rotational_energy,
    translational_energy,
};
use polhode::propagation::{LagrangeTop, Propagator, States, Taylor};

use crate::motions::{MOMENTS, RATES, differences, every_torque, grid, problem, row, run, state};

const TIGHTEST: f64 = 1e-16;
/// What rounding may do to a momentum or energy over a few hundred steps, relative.
const ROUNDING: f64 = 2e-14;

fn taylor(problem: &Problem) -> Taylor {
    Taylor::new(problem, TIGHTEST).expect("covered")
}

fn momentum(problem: &Problem, state: &State) -> Vector3<f64> {
    momentum_in_world(problem.moments, state)
}

#[track_caller]
fn assert_near(found: f64, expected: f64, limit: f64) {
    assert!((found - expected).abs() <= limit, "{found} is {:e} from {expected}", found - expected);
}

#[test]
fn constant_world_torque_feeds_momentum_linearly() {
    let moment = Vector3::new(0.05, -0.02, 0.1);
    let problem = problem(MOMENTS, RATES, &[Torque::ConstantWorld { moment }]);
    let times = grid(60.0, 40);
    let states = run(taylor(&problem), &times);
    let start = momentum(&problem, &problem.initial);
    for (i, time) in times.iter().enumerate() {
        let expected = start + moment * *time;
        let error = (momentum(&problem, &state(&states, i)) - expected).norm();
        assert!(error < ROUNDING * expected.norm().max(1.0), "t = {time}: {error:e}");
    }
}

#[test]
fn pulses_add_their_impulses() {
    let mut problem = problem(MOMENTS, RATES, &[]);
    let pulses = [
        (Vector3::new(0.6, 0.0, -0.3), 0.3337, 1.7129),
        (Vector3::new(0.0, 0.4, 0.2), 1.05, 4.3071),
        (Vector3::new(1e3, 0.0, 0.0), 6.0, 6.000_01),
    ];
    let mut impulse = Vector3::zeros();
    for (moment, start, end) in pulses {
        problem.loads.push(Load { torque: Torque::ConstantWorld { moment }, window: Window { start, end } });
        impulse += moment * (end - start);
    }
    let states = run(taylor(&problem), &[10.0]);
    let change = momentum(&problem, &state(&states, 0)) - momentum(&problem, &problem.initial);
    assert!((change - impulse).norm() < ROUNDING, "{change} for {impulse}");
}

#[test]
fn spin_up_is_linear() {
    let torque = Torque::ConstantBody { moment: Vector3::new(0.0, 0.0, 0.25) };
    let times = grid(40.0, 16);
    let states = run(taylor(&problem([1.2, 0.9, 0.6], [0.0, 0.0, 0.5], &[torque])), &times);
    for (i, time) in times.iter().enumerate() {
        let [x, y, z] = row(&states.angular_velocity, i);
        assert_eq!([x, y], [0.0, 0.0]);
        assert_near(z, 0.5 + 0.25 * time / 0.6, 4.0 * f64::EPSILON * z);
    }
}

#[test]
fn damping_of_a_ball_is_exponential() {
    let problem = problem([2.0; 3], RATES, &[Torque::LinearDamping { coefficient: 0.3 }]);
    let times = grid(200.0, 20);
    let states = run(taylor(&problem), &times);
    for (i, time) in times.iter().enumerate() {
        for (found, start) in row(&states.angular_velocity, i).into_iter().zip(RATES) {
            let expected = start * libm::exp(-0.15 * time);
            assert_near(found, expected, ROUNDING * expected.abs());
        }
    }
}

/// ω₊' = iσ(ω₃₀ + τt/I₃)ω₊ + τ₁/I₁ from rest: quadrature of the Fresnel form, ten digits.
#[test]
fn transverse_torque_on_a_body_that_spins_up() {
    let moment = Vector3::new(0.2, 0.0, 0.3);
    let problem = problem([2.0, 2.0, 3.0], [0.0, 0.0, 1.0], &[Torque::ConstantBody { moment }]);
    let [x, y, z] = row(&run(taylor(&problem), &[20.0]).angular_velocity, 0);
    assert_near(x, 0.180_913_491_2, 5e-11);
    assert_near(y, 0.017_834_477_0, 5e-11);
    assert_near(z, 3.0, 1e-14);
}

/// The transverse rates of a symmetric body turn by σ(ω₃₀ t + a t²/2), their length unchanged.
#[test]
fn axial_torque_makes_a_chirp() {
    let moment = Vector3::new(0.0, 0.0, 0.3);
    let problem = problem([2.0, 2.0, 3.0], [0.3, 0.0, 1.0], &[Torque::ConstantBody { moment }]);
    let [x, y, z] = row(&run(taylor(&problem), &[20.0]).angular_velocity, 0);
    assert_near(x, 0.122_424_618_5, 5e-11);
    assert_near(y, 0.273_883_575_2, 5e-11);
    assert_near(z, 3.0, 1e-14);
}

#[test]
fn heavy_top_keeps_energy_and_two_momenta() {
    let weight = Torque::ForceWorld { force: Vector3::new(0.0, 0.0, -4.905), arm: Vector3::new(0.0, 0.0, 0.04) };
    let problem = problem([0.002, 0.002, 0.0012], [0.0, -2.0, 60.0], std::slice::from_ref(&weight));
    let times = grid(5.0, 50);
    let states = run(taylor(&problem), &times);
    let laws = |time: f64, state: &State| {
        let at_pivot = State { position: Vector3::zeros(), ..*state };
        let potential = potential_energy(&weight, problem.moments, time, &at_pivot).expect("a potential");
        let energy = rotational_energy(problem.moments, state) + potential;
        // Each with its scale: lying down, the top has no momentum about the vertical.
        let spin = 60.0;
        [
            (energy, energy.abs()),
            (momentum(&problem, state).z, 0.0012 * spin),
            (state.angular_velocity.in_body().z, spin),
        ]
    };
    let start = laws(0.0, &problem.initial);
    for (i, time) in times.iter().enumerate() {
        for ((found, _), (expected, scale)) in laws(*time, &state(&states, i)).into_iter().zip(start) {
            assert_near(found, expected, ROUNDING * scale);
        }
    }
}

/// τ = m × B is normal to both: no work but what the potential −m·B gives back, no momentum along B.
#[test]
fn dipole_in_a_field_keeps_energy_and_the_momentum_along_the_field() {
    let (dipole, field) = (Vector3::new(0.3, -0.4, 0.2), Vector3::new(0.5, 0.2, -0.9));
    let mut problem = problem(MOMENTS, RATES, &[Torque::MagneticDipole { dipole, field }]);
    // Nothing but the rotation.
    problem.mass = None;
    let times = grid(60.0, 50);
    let states = run(taylor(&problem), &times);
    let law = problem.momentum_law().expect("along the field");
    assert_near(law.axis.expect("one component").dot(&field), field.norm(), 1e-15);
    let laws = |state: &State| {
        let energy = rotational_energy(problem.moments, state) - dipole.dot(&state.attitude.to_body(&field));
        [energy, momentum(&problem, state).dot(&field)]
    };
    let start = laws(&problem.initial);
    assert_near(problem.total_energy(0.0, &problem.initial).0, start[0], 1e-15);
    for i in 0..times.len() {
        for (found, expected) in laws(&state(&states, i)).into_iter().zip(start) {
            assert_near(found, expected, ROUNDING);
        }
    }
}

/// A needle across the field in a plane: the period of the pendulum, 4 K(sin ½θ₀) √(I/mB), here for 90°.
#[test]
fn compass_needle_swings_as_a_pendulum() {
    let needle = Torque::MagneticDipole { dipole: Vector3::z() * 0.5, field: Vector3::z() * 0.25 };
    let mut problem = problem([2.0, 2.0, 0.1], [0.0; 3], &[needle]);
    let turn = std::f64::consts::FRAC_1_SQRT_2;
    problem.initial.attitude = Attitude::new([turn, turn, 0.0, 0.0]).expect("a unit quaternion");
    assert!(LagrangeTop::covers(&problem));
    // K(m = ½) = 1.8540746773013719, [DLMF] §19.
    let period = 4.0 * 1.854_074_677_301_371_9 * 4.0;
    let times = [0.25 * period, 0.5 * period, period];
    for states in [run(taylor(&problem), &times), run(LagrangeTop::new(&problem).expect("a top"), &times)] {
        let across = |i: usize| state(&states, i).attitude.to_world(&Vector3::z());
        assert!((across(0) - Vector3::z()).norm() < 1e-13, "{}", across(0));
        assert!((across(1) - Vector3::y()).norm() < 1e-13, "{}", across(1));
        assert!((across(2) + Vector3::y()).norm() < 1e-13, "{}", across(2));
        // At the bottom all of the potential energy: I ω² / 2 = m B.
        let fastest = row(&states.angular_velocity, 0)[0].abs();
        assert_near(fastest, libm::sqrt(2.0 * 0.125 / 2.0), 1e-15);
    }
}

#[test]
fn gravity_gradient_keeps_the_jacobi_integral() {
    let n = 0.0011;
    let problem = problem([20.0, 32.0, 40.0], [2e-5, -3e-5, 0.001_12], &[Torque::GravityGradient { mean_motion: n }]);
    let times = grid(60_000.0, 50);
    let states = run(taylor(&problem), &times);
    let start = jacobi_integral(n, problem.moments, 0.0, &problem.initial);
    for (i, time) in times.iter().enumerate() {
        assert_near(jacobi_integral(n, problem.moments, *time, &state(&states, i)), start, ROUNDING * start.abs());
    }
}

#[test]
fn force_in_the_world_keeps_energy_and_makes_a_parabola() {
    let force = Vector3::new(0.5, 0.2, -0.4);
    let torque = Torque::ForceWorld { force, arm: Vector3::new(0.3, -0.1, 0.2) };
    let mut problem = problem(MOMENTS, RATES, std::slice::from_ref(&torque));
    problem.wants_translation = true;
    let times = grid(20.0, 20);
    let states = run(taylor(&problem), &times);
    let energy = |time: f64, state: &State| {
        let potential = potential_energy(&torque, problem.moments, time, state).expect("a potential");
        rotational_energy(problem.moments, state) + translational_energy(2.0, state) + potential
    };
    let start = energy(0.0, &problem.initial);
    for (i, &time) in times.iter().enumerate() {
        let state = state(&states, i);
        let State { position, velocity, .. } = problem.initial;
        let expected = position + velocity * time + force * (0.25 * time * time);
        assert!((state.position - expected).norm() < ROUNDING * expected.norm(), "t = {time}");
        assert_near(energy(time, &state), start, ROUNDING * translational_energy(2.0, &state).max(start.abs()));
    }
}

#[test]
fn thruster_pushes_along_the_body() {
    // Spinning about z with a thruster along x through the centre of mass: v' = F/m (cos ωt, sin ωt), turned once.
    let torque = Torque::ForceBody { force: Vector3::new(3.0, 0.0, 0.0), arm: Vector3::new(-0.2, 0.0, 0.0) };
    let mut problem = problem(MOMENTS, [0.0, 0.0, 1.5], &[torque]);
    problem.wants_translation = true;
    let times = grid(20.0, 10);
    let states = run(taylor(&problem), &times);
    for (i, &time) in times.iter().enumerate() {
        let (sine, cosine) = libm::sincos(1.5 * time);
        let gained = problem.initial.attitude.to_world(&Vector3::new(sine, 1.0 - cosine, 0.0)) * (1.5 / 1.5);
        let turned = Vector3::new(1.0 - cosine, 1.5 * time - sine, 0.0) * (1.0 / 1.5);
        let State { position, velocity, .. } = problem.initial;
        let moved = position + velocity * time + problem.initial.attitude.to_world(&turned);
        assert!((state(&states, i).velocity - velocity - gained).norm() < ROUNDING, "t = {time}");
        assert!((state(&states, i).position - moved).norm() < ROUNDING * moved.norm(), "t = {time}");
    }
}

/// The recurrence of every kind says the same as its formula: the rates' first derivative, by a short difference.
#[test]
fn recurrences_agree_with_the_formulae() {
    const SHORT: f64 = 1e-7;
    for (name, torque) in every_torque() {
        let problem = problem(MOMENTS, RATES, std::slice::from_ref(&torque));
        let states = run(taylor(&problem), &[SHORT]);
        let omega = Vector3::from(RATES);
        let inertia = problem.moments.vector();
        let moment = torque.moment(problem.moments, 0.0, &problem.initial);
        let expected = (inertia.component_mul(&omega).cross(&omega) + moment).component_div(&inertia);
        let found = (Vector3::from(row(&states.angular_velocity, 0)) - omega) / SHORT;
        assert!((found - expected).norm() < 1e-6, "{name}: {found} for {expected}");
    }
}

#[test]
fn how_the_times_are_dealt_out_changes_no_bit() {
    let torques: Vec<Torque> = every_torque().into_iter().map(|(_, torque)| torque).collect();
    let mut problem = problem(MOMENTS, RATES, &torques);
    problem.wants_translation = true;
    problem.loads[1].window = Window { start: 1.25, end: 3.5 };
    // An edge and the times beside it are among the samples, and one time comes twice.
    let mut times = grid(10.0, 400);
    times.push(10.0);
    let together = run(taylor(&problem), &times);
    for lot in [1, 7, 100] {
        let (mut propagator, mut part, mut row_of_all) = (taylor(&problem), States::default(), 0);
        for times in times.chunks(lot) {
            propagator.fill(times, &mut part).expect("a finite motion");
            for i in 0..part.len() {
                assert_eq!(state(&part, i), state(&together, row_of_all));
                row_of_all += 1;
            }
        }
    }
}

#[test]
fn starting_again_from_a_later_state_gives_the_same_motion() {
    for (name, torque) in every_torque() {
        // The gravity gradient knows what time it is, and so do functions of time.
        if matches!(torque, Torque::GravityGradient { .. }) || torque.profile().is_some() {
            continue;
        }
        let whole = problem(MOMENTS, RATES, &[torque]);
        let states = run(taylor(&whole), &[4.0, 9.0]);
        let rest = Problem { initial: state(&states, 0), ..whole.clone() };
        let (attitude, rates) = differences(&run(taylor(&rest), &[0.0, 5.0]), &states);
        assert!(attitude < 2e-14 && rates < 2e-14, "{name}: {attitude:e} rad, {rates:e} rad/s");
    }
}

#[test]
fn a_window_is_the_sum_of_its_halves() {
    for (name, torque) in every_torque() {
        let mut whole = problem(MOMENTS, RATES, &[torque]);
        whole.loads[0].window = Window { start: 1.1, end: 5.3 };
        let mut halves = whole.clone();
        halves.loads.push(halves.loads[0].clone());
        halves.loads[0].window.end = 2.7;
        halves.loads[1].window.start = 2.7;
        let times = grid(8.0, 32);
        let (attitude, rates) = differences(&run(taylor(&halves), &times), &run(taylor(&whole), &times));
        assert!(attitude < 2e-14 && rates < 2e-14, "{name}: {attitude:e} rad, {rates:e} rad/s");
    }
}

#[test]
fn many_forces_act_as_their_sum() {
    let force = |i: f64| Torque::ForceWorld {
        force: Vector3::new(0.3 * i, 0.7 - i, 0.2),
        arm: Vector3::new(0.1, 0.05 * i, -0.2 * i),
    };
    let torques: Vec<Torque> = (1..6).map(|i| force(f64::from(i))).collect();
    let problem = problem(MOMENTS, RATES, &torques);
    let dop853 = polhode::propagation::Dop853::new(&problem, 1e-13).expect("covered");
    let times = grid(3.0, 6);
    let (attitude, rates) = differences(&run(dop853, &times), &run(taylor(&problem), &times));
    assert!(attitude < 1e-11 && rates < 1e-11, "{attitude:e} rad, {rates:e} rad/s");
}
