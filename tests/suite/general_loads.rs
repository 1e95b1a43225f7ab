//! Loads that go by a tape of operations: against the recurrences laid out by hand, closed forms and laws.

use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};
use polhode::dynamics::formula::Expression;
use polhode::dynamics::{
    BDot, FormulaLoad, FormulaPlace, General, GeneralLoad, InnerSphere, Load, Problem, QuaternionFeedback,
    RateFeedback, Spring, Torque, Window,
};
use polhode::propagation::{Dop853, PreciseTaylor, Propagator, States, Taylor, attitude_distance};

use crate::motions::{MOMENTS, RATES, every_torque, grid, problem, row, run};

/// The tightest tolerance of a step.
const TIGHTEST: f64 = 1e-16;

fn general(kind: General) -> Torque {
    Torque::General(Arc::new(GeneralLoad::new(kind)))
}

/// A moment by formulae, in body axes that are principal axes.
fn formula(texts: [&str; 3], in_world: bool) -> Torque {
    general(General::Formula(FormulaLoad {
        components: texts.map(|text| Expression::read(text).expect("a formula")),
        in_world,
        place: FormulaPlace::Moment,
        body_from_principal: UnitQuaternion::identity(),
    }))
}

/// A load that does nothing, and sends all others by the tape.
fn nothing() -> Torque {
    formula(["0", "0", "0"], false)
}

/// The largest difference of attitudes, rad, and of rates, rad/s.
fn apart(a: &States, b: &States) -> f64 {
    let rates = a.angular_velocity.iter().zip(&b.angular_velocity).flat_map(|(a, b)| a.iter().zip(b));
    rates.map(|(a, b)| (a - b).abs()).fold(attitude_distance(a, b), f64::max)
}

/// Every listed load by the tape moves the body as by the recurrences laid out by hand: in f64 to the rounding of both, in
/// double-double to 1e-28.
#[test]
fn the_tape_moves_bodies_as_the_recurrences_do() {
    let times = grid(10.0, 20);
    for (name, torque) in every_torque() {
        for wants_translation in [false, true] {
            let by_hand = Problem { wants_translation, ..problem(MOMENTS, RATES, std::slice::from_ref(&torque)) };
            let by_tape = Problem { wants_translation, ..problem(MOMENTS, RATES, &[torque.clone(), nothing()]) };
            let [hand, tape] =
                [&by_hand, &by_tape].map(|problem| run(Taylor::new(problem, TIGHTEST).expect("covered"), &times));
            let off = apart(&hand, &tape);
            assert!(off < 2e-14, "{name}: {off:e}");
            if wants_translation {
                for i in 0..times.len() {
                    let (a, b) = (Vector3::from(row(&hand.position, i)), Vector3::from(row(&tape.position, i)));
                    assert!((a - b).norm() <= 1e-14 * a.norm(), "{name}: {} m", (a - b).norm());
                }
            }
            let [hand, tape] = [&by_hand, &by_tape].map(|problem| {
                PreciseTaylor::new(problem).expect("covered").at(1.0).expect("finite").expect("within reach")
            });
            let pairs = hand.attitude.iter().zip(tape.attitude);
            let pairs = pairs.chain(hand.angular_velocity.iter().zip(tape.angular_velocity));
            let off = pairs.map(|(a, b)| (*a - b).abs().hi()).fold(0.0, f64::max);
            assert!(off < 1e-28, "{name}: {off:e} in double-double");
        }
    }
}

/// A body at rest under τ = 0.1 sin 2t about one axis: ω = 0.05 (1 − cos 2t)/I, φ = 0.05 (t − sin 2t / 2)/I.
#[test]
fn a_formula_of_time_turns_a_body_by_its_integral() {
    let body = problem(MOMENTS, [0.0; 3], &[formula(["0", "0", "0.1*sin(2*t)"], false)]);
    let times = grid(20.0, 40);
    let states = run(Taylor::new(&body, TIGHTEST).expect("covered"), &times);
    for (i, t) in times.iter().enumerate() {
        let exact = 0.05 * (1.0 - libm::cos(2.0 * t)) / MOMENTS[2];
        let [x, y, z] = row(&states.angular_velocity, i);
        assert!((z - exact).abs() < 1e-16 && x == 0.0 && y == 0.0, "{z} for {exact} rad/s at {t} s");
    }
}

