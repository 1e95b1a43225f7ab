//! What channels that are derived from the state must be: Euler angles that make the attitude again, rates that are those of
//! the angles, integrals that stay, a phase that grows as the elliptic functions say.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::{Quaternion, Unit, UnitQuaternion, Vector3};
use polhode::body::{Attitude, PrincipalMoments, State};
use polhode::dynamics::{Kovalevskaya, Problem, Torque, rotational_energy, translational_energy};
use polhode::numerics::{DoubleDouble, carlson_rf};
use polhode::propagation::{FreeRotation, LagrangeTop, Propagator, Taylor};
use polhode::telemetry::{
    BodySamples, Channel, Derivation, Encircled, EulerSequence, FigureAxis, FigureFrame, separatrix_distance,
};
use proptest::prelude::*;

use crate::motions::{MOMENTS, RATES, grid, problem, run, state};

const SEQUENCES: [(EulerSequence, [usize; 3]); 4] = [
    (EulerSequence::Zxz, [2, 0, 2]),
    (EulerSequence::Zyz, [2, 1, 2]),
    (EulerSequence::Zyx, [2, 1, 0]),
    (EulerSequence::Xyz, [0, 1, 2]),
];

fn turn(axis: usize, angle: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::from_axis_angle(&Unit::new_unchecked(Vector3::ith(axis, 1.0)), angle)
}

fn together(axes: [usize; 3], angles: [f64; 3]) -> UnitQuaternion<f64> {
    turn(axes[0], angles[0]) * turn(axes[1], angles[1]) * turn(axes[2], angles[2])
}

fn apart(a: &UnitQuaternion<f64>, b: &UnitQuaternion<f64>) -> f64 {
    Attitude::from_world_from_body(*a).angle_to(Attitude::from_world_from_body(*b))
}

/// The columns of `channels` along `problem` by `propagator`.
fn columns(problem: &Problem, propagator: impl Propagator, channels: &[Channel], times: &[f64]) -> Vec<Vec<f64>> {
    let states = run(propagator, times);
    let mut samples = BodySamples::new(channels);
    Derivation::new(problem, UnitQuaternion::identity()).derive(times, &states, &mut samples);
    samples.columns().to_vec()
}

fn free(problem: &Problem) -> FreeRotation {
    FreeRotation::new(problem).expect("nothing acts")
}

fn spread(column: &[f64]) -> f64 {
    let most = column.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    most - column.iter().copied().fold(f64::INFINITY, f64::min)
}

proptest! {
    /// Three turns of some ulps each, and as many when they are put together again.
    #[test]
    fn euler_angles_make_the_attitude_again(parts in prop::array::uniform4(-1.0..1.0_f64)) {
        let attitude = UnitQuaternion::new_normalize(Quaternion::from(parts));
        for (sequence, axes) in SEQUENCES {
            let angles = sequence.angles(&attitude);
            prop_assert!(apart(&together(axes, angles), &attitude) < 3e-15, "{sequence:?} {angles:?}");
            let [least, most] = if axes[0] == axes[2] { [0.0, PI] } else { [-FRAC_PI_2, FRAC_PI_2] };
            prop_assert!((least..=most).contains(&angles[1]) && angles[0].abs() <= PI && angles[2].abs() <= PI);
        }
    }

    /// Near the ends of the second angle the others are loose, and the attitude is not.
    #[test]
    fn euler_angles_near_gimbal_lock_make_the_attitude_again(
        first in -PI..PI, third in -PI..PI, off in -12.0..0.0_f64, far in any::<bool>(),
    ) {
        for (sequence, axes) in SEQUENCES {
            let [least, most] = if axes[0] == axes[2] { [0.0, PI] } else { [-FRAC_PI_2, FRAC_PI_2] };
            let off = 10.0_f64.powf(off);
            let attitude = together(axes, [first, if far { most - off } else { least + off }, third]);
            let angles = sequence.angles(&attitude);
            prop_assert!(apart(&together(axes, angles), &attitude) < 3e-15, "{sequence:?} {angles:?}");
        }
    }
}

