//! Laws of torque-free rotation that hold whatever the digits: conservation, continuity between the forms of the solution,
//! the geometric phase, and independence of how it is asked.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use polhode::body::{AngularVelocity, Attitude, PrincipalMoments, State};
use polhode::dynamics::{Load, Problem, Torque, Window};
use polhode::numerics::{DoubleDouble, complete_k};
use polhode::propagation::{FreeRotation, PropagationError, Propagator, States};
use proptest::prelude::*;

fn problem(moments: [f64; 3], omega: [f64; 3]) -> Problem {
    Problem {
        moments: PrincipalMoments::new(moments).expect("moments of a body"),
        mass: Some(2.0),
        initial: State {
            attitude: Attitude::new([0.5, -0.1, 0.7, 0.5]).expect("unit"),
            angular_velocity: AngularVelocity::new(omega).expect("finite"),
            position: Vector3::new(1.0, -2.0, 3.0),
            velocity: Vector3::new(0.5, 0.25, 8.0),
        },
        loads: Vec::new(),
        gravity: Vector3::new(0.0, 0.0, -9.81),
        wants_attitude: true,
        wants_translation: false,
    }
}

fn states(problem: &Problem, times: &[f64]) -> States {
    let mut states = States::default();
    let mut motion = FreeRotation::new(problem).expect("nothing acts");
    motion.fill(times, &mut states).expect("times ascend");
    states
}

fn attitude(states: &States, row: usize) -> UnitQuaternion<f64> {
    let [w, x, y, z] = [0, 1, 2, 3].map(|k| states.attitude[k][row]);
    UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z))
}

fn omega(states: &States, row: usize) -> Vector3<f64> {
    Vector3::from([0, 1, 2].map(|k| states.angular_velocity[k][row]))
}

fn angle(a: &UnitQuaternion<f64>, b: &UnitQuaternion<f64>) -> f64 {
    Attitude::from_world_from_body(*a).angle_to(Attitude::from_world_from_body(*b))
}

/// Largest differences of attitude (rad) and ω (relative) between two motions.
fn distance(a: &Problem, b: &Problem, times: &[f64]) -> (f64, f64) {
    let (a, b) = (states(a, times), states(b, times));
    (0..times.len()).fold((0.0, 0.0), |(turn, rate): (f64, f64), row| {
        let difference = (omega(&a, row) - omega(&b, row)).norm() / omega(&a, row).norm();
        (turn.max(angle(&attitude(&a, row), &attitude(&b, row))), rate.max(difference))
    })
}

/// Every 0.37 s for a quarter of a minute.
fn times() -> Vec<f64> {
    (0..40).map(|k| f64::from(k) * 0.37).collect()
}

#[test]
fn moments_through_equality_meet_the_symmetric_form() {
    // One ulp of a moment is 2e-16 of the rates: 15 s at 3 rad/s make 1e-14 of it.
    const LIMIT: f64 = 3e-14;
    for (symmetric, omega) in [
        ([1.0, 1.0, 1.6], [0.3, -0.8, 2.0]),
        ([1.0, 1.0, 1.6], [0.3, -0.8, 1e-3]),
        ([1.6, 0.7, 1.6], [1.0, 2.0, -0.4]),
        ([0.4, 1.5, 1.5], [5.0, -0.3, 0.6]),
        ([1.0, 1.0, 1.0], [5.0, -0.3, 0.6]),
    ] {
        for axis in 0..3 {
            for sign in [-1.0, 1.0] {
                let mut near: [f64; 3] = symmetric;
                near[axis] += sign * near[axis] * f64::EPSILON;
                let (turn, rate) = distance(&problem(symmetric, omega), &problem(near, omega), &times());
                assert!(turn < LIMIT && rate < LIMIT, "{near:?}, {omega:?}: {turn:e} rad, {rate:e}");
            }
        }
    }
}

#[test]
fn perturbations_through_zero_meet_the_spin_about_an_axis() {
    for (axis, growth) in [(0, 1.0), (2, 1.0), (1, 4e8)] {
        // About the middle axis a perturbation grows as e^(0.577 · 2 t): 4e8 for the 15 s here, and well under that.
        let mut spin = [0.0; 3];
        spin[axis] = -2.0;
        for size in [1e-100, 1e-30, 1e-18] {
            for sign in [-1.0, 1.0] {
                let mut near = spin;
                near[(axis + 1) % 3] = sign * size;
                near[(axis + 2) % 3] = 0.4 * size;
                let (turn, rate) = distance(&problem([1.0, 2.0, 3.0], spin), &problem([1.0, 2.0, 3.0], near), &times());
                let limit = 1e-15 + 4.0 * size * growth;
                assert!(turn < limit && rate < limit, "{near:?}: {turn:e} rad, {rate:e}");
            }
        }
    }
}