/// Formulae that say what listed loads say: damping, the moment of a force constant in the world, a gravity gradient.
#[test]
fn formulae_of_the_motion_are_the_loads_they_describe() {
    let couple =
        ["-1.6*r33*(-0.2) - 0.3*(-1.6)*r32", "0.3*(-1.6)*r31 - 0.1*(-1.6)*r33", "0.1*(-1.6)*r32 + 0.2*(-1.6)*r31"];
    let arm = Vector3::new(0.1, -0.2, 0.3);
    let cases = [
        (Torque::LinearDamping { coefficient: 0.2 }, formula(["-0.2*wx", "-0.2*wy", "-0.2*wz"], false)),
        (Torque::ConstantWorld { moment: Vector3::new(0.25, 0.5, -1.0) }, formula(["1/4", "2^-1", "-1"], true)),
        (Torque::ForceWorld { force: Vector3::new(0.0, 0.0, -1.6), arm }, formula(couple, false)),
    ];
    let times = grid(10.0, 20);
    for (listed, formula) in cases {
        let [a, b] = [&listed, &formula].map(|torque| {
            let problem = problem(MOMENTS, RATES, std::slice::from_ref(torque));
            run(Taylor::new(&problem, TIGHTEST).expect("covered"), &times)
        });
        let off = apart(&a, &b);
        assert!(off < 1e-14, "{listed:?}: {off:e}");
    }
}

/// A moment with corners, |sin 3t| and a bound on what depends on ω: the steps end on the corners, so that f64 keeps to the
/// motion in double-double to rounding, wherever the samples lie; DOP853, which steps across corners, tells the same motion.
#[test]
fn corners_are_stepped_to_and_not_across() {
    let corners =
        formula(["0.3*abs(sin(3*t))", "max(-0.1, min(0.1, -wy))", "0.2*min(cos(t), 0.3) - 0.05*abs(wx)"], false);
    let body = problem(MOMENTS, RATES, &[corners]);
    let times = grid(12.0, 30);
    let states = run(Taylor::new(&body, TIGHTEST).expect("covered"), &times);
    let mut precise = PreciseTaylor::new(&body).expect("covered");
    for (i, time) in times.iter().enumerate() {
        let exact = precise.at(*time).expect("finite").expect("within reach");
        let rates = row(&states.angular_velocity, i);
        for (found, exact) in rates.iter().zip(exact.angular_velocity) {
            assert!((found - exact.hi()).abs() < 1e-14, "{found} for {} at {time} s", exact.hi());
        }
    }
    let other = run(Dop853::new(&body, 1e-12).expect("covered"), &times);
    let off = apart(&states, &other);
    assert!(off < 1e-8, "{off:e}");
    let last = run(Taylor::new(&body, TIGHTEST).expect("covered"), &times[times.len() - 1..]);
    for (found, alone) in states.angular_velocity.iter().zip(&last.angular_velocity) {
        assert_eq!(found.last(), alone.last(), "a sample depends on those before it");
    }
}

/// A window of 2⁻³⁰ s makes a step of just that length, and the effort tells it.
#[test]
fn the_shortest_step_is_told() {
    let length = libm::exp2(-30.0);
    let mut body = problem(MOMENTS, RATES, &[formula(["0.1*wy", "0", "0"], false)]);
    body.loads[0].window = Window { start: 1.0, end: 1.0 + length };
    let mut taylor = Taylor::new(&body, TIGHTEST).expect("covered");
    taylor.fill(&[2.0], &mut States::default()).expect("a finite motion");
    assert_eq!(taylor.effort().shortest_step_s, Some(length));
}

/// A peak a thousandth of its distance wide, and zero in f64 where the run starts, is not stepped over.
#[test]
fn a_distant_peak_is_met() {
    let body = problem(MOMENTS, [0.0; 3], &[formula(["0", "0", "exp(-((t-50)*20)^2)"], false)]);
    let states = run(Taylor::new(&body, TIGHTEST).expect("covered"), &[100.0]);
    let exact = std::f64::consts::PI.sqrt() / 20.0 / MOMENTS[2];
    let found = states.angular_velocity[2][0];
    assert!((found - exact).abs() < 2e-15, "{found} for {exact} rad/s");
}