/// The quaternions that are whole quarter turns are met exactly, and gimbal lock among them leaves the third angle at zero.
#[test]
fn quarter_turns_lock_with_the_third_angle_at_zero() {
    let half = 0.5_f64.sqrt();
    let mut locked = 0;
    for wxyz in [
        [1.0, 0.0, 0.0, 0.0],
        [0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0],
        [half, 0.0, half, 0.0],
        [half, 0.0, -half, 0.0],
    ] {
        for sign in [1.0, -1.0] {
            for about_z in [0.0, 0.3, -2.5] {
                let [w, x, y, z] = wxyz.map(|part| sign * part);
                let start = turn(2, about_z) * UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
                for (sequence, axes) in SEQUENCES {
                    let angles = sequence.angles(&start);
                    assert!(apart(&together(axes, angles), &start) < 1e-15, "{sequence:?} {wxyz:?} {angles:?}");
                }
                let [_, second, third] = EulerSequence::Zxz.angles(&start);
                if wxyz[0].abs() == 1.0 || wxyz[1].abs() == 1.0 {
                    locked += 1;
                    assert!(third == 0.0 && (second == 0.0 || second == PI), "{second} {third}");
                }
            }
        }
    }
    assert_eq!(locked, 12);
}

/// Nothing of a small pitch or nutation is lost beside π/2 or 1.
#[test]
fn small_second_angles_keep_their_digits() {
    for small in [1e-3_f64, 1e-9, 1e-15, 1e-30, 1e-150] {
        for (sequence, axes) in SEQUENCES {
            let quaternion =
                UnitQuaternion::new_normalize(Quaternion::from_parts(1.0, 0.5 * small * Vector3::ith(axes[1], 1.0)));
            // tan(angle/2) = small/2.
            let expected = 2.0 * libm::atan(0.5 * small);
            let found = sequence.angles(&quaternion)[1];
            assert!((found / expected - 1.0).abs() < 4.0 * f64::EPSILON, "{sequence:?} {small:e}: {found:e}");
        }
    }
}

/// The bodies whose axis of figure is each principal axis, either end up.
fn free_problems() -> Vec<Problem> {
    let mut problems = Vec::new();
    for moments in
        [[1.0, 2.0, 2.6], [2.6, 1.0, 2.0], [2.0, 2.6, 1.0], [1.0, 1.0, 1.7], [1.7, 1.0, 1.0], [1.2, 0.5, 1.2]]
    {
        for rates in [[0.7, -0.4, 1.1], [-1.1, 0.6, 0.3], [0.2, -1.5, -0.8], [0.9, 0.1, -0.2]] {
            problems.push(problem(moments, rates, &[]));
        }
    }
    problems
}

/// ω is made of the rates: about the reference, the line of nodes and the axis of figure. And the axis leans from L by the
/// nutation, and L stays.
#[test]
fn figure_angles_and_rates_make_the_motion_again() {
    let channels = [Channel::AngularVelocityWorld, Channel::FigureAngles, Channel::FigureRates, Channel::MomentumTilt];
    let times = grid(20.0, 50);
    let mut seen = [0; 3];
    for problem in free_problems() {
        assert!(Encircled::of(&problem).is_some(), "it turns");
        let momentum = polhode::dynamics::momentum_in_world(problem.moments, &problem.initial).normalize();
        let columns = columns(&problem, free(&problem), &channels, &times);
        let [wx, wy, wz, phi, theta, _, phi_rate, theta_rate, psi_rate, tilt] = columns.as_slice() else {
            panic!("ten columns")
        };
        let scale = problem.initial.angular_velocity.in_body().norm();
        // From axes about L to the world: the inverse of the shortest turn from L to z.
        let upright = UnitQuaternion::rotation_between(&momentum, &Vector3::z()).expect("no half turn").inverse();
        for k in 0..times.len() {
            assert!((theta[k] - tilt[k]).abs() < 4e-15, "nutation is the tilt from L");
            let node = turn(2, phi[k]) * Vector3::x();
            let figure = turn(2, phi[k]) * turn(0, theta[k]) * Vector3::z();
            let omega = upright * (phi_rate[k] * Vector3::z() + theta_rate[k] * node + psi_rate[k] * figure);
            let found = Vector3::new(wx[k], wy[k], wz[k]);
            assert!((omega - found).norm() < 2e-14 * scale, "{:?}: {omega} {found}", problem.moments);
        }
        // It precesses the same way all the time, and in a body of two equal moments evenly.
        assert!(phi_rate.iter().all(|rate| *rate > 0.0));
        let moments = problem.moments.vector();
        if moments.x == moments.y {
            assert!(spread(phi_rate) < 1e-14 && spread(psi_rate) < 1e-14 && spread(theta) < 1e-14);
            seen[2] += 1;
        }
        // The spin has one sign: that is what the choice of the axis is for.
        assert!(psi_rate.iter().all(|rate| rate * psi_rate[0] > 0.0), "{:?} {psi_rate:?}", problem.moments);
        seen[usize::from(psi_rate[0] > 0.0)] += 1;
    }
    assert!(seen.iter().all(|count| *count >= 4), "{seen:?}");
}