#[test]
fn motions_on_both_sides_meet_the_separatrix() {
    let exact = problem([1.0, 2.0, 2.25], [0.75, -2.0, 1.0]);
    for offset in [1e-9, 1e-12, f64::EPSILON] {
        for sign in [-1.0, 1.0] {
            let near = problem([1.0, 2.0, 2.25], [0.75 * (1.0 + sign * offset), -2.0, 1.0]);
            // Up to the saddle and 3 s beyond; the offset grows like the hyperbolic functions it starts.
            let (turn, rate) = distance(&exact, &near, &[0.0, 0.5, 1.0, 2.0, 4.0, 8.0]);
            let limit = 2e-15 + 100.0 * offset;
            assert!(turn < limit && rate < limit, "{sign} {offset:e}: {turn:e} rad, {rate:e}");
        }
    }
}

#[test]
fn body_turns_about_momentum_by_dynamic_less_geometric_phase() {
    let (moments, initial): ([f64; 3], [f64; 3]) = ([1.0, 2.0, 3.0], [0.0, 0.6, 1.5]);
    let inertia = Vector3::from(moments);
    let start = Vector3::from(initial);
    let (l_squared, twice_energy) =
        (inertia.component_mul(&start).norm_squared(), start.dot(&inertia.component_mul(&start)));
    let [i1, i2, i3] = moments;
    let lambda_squared = (i3 - i2) * (l_squared - twice_energy * i1) / (i1 * i2 * i3);
    let complement = (i3 - i1) * (l_squared - twice_energy * i2) / ((i3 - i2) * (l_squared - twice_energy * i1));
    let period = 4.0 * complete_k(DoubleDouble::from(complement.sqrt())).hi() / lambda_squared.sqrt();

    // The solid angle of the unit momentum's curve about axis 3, ∮ (1 − l₃) dφ, by the trapezium rule, which converges
    // exponentially for a periodic integrand.
    let count: u16 = 256;
    let instants: Vec<f64> = (0..=count).map(|k| period * f64::from(k) / f64::from(count)).collect();
    let states = states(&problem(moments, initial), &instants);
    let length = l_squared.sqrt();
    let solid_angle: f64 = (0..usize::from(count))
        .map(|row| {
            let rates = omega(&states, row);
            let l = inertia.component_mul(&rates) / length;
            let l_dot = l.cross(&rates);
            (1.0 - l.z) * (l.x * l_dot.y - l.y * l_dot.x) / (l.x * l.x + l.y * l.y) * period / f64::from(count)
        })
        .sum();
    // Counter-clockwise about axis 3 is positive; the curve runs against it.
    let turned = twice_energy * period / length - solid_angle;
    let (first, last) = (attitude(&states, 0), attitude(&states, usize::from(count)));
    let momentum = first * inertia.component_mul(&start) / length;
    let expected = UnitQuaternion::from_scaled_axis(momentum * turned) * first;
    assert!((omega(&states, usize::from(count)) - start).norm() < 1e-14, "one period");
    assert!(angle(&expected, &last) < 1e-12, "{:e} rad", angle(&expected, &last));
}

#[test]
fn rates_alone_are_the_rates_with_attitude_and_batches_do_not_matter() {
    let instants = times();
    for (moments, omega) in [
        ([3.0, 1.0, 2.0], [0.3, -5.0, 0.4]),
        ([3.0, 1.0, 2.0], [1e-3, 1e-3, 5.0]),
        ([1.0, 1.6, 1.0], [0.3, -5.0, 0.4]),
        ([1.0, 1.0, 1.0], [0.3, -5.0, 0.4]),
        ([1.0, 2.0, 2.25], [0.75, -2.0, 1.0]),
    ] {
        let mut asked = problem(moments, omega);
        let together = states(&asked, &instants);
        let mut motion = FreeRotation::new(&asked).expect("nothing acts");
        let mut part = States::default();
        let mut row = 0;
        for batch in [&instants[..1], &instants[1..14], &instants[14..]] {
            motion.fill(batch, &mut part).expect("times ascend");
            for k in 0..batch.len() {
                assert_eq!(attitude(&part, k), attitude(&together, row));
                row += 1;
            }
        }
        assert_eq!(motion.effort().evaluations, 40);
        asked.wants_attitude = false;
        let alone = states(&asked, &instants);
        assert_eq!(alone.angular_velocity, together.angular_velocity);
        assert!(alone.attitude[0].is_empty());
    }
}

#[test]
fn units_do_not_matter_to_the_last_bit() {
    // Powers of two, so that the inputs scale exactly: 1e-75 to 1e75 of kg m² and rad/s.
    let instants = times();
    for (moments, omega) in [
        ([3.0, 1.0, 2.0], [0.3, -5.0, 0.4]),
        ([3.0, 1.0, 2.0], [1e-3, 1e-3, 5.0]),
        ([1.0, 1.6, 1.0], [0.3, -5.0, 0.4]),
        ([1.0, 1.0, 1.0], [0.3, -5.0, 0.4]),
        ([1.0, 2.0, 2.25], [0.75, -2.0, 1.0]),
    ] {
        let plain = states(&problem(moments, omega), &instants);
        for power in [-250, 250] {
            let unit = 2.0_f64.powi(power);
            let scaled = problem(moments.map(|moment: f64| moment * unit), omega.map(|rate: f64| rate * unit));
            let other = states(&scaled, &instants.iter().map(|time| time / unit).collect::<Vec<_>>());
            assert_eq!(plain.attitude, other.attitude, "{moments:?} × 2^{power}");
            for axis in 0..3 {
                let back: Vec<f64> = other.angular_velocity[axis].iter().map(|rate| rate / unit).collect();
                assert_eq!(plain.angular_velocity[axis], back, "{moments:?} × 2^{power}");
            }
        }
    }
}