/// Windows hold for formulae as for all loads: ω gained is the integral from edge to edge.
#[test]
fn windows_cut_formulae_exactly() {
    let torque = formula(["0", "0", "t"], false);
    let mut body = problem(MOMENTS, [0.0; 3], &[]);
    body.loads = vec![Load { torque, window: Window { start: 1.3, end: 2.9 } }];
    let states = run(Taylor::new(&body, TIGHTEST).expect("covered"), &[0.7, 5.0]);
    let exact = 0.5 * (2.9 * 2.9 - 1.3 * 1.3) / MOMENTS[2];
    assert_eq!(states.angular_velocity[2][0], 0.0);
    assert!((states.angular_velocity[2][1] - exact).abs() < 1e-15);
}

/// A body about its third axis, or falling, from rest at the origin.
fn simple(rate: f64, kinds: Vec<General>) -> Problem {
    let torques: Vec<Torque> = kinds.into_iter().map(general).collect();
    let mut body = problem(MOMENTS, [0.0, 0.0, rate], &torques);
    body.initial.attitude = polhode::body::Attitude::identity();
    body.initial.position = Vector3::zeros();
    body.initial.velocity = Vector3::zeros();
    body
}

fn tight(problem: &Problem, times: &[f64]) -> States {
    run(Taylor::new(problem, TIGHTEST).expect("covered"), times)
}

/// ω = ω₀ / (1 + c ω₀ t / I) about a principal axis.
#[test]
fn quadratic_damping_slows_a_spin_as_its_closed_form() {
    let (coefficient, rate) = (0.3, 4.0);
    let body = simple(rate, vec![General::QuadraticDamping { coefficient }]);
    let times = grid(50.0, 25);
    let states = tight(&body, &times);
    for (found, t) in states.angular_velocity[2].iter().zip(&times) {
        let exact = rate / (1.0 + coefficient * rate * t / MOMENTS[2]);
        assert!((found - exact).abs() < 4e-16 * rate, "{found} for {exact} at {t} s");
    }
}

/// v = −v∞ tanh(g t / v∞), v∞ = √(m g / c), from rest: where |v| v has a corner.
#[test]
fn drag_lets_a_body_fall_as_its_closed_form() {
    let (coefficient, gravity) = (0.05, 9.81);
    let mut body = simple(0.0, vec![General::QuadraticDrag { coefficient, arm: Vector3::zeros() }]);
    body.gravity = Vector3::new(0.0, 0.0, -gravity);
    body.wants_translation = true;
    let times = grid(10.0, 20);
    let states = tight(&body, &times);
    let terminal = (2.0 * gravity / coefficient).sqrt();
    for (found, t) in states.velocity[2].iter().zip(&times) {
        let exact = -terminal * libm::tanh(gravity * t / terminal);
        assert!((found - exact).abs() < 1e-14, "{found} for {exact} m/s at {t} s");
    }
}

fn spring(arm: Vector3<f64>, is_tether: bool) -> General {
    let anchor = Vector3::new(0.0, 0.0, 1.0);
    General::Spring(Spring { anchor, arm, stiffness: 30.0, damping: 0.0, rest_length: 0.4, is_tether })
}

/// Hung by its centre, a body bounces at √(k/m); the damper takes c/2m off as it does of any oscillator.
#[test]
fn springs_bounce_at_their_frequency() {
    for damping in [0.0, 1.5] {
        let General::Spring(undamped) = spring(Vector3::zeros(), false) else { unreachable!("a spring") };
        let mut body = simple(3.0, vec![General::Spring(Spring { damping, ..undamped })]);
        body.initial.position.z = 0.3;
        body.wants_translation = true;
        let times = grid(5.0, 50);
        let states = tight(&body, &times);
        let (decay, square) = (damping / 4.0, 30.0 / 2.0);
        let frequency = libm::sqrt(square - decay * decay);
        for (found, t) in states.position[2].iter().zip(&times) {
            let (sine, cosine) = libm::sincos(frequency * t);
            let exact = 0.6 - 0.3 * libm::exp(-decay * t) * (cosine + decay / frequency * sine);
            assert!((found - exact).abs() < 1e-14, "{found} for {exact} m at {t} s");
        }
    }
}