/// Of a top with the vertical along z, precession, nutation and spin are the Euler angles z, x, z of its principal axes.
#[test]
fn a_tops_figure_angles_are_its_classical_euler_angles() {
    let pull = Torque::ForceWorld { force: Vector3::new(0.0, 0.0, -4.9), arm: Vector3::new(0.0, 0.0, 0.05) };
    let top = problem([1.85e-3, 1.85e-3, 8e-4], [0.4, -0.9, 90.0], &[pull]);
    let channels =
        [Channel::Tilt, Channel::PrecessionRate, Channel::EulerZxz, Channel::FigureAngles, Channel::FigureRates];
    let times = grid(2.0, 400);
    let found = columns(&top, LagrangeTop::new(&top).expect("a top"), &channels, &times);
    let [tilt, rate, first, second, third, phi, theta, psi, phi_rate, ..] = found.as_slice() else {
        panic!("eleven columns")
    };
    for k in 0..times.len() {
        let off =
            [(first, phi), (third, psi)].map(|(a, b)| (a[k] - b[k]).rem_euclid(TAU)).map(|off| off.min(TAU - off));
        assert!(off.iter().all(|off| *off < 1e-14) && second[k] == theta[k], "{off:?}");
        assert!((theta[k] - tilt[k]).abs() < 1e-15 && (phi_rate[k] / rate[k] - 1.0).abs() < 1e-13);
    }
    // Upside down, all is told from the other end.
    let hung = Torque::ForceWorld { force: Vector3::new(0.0, 0.0, -4.9), arm: Vector3::new(0.0, 0.0, -0.05) };
    let hung = problem([1.85e-3, 1.85e-3, 8e-4], [0.4, -0.9, 90.0], &[hung]);
    let [up, down] = [&top, &hung].map(|problem| {
        let frame = FigureFrame::of(problem).expect("a top");
        (frame.angles(&problem.initial.attitude.world_from_body()), frame.rates(problem, &problem.initial))
    });
    assert!((up.0[1] + down.0[1] - PI).abs() < 1e-15, "nutation from the other end");
    assert!((up.1[0] - down.1[0]).abs() < 1e-12 && (up.1[2] + down.1[2]).abs() < 1e-10, "{up:?} {down:?}");
    assert!(FigureAxis::of(&hung).is_some());
}

/// The rates are those of the angles: by central differences, whose error is h⁴ of rates that change over 0.1 s and more.
#[test]
fn figure_rates_are_the_slopes_of_the_angles() {
    let problem = problem(MOMENTS, RATES, &[]);
    let h = 1e-3;
    let times: Vec<f64> =
        (0..20).flat_map(|k| [-2.0, -1.0, 0.0, 1.0, 2.0].map(|j| 0.5 + 0.7 * f64::from(k) + j * h)).collect();
    let found = columns(&problem, free(&problem), &[Channel::FigureAngles, Channel::FigureRates], &times);
    for angle in 0..3 {
        for at in (2..times.len()).step_by(5) {
            let off = |k: usize| {
                let off = found[angle][k] - found[angle][at];
                off - TAU * (off / TAU).round()
            };
            let slope = (8.0 * (off(at + 1) - off(at - 1)) - (off(at + 2) - off(at - 2))) / (12.0 * h);
            assert!((slope - found[3 + angle][at]).abs() < 1e-11, "{angle} at {}: {slope}", times[at]);
        }
    }
}

