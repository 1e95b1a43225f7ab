//! Errors of no known form are told apart by their size and by what neighbouring samples have in common.

use nalgebra::{Quaternion, UnitQuaternion, Vector3, Vector4};
use polhode::comparison::verify::{Cause, Verdict, Verification};
use polhode::recording::{Axes, Observed};
use polhode::scenario::TorqueSpecs;

use super::engine::{ATTITUDE, Engine, MOMENTS, OMEGA, book, causes, evenly, exact, observed, quaternion, verified};

fn wrong(observed: &Observed) -> Verification {
    let found = verified(observed, Some(&book(TorqueSpecs::default())));
    assert_eq!(found.verdict, Verdict::Wrong);
    found
}

/// Exact motion of ten turns, the frame of ω not told.
fn motion() -> Observed {
    let mut observed = exact(&book(TorqueSpecs::default()), &evenly(1500, 0.01));
    observed.angular_velocity.as_mut().expect("rates").axes = None;
    observed
}

fn change_rates(observed: &mut Observed, mut change: impl FnMut(Vector3<f64>) -> Vector3<f64>) {
    let rates = observed.angular_velocity.as_mut().expect("rates");
    for k in 0..rates.times_s.len() {
        let row = change(Vector3::from(rates.columns.each_ref().map(|column| column[k])));
        for (column, value) in rates.columns.iter_mut().zip(row.iter()) {
            column[k] = *value;
        }
    }
}

fn change_attitudes(observed: &mut Observed, mut change: impl FnMut(UnitQuaternion<f64>) -> UnitQuaternion<f64>) {
    let attitude = observed.attitude.as_mut().expect("attitudes");
    for k in 0..attitude.times_s.len() {
        let q = quaternion(attitude.columns.each_ref().map(|column| column[k]));
        let q = change(UnitQuaternion::new_normalize(q));
        for (column, value) in attitude.columns.iter_mut().zip([q.w, q.i, q.j, q.k]) {
            column[k] = value;
        }
    }
}

/// Near enough to a normal distribution of variance 1, from a linear congruence.
struct Noise(u64);

impl Noise {
    fn number(&mut self) -> f64 {
        let mut sum = -6.0;
        for _ in 0..12 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let upper = (self.0 >> 32) as u32;
            sum += f64::from(upper) / f64::from(u32::MAX);
        }
        sum
    }

    fn vector(&mut self, size: f64) -> Vector3<f64> {
        Vector3::from_fn(|_, _| size * self.number())
    }
}

/// Classical Runge-Kutta steps of q and L in body axes, all in 32-bit arithmetic, every `every`-th recorded.
fn in_single_precision(steps: usize, every: usize) -> Vec<(f64, Vector4<f32>, Vector3<f32>)> {
    #[expect(clippy::cast_possible_truncation, reason = "32 bits are the point")]
    let single = |value: f64| value as f32;
    let moments = Vector3::from(MOMENTS.map(single));
    let [w, x, y, z] = ATTITUDE.map(single);
    let (mut q, mut momentum) = (Vector4::new(x, y, z, w), moments.component_mul(&Vector3::from(OMEGA.map(single))));
    let step = 1.0 / 2048.0_f32;
    let rate = |q: &Vector4<f32>, momentum: &Vector3<f32>| {
        let omega = momentum.component_div(&moments);
        let turning = Quaternion::from_vector(*q) * Quaternion::from_imag(0.5 * omega);
        (turning.coords, momentum.cross(&omega))
    };
    let mut rows = Vec::new();
    for k in 0..=steps {
        if k.is_multiple_of(every) {
            #[expect(clippy::cast_precision_loss, reason = "a few hundred thousand")]
            rows.push((k as f64 * f64::from(step), q, momentum));
        }
        let one = rate(&q, &momentum);
        let two = rate(&(q + one.0 * (0.5 * step)), &(momentum + one.1 * (0.5 * step)));
        let three = rate(&(q + two.0 * (0.5 * step)), &(momentum + two.1 * (0.5 * step)));
        let four = rate(&(q + three.0 * step), &(momentum + three.1 * step));
        q += (one.0 + two.0 * 2.0 + three.0 * 2.0 + four.0) * (step / 6.0);
        momentum += (one.1 + two.1 * 2.0 + three.1 * 2.0 + four.1) * (step / 6.0);
        q.normalize_mut();
    }
    rows
}

/// A good method in 32 bits: each ω is right to rounding, and yet they lead astray. What is recorded are the floats themselves.
#[test]
fn arithmetic_of_32_bits_that_adds_up() {
    let divided = |momentum: Vector3<f32>| {
        #[expect(clippy::cast_possible_truncation, reason = "32 bits are the point")]
        let moments = Vector3::from(MOMENTS.map(|moment| moment as f32));
        momentum.component_div(&moments)
    };
    for every in [8, 32] {
        let rows: Vec<_> = in_single_precision(300_000, every)
            .into_iter()
            .map(|(time, q, momentum)| {
                (time, Quaternion::from_vector(q.map(f64::from)), divided(momentum).map(f64::from))
            })
            .collect();
        assert_eq!(causes(&wrong(&observed(&rows))), ["single_precision"], "every {every}");
    }
}