/// Springs and tethers without dampers conserve energy, free and about a pivot, at a body point off the centre: kinetic and
/// potential energy together stay within rounding, while a tether goes slack and taut.
#[test]
fn springs_and_tethers_conserve_energy() {
    for (is_tether, is_held) in [(false, false), (true, false), (false, true), (true, true)] {
        let mut body = simple(2.0, vec![spring(Vector3::new(0.3, -0.2, 0.1), is_tether)]);
        body.initial.velocity = if is_held { Vector3::zeros() } else { Vector3::new(0.5, 0.2, 1.0) };
        body.wants_translation = !is_held;
        if is_held {
            body.mass = None;
        }
        assert!(body.energy_law().is_some());
        let times = grid(10.0, 100);
        let states = tight(&body, &times);
        let (start, _) = body.total_energy(0.0, &body.initial);
        let mut slack = 0;
        for (i, time) in times.iter().enumerate() {
            let state = crate::motions::state(&states, i);
            let (energy, scale) = body.total_energy(*time, &state);
            assert!((energy - start).abs() < 2e-14 * scale.max(start), "{energy} J for {start} J at {time} s");
            slack += usize::from(body.force(*time, &state) == Vector3::zeros());
        }
        assert!(is_held || (slack > 0) == is_tether, "slack at {slack} samples");
    }
}

fn sphere(initial: Vector3<f64>) -> InnerSphere {
    InnerSphere { inertia: 0.4, coefficient: 0.15, initial }
}

/// About a principal axis σ dies away with c (1/J + 1/(I − J)), and what the body gains the sphere loses.
#[test]
fn an_inner_sphere_is_dragged_along_as_its_closed_form() {
    let body = simple(1.0, vec![General::InnerSphere(sphere(Vector3::new(0.0, 0.0, 2.0)))]);
    let times = grid(10.0, 20);
    let states = tight(&body, &times);
    let (inertia, rest) = (0.4, MOMENTS[2] - 0.4);
    for (i, t) in times.iter().enumerate() {
        let relative = 2.0 * libm::exp(-0.15 * (1.0 / inertia + 1.0 / rest) * t);
        let omega = (MOMENTS[2] + inertia * 2.0 - inertia * relative) / MOMENTS[2];
        let (found, inner) = (states.angular_velocity[2][i], states.inner[2][i]);
        assert!((found - omega).abs() < 1e-15 && (inner - relative).abs() < 1e-15, "{found}, {inner} at {t} s");
    }
}

/// L of body and sphere stays, to rounding, and their energy only falls: the tumbling body ends about its largest moment.
#[test]
fn an_inner_sphere_takes_energy_and_leaves_angular_momentum() {
    let mut body = problem(MOMENTS, [3.0, 0.1, 0.1], &[general(General::InnerSphere(sphere(Vector3::zeros())))]);
    body.loads[0].window = Window::ALWAYS;
    assert!(body.momentum_law().is_some() && body.energy_law().is_none());
    let times = grid(600.0, 300);
    let states = tight(&body, &times);
    let of = |i: usize| {
        let (state, inner) = (crate::motions::state(&states, i), Vector3::from(row(&states.inner, i)));
        let omega = state.angular_velocity.in_body();
        let of_sphere = sphere(Vector3::zeros());
        let momentum =
            state.attitude.to_world(&(body.moments.vector().component_mul(&omega) + of_sphere.momentum(&inner)));
        let energy = 0.5 * omega.dot(&body.moments.vector().component_mul(&omega)) + of_sphere.energy(&omega, &inner);
        (momentum, energy)
    };
    let (momentum, first) = of(0);
    let mut before = first;
    for i in 1..times.len() {
        let (now, energy) = of(i);
        assert!((now - momentum).norm() < 2e-14 * momentum.norm(), "{:e}", (now - momentum).norm() / momentum.norm());
        assert!(energy < before + 1e-15 * first, "{energy} J after {before} J");
        before = energy;
    }
    let least = momentum.norm_squared() / (2.0 * MOMENTS[2]);
    assert!((before - least).abs() < 1e-3 * least, "{before} J, {least} J about the largest moment");
}