/// u = F(φ, m) grows evenly by λ, with φ the phase: checked with m and λ of the free motion's formulas.
#[test]
fn the_polhode_phase_is_the_amplitude_of_a_steady_argument() {
    for rates in [[0.7, -0.4, 1.1], [-1.1, 0.6, 0.3], [0.9, 0.1, -0.2], [0.1, -0.7, -2.0]] {
        let problem = problem(MOMENTS, rates, &[]);
        let (omega, inertia) = (Vector3::from(rates), Vector3::from(MOMENTS));
        let momentum = inertia.component_mul(&omega);
        let (square, twice_energy) = (momentum.norm_squared(), momentum.dot(&omega));
        // The circulated axis comes last.
        let is_long = twice_energy * inertia.y > square;
        let [i1, i2, i3] = if is_long { [inertia.z, inertia.y, inertia.x] } else { [inertia.x, inertia.y, inertia.z] };
        let lambda = ((i3 - i2) * (square - twice_energy * i1) / (i1 * i2 * i3)).abs().sqrt();
        let m = ((i2 - i1) * (twice_energy * i3 - square) / ((i3 - i2) * (square - twice_energy * i1))).abs();
        let times = grid(12.0, 240);
        let phase = &columns(&problem, free(&problem), &[Channel::PolhodePhase], &times)[0];
        let argument = |phase: f64| {
            // F by whole half turns and Carlson's form.
            let (sine, cosine) = (phase.sin(), phase.cos());
            let parts = [cosine * cosine, 1.0 - m * sine * sine, 1.0].map(DoubleDouble::from);
            sine * carlson_rf(parts[0], parts[1], parts[2]).hi()
        };
        let mut judged = 0;
        for (k, pair) in phase.windows(2).enumerate() {
            // Within a quarter turn about zero the form needs no periods.
            if pair.iter().all(|phase| phase.abs() < FRAC_PI_2) {
                let grown = (argument(pair[1]) - argument(pair[0])) / (times[k + 1] - times[k]);
                assert!((grown / lambda - 1.0).abs() < 1e-12, "{rates:?}: {grown} for {lambda}");
                judged += 1;
            }
        }
        assert!(judged > 20, "{judged}");
    }
}

/// Near the separatrix a difference of energies would leave no digit; the form of differences of moments does.
#[test]
fn the_distance_from_the_separatrix_stays_and_is_zero_on_it() {
    let exact = problem([1.0, 2.0, 2.25], [0.75, -2.0, 1.0], &[]);
    assert_eq!(separatrix_distance(exact.moments, &exact.initial.angular_velocity.in_body()), 0.0);
    for (rates, sign) in [([0.75, -2.0, 1.0 - 1e-9], 1.0), ([0.75, -2.0, 1.0 + 1e-9], -1.0)] {
        let near = problem([1.0, 2.0, 2.25], rates, &[]);
        let column = &columns(&near, free(&near), &[Channel::SeparatrixDistance], &grid(60.0, 200))[0];
        // −2 I₃ (I₃ − I₂) ω₃ δ / L², δ = −1e-9.
        let expected = sign * 2.0 * 2.25 * 0.25 * 1e-9 / (0.75 * 0.75 + 16.0 + 2.25 * 2.25);
        assert!((column[0] / expected - 1.0).abs() < 1e-6, "{} {expected}", column[0]);
        assert!(spread(column) < 3e-16, "{:e}", spread(column));
    }
    // Against its definition, where nothing cancels.
    let (omega, inertia) = (Vector3::from(RATES), Vector3::from(MOMENTS));
    let momentum = inertia.component_mul(&omega);
    let defined = momentum.dot(&omega) * inertia.y / momentum.norm_squared() - 1.0;
    let found = separatrix_distance(PrincipalMoments::new(MOMENTS).expect("a body"), &omega);
    assert!((found - defined).abs() < 4e-16, "{found} {defined}");
}

