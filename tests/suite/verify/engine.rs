//! A physics engine as many write it, with its mistakes at choice; and what it would record.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use polhode::comparison::verify::{DEFAULT_TOLERANCE_RAD, Verification, verify};
use polhode::recording::{Axes, Observed, Track};
use polhode::scenario::{BodySpec, Plan, PlannedBody, Scenario, TorqueSpecs};
use polhode::telemetry::Channel;

/// A book, kg m².
pub const MOMENTS: [f64; 3] = [0.002, 0.0042, 0.006];
/// rad/s: it tumbles, about no axis in particular.
pub const OMEGA: [f64; 3] = [2.0, 4.0, 1.5];
pub const ATTITUDE: [f64; 4] = [0.5, 0.5, -0.5, 0.5];

/// The gyroscopic term.
#[derive(Clone, Copy, PartialEq)]
pub enum Gyroscopic {
    Missing,
    /// By the ω of before.
    Explicit,
    /// One Newton step of the implicit equation, as engines do.
    Implicit,
    /// In world axes, with the tensor as it was at the start of body axes: never turned.
    NotRotated,
}

/// How an attitude is made of the one before.
#[derive(Clone, Copy, PartialEq)]
pub enum Turn {
    Exponential,
    /// q + h q̇, normalised.
    NormalisedQuaternion,
    /// Not normalised either.
    Quaternion,
    /// ω in body axes multiplied from the left.
    WrongSide,
}

#[derive(Clone, Copy)]
pub struct Engine {
    pub moments: [f64; 3],
    pub gyroscopic: Gyroscopic,
    pub turn: Turn,
    /// Whether attitudes are moved by the ω of before.
    pub by_old_rate: bool,
    /// s.
    pub step: f64,
    /// Steps from sample to sample.
    pub every: usize,
    /// 1/s.
    pub damping: f64,
    /// rad/s.
    pub fastest: f64,
    /// N m, in body axes.
    pub torque_in_body: Vector3<f64>,
    /// N m, in world axes.
    pub torque_in_world: Vector3<f64>,
    /// Whether what is stepped is rounded to 32 bits after each.
    pub is_single: bool,
}

impl Default for Engine {
    fn default() -> Self {
        Self {
            moments: MOMENTS,
            gyroscopic: Gyroscopic::Explicit,
            turn: Turn::Exponential,
            by_old_rate: false,
            step: 1.0 / 240.0,
            every: 1,
            damping: 0.0,
            fastest: f64::INFINITY,
            torque_in_body: Vector3::zeros(),
            torque_in_world: Vector3::zeros(),
            is_single: false,
        }
    }
}

impl Engine {
    pub fn record(&self, duration: f64) -> Observed {
        let (mut q, mut omega) = (quaternion(ATTITUDE), Vector3::from(OMEGA));
        let mut rows = vec![(0.0, q, omega)];
        let mut step = 0_u32;
        while f64::from(step) * self.step < duration {
            step += 1;
            let before = omega;
            omega = self.stepped(&UnitQuaternion::new_normalize(q), omega);
            q = self.turned(q, if self.by_old_rate { before } else { omega });
            if self.is_single {
                q = Quaternion::from(q.coords.map(single));
                omega = omega.map(single);
            }
            if (step as usize).is_multiple_of(self.every) {
                rows.push((f64::from(step) * self.step, q, omega));
            }
        }
        observed(&rows)
    }

    fn stepped(&self, q: &UnitQuaternion<f64>, omega: Vector3<f64>) -> Vector3<f64> {
        let inertia = Matrix3::from_diagonal(&Vector3::from(self.moments));
        let inverse = Matrix3::from_diagonal(&Vector3::from(self.moments.map(f64::recip)));
        let h = self.step;
        let torque = self.torque_in_body + q.inverse() * self.torque_in_world;
        let after = match self.gyroscopic {
            Gyroscopic::Missing => omega + h * inverse * torque,
            Gyroscopic::Explicit => omega + h * inverse * (torque - omega.cross(&(inertia * omega))),
            Gyroscopic::Implicit => {
                let pushed = omega + h * inverse * torque;
                let residual = h * pushed.cross(&(inertia * pushed));
                let slope = inertia + h * (pushed.cross_matrix() * inertia - (inertia * pushed).cross_matrix());
                pushed - slope.try_inverse().expect("near the tensor") * residual
            }
            Gyroscopic::NotRotated => {
                let (rate, push) = (q * omega, q * torque);
                q.inverse() * (rate + h * inverse * (push - rate.cross(&(inertia * rate))))
            }
        };
        let after = after * (1.0 - self.damping * h);
        if after.norm() > self.fastest { after * (self.fastest / after.norm()) } else { after }
    }

    fn turned(&self, q: Quaternion<f64>, omega: Vector3<f64>) -> Quaternion<f64> {
        let h = self.step;
        let rate = Quaternion::from_imag(0.5 * h * omega);
        match self.turn {
            Turn::Exponential => q * UnitQuaternion::from_scaled_axis(h * omega).into_inner(),
            Turn::NormalisedQuaternion => (q + q * rate).normalize(),
            Turn::Quaternion => q + q * rate,
            Turn::WrongSide => UnitQuaternion::from_scaled_axis(h * omega).into_inner() * q,
        }
    }
}