/// On its limit a controller turns a body as a constant torque does; never does it go beyond; the body settles at the target,
/// or within the dead band about it.
#[test]
fn quaternion_feedback_keeps_its_limit_and_settles() {
    let control = |dead_band: f64| QuaternionFeedback {
        target: UnitQuaternion::identity(),
        stiffness: 2.0,
        damping: 3.0,
        limit: 0.25,
        dead_band,
        way: 1.0,
        body_from_principal: UnitQuaternion::identity(),
    };
    for dead_band in [0.0, 0.02] {
        let mut body = simple(0.0, vec![General::QuaternionFeedback(control(dead_band))]);
        body.initial.attitude = polhode::body::Attitude::new([0.6, 0.0, 0.0, 0.8]).expect("a unit quaternion");
        let times = grid(120.0, 2400);
        let states = tight(&body, &times);
        let mut at_limit = 0;
        for (i, time) in times.iter().enumerate() {
            let moment = body.moment(*time, &crate::motions::state(&states, i));
            assert!(moment.amax() <= 0.25, "{moment} at {time} s");
            at_limit += usize::from(moment.z.abs() == 0.25);
        }
        assert!(at_limit > 20, "on the limit at {at_limit} samples");
        let saturated = states.angular_velocity[2][10];
        assert!((saturated + 0.25 * times[10] / MOMENTS[2]).abs() < 1e-16, "{saturated} rad/s");
        let left = states.attitude[3].last().expect("a sample");
        assert!(left.abs() <= dead_band / 2.0 + 1e-12, "{left}");
    }
}

/// u = −d ω with |u| ≤ L: the spin falls as ω₀ − L t/I to L/d, and from there as e^(−d t/I).
#[test]
fn limited_rate_feedback_has_its_closed_form() {
    let (gain, limit, rate) = (0.5, 0.2, 2.0);
    let control = RateFeedback { gain, limit, body_from_principal: UnitQuaternion::identity() };
    let body = simple(rate, vec![General::RateFeedback(control)]);
    let times = grid(40.0, 80);
    let states = tight(&body, &times);
    let corner = (rate - limit / gain) * MOMENTS[2] / limit;
    for (found, t) in states.angular_velocity[2].iter().zip(&times) {
        let exact = if *t < corner {
            rate - limit * t / MOMENTS[2]
        } else {
            limit / gain * libm::exp(-gain * (t - corner) / MOMENTS[2])
        };
        assert!((found - exact).abs() < 1e-15, "{found} for {exact} at {t} s");
    }
}

/// In a field that stands still, B-dot slows a spin across it by e^(−k B² t/I), and whatever the tumble, L along B stays and
/// the energy only falls.
#[test]
fn b_dot_slows_what_turns_across_the_field() {
    let field = Vector3::new(2.0, 0.0, 0.0);
    let control = |limit: f64| {
        let (turning, body_from_principal) = (Vector3::zeros(), UnitQuaternion::identity());
        General::BDot(BDot { gain: 0.1, limit, field, turning, body_from_principal })
    };
    let times = grid(20.0, 100);
    let states = tight(&simple(1.5, vec![control(f64::INFINITY)]), &times);
    for (found, t) in states.angular_velocity[2].iter().zip(&times) {
        let exact = 1.5 * libm::exp(-0.4 * t / MOMENTS[2]);
        assert!((found - exact).abs() < 1e-15, "{found} for {exact} at {t} s");
    }
    let body = problem(MOMENTS, RATES, &[general(control(0.15))]);
    let states = tight(&body, &times);
    let of = |i: usize| {
        let state = crate::motions::state(&states, i);
        let momentum = polhode::dynamics::momentum_in_world(body.moments, &state);
        (momentum.x, polhode::dynamics::rotational_energy(body.moments, &state))
    };
    let (along, mut before) = of(0);
    for i in 1..times.len() {
        let (now, energy) = of(i);
        assert!((now - along).abs() < 1e-14 && energy < before, "{now} for {along} N m s, {energy} J after {before} J");
        before = energy;
    }
}