/// The same where ω is worked out of L in 64 bits: the file's digits do not tell, the size and independence of errors do.
#[test]
fn arithmetic_of_32_bits_under_a_recorder_of_64() {
    let rows: Vec<_> = in_single_precision(300_000, 32)
        .into_iter()
        .map(|(time, q, momentum)| {
            let omega = momentum.map(f64::from).component_div(&Vector3::from(MOMENTS));
            (time, Quaternion::from_vector(q.map(f64::from)).normalize(), omega)
        })
        .collect();
    assert_eq!(causes(&wrong(&observed(&rows))), ["single_precision"]);
}

/// A gyroscope's: of more samples than are looked at, neighbours are still among those that are.
#[test]
fn noise_of_the_rates() {
    for size in [1e-3, 3e-2] {
        let (mut observed, mut noise) = (motion(), Noise(1));
        change_rates(&mut observed, |omega| omega + noise.vector(size));
        assert_eq!(causes(&wrong(&observed)), ["noise"], "{size} rad/s");
    }
}

/// A camera's: ω is right, each attitude is off by itself.
#[test]
fn noise_of_the_attitudes() {
    let (mut observed, mut noise) = (motion(), Noise(1));
    change_attitudes(&mut observed, |q| q * UnitQuaternion::from_scaled_axis(noise.vector(3e-3)));
    assert_eq!(causes(&wrong(&observed)), ["noise"]);
}

/// Floats whose errors in an interval are within rounding but all of a kind: they add up, and rounding is not to blame.
#[test]
fn a_method_of_first_order_is_not_taken_for_rounding() {
    let engine = Engine { step: 2e-4, every: 2, is_single: true, ..Engine::default() };
    assert_eq!(causes(&wrong(&engine.record(15.0))), ["truncation"]);
}

/// The midpoint method, of second order and consistent in q and ω, by steps that are too long; the shortest errs by less
/// than 32 bits would, but alike in neighbouring intervals.
#[test]
fn the_truncation_of_a_second_order_method() {
    let moments = Vector3::from(MOMENTS);
    let slope = |omega: &Vector3<f64>| -omega.cross(&moments.component_mul(omega)).component_div(&moments);
    for (count, step) in [(2000, 1.0 / 30.0), (2000, 1.0 / 60.0), (16_000, 1.0 / 240.0)] {
        let (mut q, mut omega) = (quaternion(ATTITUDE), Vector3::from(OMEGA));
        let mut rows = Vec::new();
        for time in evenly(count, step) {
            rows.push((time, q, omega));
            let middle = omega + 0.5 * step * slope(&omega);
            q *= UnitQuaternion::from_scaled_axis(step * middle).into_inner();
            omega += step * slope(&middle);
        }
        assert_eq!(causes(&wrong(&observed(&rows)))[0], "truncation", "steps of {step} s");
    }
}

/// A gyroscope mounted 5° askew, its axes taken for the body's: with and without a body.
#[test]
fn rates_of_a_sensor_that_is_mounted_askew() {
    let mut observed = motion();
    let askew = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 5.0_f64.to_radians());
    change_rates(&mut observed, |omega| askew * omega);
    let alone = verified(&observed, None);
    assert_eq!(alone.verdict, Verdict::Wrong);
    assert_eq!(causes(&alone), ["rates_disagree"]);
    assert_eq!(causes(&wrong(&observed))[0], "rates_disagree");
}

/// ω of one body beside attitudes of another: no reading of the columns makes one motion of them.
#[test]
fn rates_of_another_body() {
    let mut other = book(TorqueSpecs::default());
    let omega = polhode::body::AngularVelocity::new([-3.0, 1.0, 4.0]).expect("finite");
    other.problem.initial.angular_velocity = omega;
    let mut observed = motion();
    observed.angular_velocity.as_mut().expect("rates").columns =
        exact(&other, &evenly(1500, 0.01)).angular_velocity.expect("rates").columns;
    for body in [None, Some(book(TorqueSpecs::default()))] {
        let found = verified(&observed, body.as_ref());
        assert_eq!(found.verdict, Verdict::Wrong);
        assert_eq!(causes(&found)[0], "rates_disagree");
    }
}

/// ω of 4 ms later than the attitude beside it: each obeys physics by itself.
#[test]
fn rates_of_another_instant() {
    const LATE: f64 = 0.004;
    let times = evenly(1500, 0.01);
    let later: Vec<f64> = times.iter().map(|time| time + LATE).collect();
    for told in [None, Some(Axes::Body)] {
        let mut observed = motion();
        let rates = observed.angular_velocity.as_mut().expect("rates");
        rates.axes = told;
        rates.columns = exact(&book(TorqueSpecs::default()), &later).angular_velocity.expect("rates").columns;
        let found = wrong(&observed);
        assert_eq!(causes(&found), ["out_of_step"]);
        let Cause::OutOfStep { lag_s, .. } = found.causes[0].cause else { panic!("{:?}", found.causes) };
        assert!((lag_s + LATE).abs() < 1e-6, "{lag_s} is not −{LATE}");
    }
}