#[test]
fn reference_point_falls_while_the_body_tumbles() {
    let mut falling = problem([1.0, 2.0, 3.0], [1.0, 2.0, 1.5]);
    falling.wants_translation = true;
    let states = states(&falling, &[0.0, 2.0]);
    assert_eq!(states.position.map(|column| column[1]), [2.0, -1.5, 3.0 + 16.0 - 0.5 * 9.81 * 4.0]);
    assert_eq!(states.velocity.map(|column| column[1]), [0.5, 0.25, 8.0 - 9.81 * 2.0]);
}

#[test]
fn loads_and_disordered_times_are_refused() {
    let mut loaded = problem([1.0, 2.0, 3.0], [1.0, 2.0, 1.5]);
    let torque = Torque::ConstantBody { moment: Vector3::x() };
    loaded.loads.push(Load { torque, window: Window::ALWAYS });
    assert!(matches!(FreeRotation::new(&loaded), Err(PropagationError::NotCovered { .. })));
    loaded.loads.clear();
    let mut motion = FreeRotation::new(&loaded).expect("nothing acts");
    let mut states = States::default();
    let disordered = motion.fill(&[1.0, 0.5], &mut states);
    assert_eq!(disordered, Err(PropagationError::NotAscending { time: 0.5, previous: 1.0 }));
    for endless in [f64::NAN, f64::INFINITY, f64::MAX] {
        assert_eq!(motion.fill(&[endless], &mut states), Err(PropagationError::NotFinite { time: 1.0 }));
    }
}

/// Moments of two to five random points: always those of a possible body, in any order.
fn moments() -> impl Strategy<Value = [f64; 3]> {
    ([0.0..1.0, 0.0..1.0, 0.01..1.0], -3..4_i32).prop_map(|([a, b, c], power): ([f64; 3], i32)| {
        let scale = 10.0_f64.powi(power);
        [b + c, a + c, a + b].map(|moment| scale * (moment + 1e-6))
    })
}

fn rates() -> impl Strategy<Value = [f64; 3]> {
    let one = || (-1.0..1.0_f64, 0..14_i32).prop_map(|(x, power)| x * 10.0_f64.powi(-power));
    ([one(), one(), one()], -3..4_i32)
        .prop_map(|(rates, power)| rates.map(|rate| (rate + 1e-15) * 10.0_f64.powi(power)))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn energy_and_momentum_stay_to_rounding(moments in moments(), rates in rates(), span in 0.1..1e6_f64) {
        let inertia = Vector3::from(moments);
        let problem = problem(moments, rates);
        let size = Vector3::from(rates).norm();
        let states = states(&problem, &[0.0, 0.21, 0.37, 0.74, 1.0].map(|part| part * span / size));
        let momentum = |row| attitude(&states, row) * inertia.component_mul(&omega(&states, row));
        let energy = |row| omega(&states, row).component_mul(&omega(&states, row)).dot(&inertia);
        for row in 0..5 {
            let drift = (momentum(row) - momentum(0)).norm() / momentum(0).norm();
            prop_assert!(drift < 4e-15, "L drifts by {drift:e}");
            prop_assert!((energy(row) / energy(0) - 1.0).abs() < 4e-15, "E drifts by {:e}", energy(row) / energy(0) - 1.0);
            prop_assert!((attitude(&states, row).norm() - 1.0).abs() < 4e-16);
        }
    }

    #[test]
    fn state_on_the_way_starts_the_same_motion(moments in moments(), rates in rates(), turns in 0.1..3.0_f64) {
        // The state on the way is rounded: a few ulps, times the turns and the stretching of the saddle, e^(2π·3) at most
        // but for the part of it that a polhode near the saddle really meets.
        let problem = problem(moments, rates);
        let size = Vector3::from(rates).norm();
        let (half, whole) = (turns / size, 2.0 * turns / size);
        let through = states(&problem, &[0.0, half, whole]);
        let mut restarted = problem.clone();
        restarted.initial.attitude = Attitude::from_world_from_body(attitude(&through, 1));
        restarted.initial.angular_velocity = AngularVelocity::new(omega(&through, 1).into()).expect("finite");
        let rest = states(&restarted, &[half]);
        prop_assert!(angle(&attitude(&rest, 0), &attitude(&through, 2)) < 2e-13);
        prop_assert!((omega(&rest, 0) - omega(&through, 2)).norm() < 2e-13 * size);
    }
}
