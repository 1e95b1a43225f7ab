//! Loads that are functions of time, and rotors: interpolation, impulse laws, agreement of f64 with double-double.

use std::sync::Arc;

use nalgebra::Vector3;
use polhode::body::State;
use polhode::dynamics::{Interpolation, Load, Problem, Profile, Schedule, Torque, Window, rotational_energy};
use polhode::numerics::DoubleDouble;
use polhode::propagation::{Dop853, PreciseTaylor, Propagator, States, Taylor};

use crate::motions::{MOMENTS, RATES, differences, every_torque, grid, problem, profile, row, run, state};

const TIGHTEST: f64 = 1e-16;
/// What rounding may do over some dozens of steps, relative.
const ROUNDING: f64 = 2e-14;

fn taylor(problem: &Problem) -> Taylor {
    Taylor::new(problem, TIGHTEST).expect("covered")
}

fn through(points: &[(f64, f64)], interpolation: Interpolation) -> Profile {
    let points: Vec<_> = points.iter().map(|(time, value)| (*time, Vector3::new(*value, 0.0, -value))).collect();
    Profile::through(&points, interpolation, [Vector3::zeros(); 2]).expect("ascending times")
}

/// Knots at no round time, all within the runs below.
fn uneven(interpolation: Interpolation) -> Arc<Profile> {
    let vector = |x, y, z| Vector3::new(x, y, z);
    let points = [
        (0.3, vector(0.2, 0.3, -0.1)),
        (0.71, vector(-0.3, 0.1, 0.4)),
        (1.9, vector(0.5, -0.2, 0.1)),
        (2.3003, vector(0.4, 0.3, -0.3)),
        (4.1, vector(-0.1, 0.2, 0.2)),
        (4.7, vector(0.1, 0.0, 0.3)),
    ];
    Arc::new(Profile::through(&points, interpolation, [Vector3::zeros(), vector(0.1, 0.2, 0.0)]).expect("ascending"))
}

const ALL: [Interpolation; 3] = [Interpolation::Hold, Interpolation::Linear, Interpolation::Cubic];

#[test]
fn profiles_go_through_their_points() {
    let points = [(-1.0, 2.0), (0.5, -1.0), (0.75, 4.0), (3.0, 0.5), (3.5, 0.25)];
    for interpolation in ALL {
        let profile = through(&points, interpolation);
        for (time, value) in &points[..4] {
            assert_eq!(profile.at(*time).x, *value, "{interpolation:?} at {time}");
        }
        assert_eq!(profile.at(-1.000_001), Vector3::zeros());
        assert_eq!(profile.at(3.5), Vector3::zeros());
        let before = if interpolation == Interpolation::Hold { 0.5 } else { 0.25 };
        assert!((profile.at(3.5 - 1e-9).x - before).abs() < 1e-7, "{interpolation:?}");
    }
    assert!(Profile::through(&[], Interpolation::Linear, [Vector3::zeros(); 2]).is_none());
    let back = [(0.0, Vector3::x()), (0.0, Vector3::y())];
    assert!(Profile::through(&back, Interpolation::Linear, [Vector3::zeros(); 2]).is_none());
}

/// Not-a-knot splines are exact on cubics, of any spacing; through three points on parabolas, through two on lines.
#[test]
fn splines_of_cubics_are_those_cubics() {
    let polynomial = |degree: i32, t: f64| (0..=degree).map(|power| f64::from(power + 1) * t.powi(power)).sum::<f64>();
    let times = [-1.2, -0.7, 0.1, 0.3, 1.1, 1.15, 2.0];
    for (count, degree) in [(2, 1), (3, 2), (4, 3), (5, 3), (7, 3)] {
        let points: Vec<_> = times[..count].iter().map(|t| (*t, polynomial(degree, *t))).collect();
        let profile = through(&points, Interpolation::Cubic);
        for part in 0..100 {
            let t = times[0] + (times[count - 1] - times[0]) * f64::from(part) / 100.0;
            let (found, expected) = (profile.at(t).x, polynomial(degree, t));
            assert!(
                (found - expected).abs() < 2e-15 * expected.abs().max(10.0),
                "{count} points: {found} for {expected} at {t}"
            );
        }
    }
}