#[test]
fn kinetic_energy_is_that_of_both_motions() {
    let problem = problem(MOMENTS, RATES, &[Torque::ForceBody { force: Vector3::x(), arm: Vector3::y() }]);
    let problem = Problem { wants_translation: true, ..problem };
    let times = grid(3.0, 10);
    let propagator = || Taylor::new(&problem, 1e-16).expect("covered");
    let states = run(propagator(), &times);
    let found = &columns(&problem, propagator(), &[Channel::KineticEnergy], &times)[0];
    for (k, found) in found.iter().enumerate() {
        let state: State = state(&states, k);
        let both = rotational_energy(problem.moments, &state) + translational_energy(2.0, &state);
        assert!((found / both - 1.0).abs() < 1e-15);
    }
}

/// A damped satellite loses of Jacobi's integral; a free one keeps it, and what it keeps is the total energy of the channel.
#[test]
fn the_jacobi_integral_stays_on_an_orbit() {
    let gradient = Torque::GravityGradient { mean_motion: 0.8 };
    let channels = [Channel::TotalEnergy, Channel::JacobiIntegral];
    // The total energy counts the flight as well.
    let mut orbit = problem(MOMENTS, RATES, std::slice::from_ref(&gradient));
    orbit.initial.velocity = Vector3::zeros();
    let times = grid(30.0, 60);
    let found = columns(&orbit, Taylor::new(&orbit, 1e-16).expect("covered"), &channels, &times);
    let [total, jacobi] = found.as_slice() else { panic!("two columns") };
    assert!(spread(jacobi) < 2e-14, "{:e}", spread(jacobi));
    let off = total.iter().zip(jacobi).fold(0.0, |off: f64, (total, jacobi)| off.max((total - jacobi).abs()));
    assert!(off < 1e-14, "{off:e}");
    let damped = problem(MOMENTS, RATES, &[gradient.clone(), Torque::LinearDamping { coefficient: 0.1 }]);
    assert!(damped.energy_law().is_none());
    assert!(damped.jacobi_integral(0.0, &damped.initial).is_some());
    assert!(problem(MOMENTS, RATES, &[gradient.clone(), gradient]).jacobi_integral(0.0, &orbit.initial).is_none());
}

/// Whichever principal axis is the third, and wherever across it the centre of mass lies.
#[test]
fn kovalevskayas_integral_stays_on_her_top_and_on_no_other() {
    for third in 0..3 {
        let mut moments = [0.02; 3];
        moments[third] = 0.01;
        for (one, other) in [(0.1, 0.0), (0.0, -0.1), (0.07, 0.05)] {
            let mut arm = Vector3::zeros();
            (arm[(third + 1) % 3], arm[(third + 2) % 3]) = (one, other);
            let pull = Torque::ForceWorld { force: Vector3::new(0.5, -1.0, -4.0), arm };
            let top = problem(moments, [3.0, -1.0, 2.0], &[pull]);
            assert!(Kovalevskaya::of(&top).is_some());
            let propagator = Taylor::new(&top, 1e-16).expect("covered");
            let column = &columns(&top, propagator, &[Channel::KovalevskayaIntegral], &grid(10.0, 100))[0];
            // Its terms reach some 1e4 s⁻⁴.
            assert!(column[0] > 1.0 && spread(column) < 1e-10 * column[0], "{third} {arm}: {column:?}");
        }
        moments[third] = 0.010_001;
        let pull = Torque::ForceWorld { force: Vector3::z(), arm: Vector3::ith((third + 1) % 3, 0.1) };
        assert!(Kovalevskaya::of(&problem(moments, [3.0, -1.0, 2.0], &[pull])).is_none());
    }
}