#[expect(clippy::cast_possible_truncation, reason = "rounding is what is wanted")]
pub fn single(value: f64) -> f64 {
    f64::from(value as f32)
}

pub fn quaternion([w, x, y, z]: [f64; 4]) -> Quaternion<f64> {
    Quaternion::new(w, x, y, z)
}

/// ω in body axes, as a file that does not tell.
pub fn observed(rows: &[(f64, Quaternion<f64>, Vector3<f64>)]) -> Observed {
    let times_s: Vec<f64> = rows.iter().map(|row| row.0).collect();
    let q = |row: &Quaternion<f64>| [row.w, row.i, row.j, row.k];
    Observed {
        name: "book".into(),
        attitude: Some(Track {
            times_s: times_s.clone(),
            columns: std::array::from_fn(|i| rows.iter().map(|row| q(&row.1)[i]).collect()),
            axes: None,
            resolution: f64::EPSILON / 2.0,
        }),
        angular_velocity: Some(Track {
            times_s,
            columns: std::array::from_fn(|i| rows.iter().map(|row| row.2[i]).collect()),
            axes: None,
            resolution: f64::EPSILON / 2.0,
        }),
        ..Observed::default()
    }
}

/// The book, with what acts on it.
pub fn book(torque: TorqueSpecs) -> PlannedBody {
    let spec = BodySpec {
        principal_moments_kg_m2: Some(MOMENTS),
        attitude: Some(ATTITUDE),
        angular_velocity_rad_s: Some(OMEGA),
        torque,
        ..BodySpec::default()
    };
    let scene =
        Scenario { duration_s: Some(10.0), sample_every_s: Some(0.01), body: vec![spec], ..Scenario::default() };
    Plan::new(&scene).expect("a plan").bodies.remove(0)
}

/// Its exact motion at `times`.
pub fn exact(body: &PlannedBody, times: &[f64]) -> Observed {
    let samples = body.sample(&[Channel::Attitude, Channel::AngularVelocity], times).expect("sampled");
    let column = |channel, i: usize| samples.channel(channel).expect("asked for")[i].clone();
    let resolution = f64::EPSILON / 2.0;
    Observed {
        name: body.name.clone(),
        attitude: Some(Track {
            times_s: times.to_vec(),
            columns: std::array::from_fn(|i| column(Channel::Attitude, i)),
            axes: None,
            resolution,
        }),
        angular_velocity: Some(Track {
            times_s: times.to_vec(),
            columns: std::array::from_fn(|i| column(Channel::AngularVelocity, i)),
            axes: Some(Axes::Body),
            resolution,
        }),
        ..Observed::default()
    }
}

pub fn evenly(count: u32, step: f64) -> Vec<f64> {
    (0..count).map(|k| f64::from(k) * step).collect()
}

pub fn verified(observed: &Observed, body: Option<&PlannedBody>) -> Verification {
    let found = verify(observed, body, 0.0, DEFAULT_TOLERANCE_RAD).unwrap_or_else(|error| panic!("{error}"));
    println!("{found:#?}");
    found
}

/// The names of the causes, the likeliest first.
pub fn causes(found: &Verification) -> Vec<&'static str> {
    found.causes.iter().map(|finding| finding.cause.name()).collect()
}

/// Puts attitudes that are stepped by q + h q̇, normalised, by the rates recorded.
pub fn step_attitudes(observed: &mut Observed, step: f64) {
    let rates = observed.angular_velocity.clone().expect("rates").columns;
    let attitude = observed.attitude.as_mut().expect("attitudes");
    let mut q = quaternion(attitude.columns.each_ref().map(|column| column[0]));
    for k in 1..attitude.times_s.len() {
        // The mean of both ends, so that no lag hides in it.
        let omega = Vector3::from(rates.each_ref().map(|column| 0.5 * (column[k] + column[k - 1])));
        q = (q + q * Quaternion::from_imag(0.5 * step * omega)).normalize();
        for (column, value) in attitude.columns.iter_mut().zip([q.w, q.i, q.j, q.k]) {
            column[k] = value;
        }
    }
}

/// Exact motion from each state to the next, which is rounded to 32 bits every time.
pub fn rounded_on_the_way(body: &PlannedBody, count: usize, step: f64) -> Observed {
    let (mut q, mut omega) = (quaternion(ATTITUDE), Vector3::from(OMEGA));
    let mut rows = Vec::new();
    let mut time = 0.0;
    for k in 0..count {
        rows.push((time, q, omega));
        let mut from = body.clone();
        from.problem.initial.attitude = polhode::body::Attitude::from_world_from_body(UnitQuaternion::new_normalize(q));
        from.problem.initial.angular_velocity = polhode::body::AngularVelocity::from_vector(omega);
        let next = exact(&from, &[step]);
        let read = |columns: &[Vec<f64>], i: usize| single(columns[i][0]);
        let attitude = next.attitude.expect("it").columns;
        q = quaternion(std::array::from_fn(|i| read(&attitude, i)));
        let rates = next.angular_velocity.expect("it").columns;
        omega = Vector3::from(std::array::from_fn(|i| read(&rates, i)));
        #[expect(clippy::cast_precision_loss, reason = "thousands")]
        {
            time = (k + 1) as f64 * step;
        }
    }
    observed(&rows)
}