#[test]
fn splines_have_two_continuous_derivatives() {
    let profile = uneven(Interpolation::Cubic);
    for knot in &profile.knots()[1..5] {
        let short = 1e-5;
        let [before, at, after] = [-short, 0.0, short].map(|shift| profile.rate_at(knot + shift));
        // Of a continuous second derivative the difference of slopes on both sides is the same but for the third's jump.
        assert!(((after - at) - (at - before)).norm() < 1e-8, "{knot}");
        assert!((profile.at(knot + 1e-12) - profile.at(knot - 1e-12)).norm() < 1e-10);
    }
}

#[test]
fn integrals_are_those_of_the_pieces() {
    for interpolation in ALL {
        let profile = uneven(interpolation);
        // Simpson's rule is exact on cubics.
        let mut edges: Vec<f64> = profile.knots().to_vec();
        edges.extend([0.0, 6.0, 1.0]);
        edges.sort_by(f64::total_cmp);
        let parts = edges.windows(2).map(|pair| {
            let (length, inner) = (pair[1] - pair[0], |share: f64| pair[0] + share * (pair[1] - pair[0]));
            let [start, middle, end] = [1e-12, 0.5, 1.0 - 1e-12].map(|share| profile.at(inner(share)));
            (start + 4.0 * middle + end) * (length / 6.0)
        });
        let expected: Vector3<f64> = parts.sum();
        let found = profile.integral(0.0, 6.0);
        assert!((found - expected).norm() < 1e-11, "{interpolation:?}: {found} for {expected}");
        let halves = profile.integral(0.0, 2.0) + profile.integral(2.0, 6.0);
        assert!((found - halves).norm() < 1e-15);
    }
}

#[test]
fn schedules_are_cut_at_every_knot_within_the_window() {
    let mut problem = problem(MOMENTS, RATES, &[Torque::ProfileBody { moment: uneven(Interpolation::Linear) }]);
    problem.loads[0].window = Window { start: 1.0, end: 4.1 };
    let schedule = Schedule::new(&problem).expect("loads that go together");
    let starts: Vec<f64> = (0..schedule.count()).map(|index| schedule.bounds(index).0).collect();
    assert_eq!(starts, [0.0, 1.0, 1.9, 2.3003, 4.1]);
    assert_eq!(schedule.bounds(4).1, f64::INFINITY);
}

/// ΔL = ∫ table dt, in the world whatever the body does.
#[test]
fn a_table_in_the_world_adds_its_integral_to_the_momentum() {
    for interpolation in ALL {
        let moment = uneven(interpolation);
        let problem = problem(MOMENTS, RATES, &[Torque::ProfileWorld { moment: Arc::clone(&moment) }]);
        let law = problem.momentum_law().expect("of the whole vector");
        let times = grid(7.0, 29);
        let states = run(taylor(&problem), &times);
        let start = problem.momentum_in_world(0.0, &problem.initial);
        for (i, time) in times.iter().enumerate() {
            let momentum = problem.momentum_in_world(*time, &state(&states, i));
            let off = (momentum - start - moment.integral(0.0, *time)).norm();
            assert!(off < ROUNDING, "{interpolation:?}: {off:e} at {time}");
            assert!(law.violation(*time, &start, &momentum) < ROUNDING);
        }
    }
}

/// Along a principal axis, ω is ∫ table dt over the moment of inertia.
#[test]
fn a_table_along_the_spin_adds_its_integral() {
    let points = [(0.1, 0.0), (0.6, 0.4), (1.7, 0.9), (2.2, 0.1)].map(|(time, value)| (time, Vector3::z() * value));
    for interpolation in ALL {
        let moment =
            Arc::new(Profile::through(&points, interpolation, [Vector3::zeros(); 2]).expect("ascending times"));
        let problem = problem(MOMENTS, [0.0, 0.0, 0.5], &[Torque::ProfileBody { moment: Arc::clone(&moment) }]);
        let times = grid(3.0, 17);
        let states = run(taylor(&problem), &times);
        for (i, time) in times.iter().enumerate() {
            let [x, y, z] = row(&states.angular_velocity, i);
            let expected = 0.5 + moment.integral(0.0, *time).z / MOMENTS[2];
            assert_eq!([x, y], [0.0, 0.0]);
            assert!((z - expected).abs() < 4.0 * f64::EPSILON, "{interpolation:?}: {z} for {expected} at {time}");
        }
    }
}

/// Every kind and every interpolation, with other loads beside and a translation: f64 moves as double-double does.
#[test]
fn series_in_f64_agree_with_those_in_double_double() {
    for interpolation in ALL {
        let of_time = || uneven(interpolation);
        let arm = Vector3::new(0.1, -0.2, 0.3);
        let mut torques: Vec<Torque> = every_torque().into_iter().map(|(_, torque)| torque).collect();
        torques.retain(|torque| torque.profile().is_none());
        torques.extend([
            Torque::ProfileBody { moment: of_time() },
            Torque::ProfileWorld { moment: of_time() },
            Torque::ForceProfileBody { force: of_time(), arm },
            Torque::ForceProfileWorld { force: of_time(), arm: -2.0 * arm },
            Torque::Rotor { momentum: of_time() },
        ]);
        // One at a time, then all together.
        let mut lots: Vec<Vec<Torque>> = torques.iter().cloned().map(|torque| vec![torque]).collect();
        lots.push(torques);
        for lot in lots {
            let mut problem = problem(MOMENTS, RATES, &lot);
            problem.wants_translation = true;
            let times = [0.25, 0.5, 2.0, 2.3003, 5.0, 6.5];
            let states = run(taylor(&problem), &times);
            let mut precise = PreciseTaylor::new(&problem).expect("covered");
            for (i, time) in times.into_iter().enumerate() {
                let exact = precise.at(time).expect("a finite motion").expect("no limit of steps");
                let State { angular_velocity, position, .. } = state(&states, i);
                let rates = exact.angular_velocity.map(DoubleDouble::hi);
                let places = exact.position.map(DoubleDouble::hi);
                let off = (angular_velocity.in_body() - Vector3::from(rates)).norm();
                let moved = (position - Vector3::from(places)).norm();
                let q = exact.attitude.map(DoubleDouble::hi);
                let turned: f64 = row(&states.attitude, i).iter().zip(q).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
                assert!(
                    off < ROUNDING && moved < ROUNDING && turned.sqrt() < ROUNDING,
                    "{lot:?} at {time}: {off:e}, {moved:e}, {turned:e}"
                );
            }
        }
    }
}

/// Another method, that knows nothing of series.
#[test]
fn runge_kutta_agrees() {
    for interpolation in ALL {
        let of_time = || uneven(interpolation);
        let arm = Vector3::new(0.1, -0.2, 0.3);
        let mut problem = problem(
            MOMENTS,
            RATES,
            &[
                Torque::ProfileWorld { moment: of_time() },
                Torque::ForceProfileBody { force: of_time(), arm },
                Torque::Rotor { momentum: of_time() },
            ],
        );
        problem.wants_translation = true;
        let times = grid(6.0, 12);
        let (mut found, mut expected) = (States::default(), States::default());
        Dop853::new(&problem, 1e-13).expect("covered").fill(&times, &mut found).expect("a finite motion");
        taylor(&problem).fill(&times, &mut expected).expect("a finite motion");
        let (attitude, rates) = differences(&found, &expected);
        assert!(attitude < 1e-11 && rates < 1e-11, "{interpolation:?}: {attitude:e} rad, {rates:e} rad/s");
    }
}

/// I ω + h stays in the world whatever the motor does, and with a constant h so does ½ ω·Iω.
#[test]
fn gyrostats_keep_the_momentum_of_both_and_at_constant_speed_the_energy() {
    let spun_up = Torque::Rotor { momentum: profile(2.0) };
    let steady = Torque::Rotor { momentum: Arc::new(Profile::constant(Vector3::new(0.4, -0.9, 1.3))) };
    for (torque, is_steady) in [(spun_up, false), (steady, true)] {
        let problem = problem(MOMENTS, RATES, &[torque]);
        assert_eq!(problem.energy_law().is_some(), is_steady);
        let times = grid(60.0, 40);
        let states = run(taylor(&problem), &times);
        let momentum = problem.momentum_in_world(0.0, &problem.initial);
        let energy = rotational_energy(problem.moments, &problem.initial);
        for (i, time) in times.iter().enumerate() {
            let state = state(&states, i);
            let off = (problem.momentum_in_world(*time, &state) - momentum).norm();
            assert!(off < 2.0 * ROUNDING * momentum.norm(), "{off:e} at {time}");
            let gained = (rotational_energy(problem.moments, &state) - energy).abs();
            assert!(!is_steady || gained < ROUNDING * energy, "{gained:e} at {time}");
            assert_eq!(problem.external_moment(*time, &state), Vector3::zeros());
        }
    }
}

/// A spin Ω about axis 3 with h along it stays small-angle stable iff (I₃Ω + h − I₁Ω)(I₃Ω + h − I₂Ω) > 0 [Hughes86], and
/// nutates at the root of that product over √(I₁ I₂).
#[test]
fn gyrostats_are_stable_where_the_signs_agree() {
    let spin = 0.8;
    for h in [-3.0, -1.3, -0.9, -0.2, 0.0, 0.7] {
        let [one, two, three] = MOMENTS;
        let product = (three * spin + h - one * spin) * (three * spin + h - two * spin);
        let rotor = Torque::Rotor { momentum: Arc::new(Profile::constant(Vector3::z() * h)) };
        let small = 1e-7;
        let problem = problem(MOMENTS, [small, 0.0, spin], &[rotor]);
        let rate = libm::sqrt(product.abs() / (one * two));
        let quarter = 0.5 * std::f64::consts::PI / rate;
        let states = run(taylor(&problem), &[quarter, 2.0 * quarter]);
        let [across, _, _] = row(&states.angular_velocity, 1);
        let expected = if product > 0.0 { -small } else { small * libm::cosh(std::f64::consts::PI) };
        assert!((across - expected).abs() < 1e-4 * small, "h = {h}: {across:e} for {expected:e}");
    }
}

/// A table of a hundred thousand knots: no more edges than knots, and spans made as they come.
#[test]
fn a_table_of_many_knots_is_no_more_than_its_knots() {
    const KNOTS: u32 = 100_000;
    let points: Vec<_> = (0..KNOTS)
        .map(|knot| {
            let time = 1e-3 * f64::from(knot);
            (time, Vector3::new(libm::sin(time), libm::cos(0.7 * time), 0.1))
        })
        .collect();
    let moment = Profile::through(&points, Interpolation::Cubic, [Vector3::zeros(); 2]).expect("ascending times");
    let problem = problem(MOMENTS, RATES, &[Torque::ProfileBody { moment: Arc::new(moment) }]);
    assert_eq!(Schedule::new(&problem).expect("one load").count(), 100_000);
    let mut taylor = taylor(&problem);
    let mut states = States::default();
    taylor.fill(&[2.0], &mut states).expect("a finite motion");
    // One step a knot, and none for those to come.
    assert!((1999..=2010).contains(&taylor.effort().steps), "{:?}", taylor.effort());
}

#[test]
fn windows_cut_functions_of_time() {
    let moment = uneven(Interpolation::Cubic);
    let window = Window { start: 0.5, end: 3.3 };
    let mut problem = problem(MOMENTS, RATES, &[]);
    problem.loads = vec![Load { torque: Torque::ProfileWorld { moment: Arc::clone(&moment) }, window }];
    let states = run(taylor(&problem), &[7.0]);
    let gained = problem.momentum_in_world(7.0, &state(&states, 0)) - problem.momentum_in_world(0.0, &problem.initial);
    assert!((gained - moment.integral(0.5, 3.3)).norm() < ROUNDING);
}

/// On a pivot: a wheel along a top's axis stands in for spin about it, and the axis goes the same way.
#[test]
fn a_wheel_holds_up_a_top_as_its_spin_does() {
    let weight = Torque::ForceWorld { force: Vector3::new(0.0, 0.0, -4.0), arm: Vector3::z() * 0.5 };
    let spinning = problem([2.0, 2.0, 1.0], [0.3, -0.2, 9.0], std::slice::from_ref(&weight));
    let rotor = Torque::Rotor { momentum: Arc::new(Profile::constant(Vector3::z() * 8.5)) };
    let carrying = problem([2.0, 2.0, 1.0], [0.3, -0.2, 0.5], &[weight, rotor]);
    let times = grid(20.0, 40);
    let (one, other) = (run(taylor(&spinning), &times), run(taylor(&carrying), &times));
    for i in 0..times.len() {
        let [one, other] = [&one, &other].map(|states| state(states, i).attitude.to_world(&Vector3::z()));
        assert!((one - other).norm() < ROUNDING, "{:e} at {}", (one - other).norm(), times[i]);
    }
    assert!(carrying.energy_law().is_some() && carrying.momentum_law().is_some_and(|law| law.axis.is_some()));
}
