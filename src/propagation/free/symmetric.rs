use nalgebra::{Matrix4, Vector4};

use super::invariants::Start;
use super::quaternion::unit;
use crate::numerics::{DoubleDouble, Phase};
use crate::propagation::States;

/// Regular precession of a body with J₁ = J₂: axis 3′ circles L while the body turns about axis 3′.
#[derive(Debug, Clone, Copy)]
pub struct Symmetric {
    /// By how much ω turns about −3′ in the body.
    spin: Phase,
    /// ω₁′, ω₂′ at the start, and ω₃′ for ever, rad/s.
    omega: [f64; 3],
    destinations: [(usize, f64); 3],
    /// Phases of the pair (a, b) = (w + iz, x + iy) of "momentum frame from primed axes".
    phases: [Phase; 2],
    /// |a| and b at the start.
    pair: (f64, [f64; 2]),
    attitude_map: Matrix4<f64>,
}

impl Symmetric {
    /// From a start whose ω was multiplied by `scale`, a power of two.
    pub fn new(start: &Start, scale: f64) -> Self {
        let [j1, ..] = start.moments;
        let w3 = start.omega[2];
        // φ₁ about L and φ₂ about 3′, both half-angles: attitude(t) = e^(φ₁ l) attitude(0) e^(φ₂ e₃).
        let about_momentum = start.momentum_size() / j1;
        let about_axis = start.difference(0, 2) / j1 * w3;
        let turns =
            |rate: DoubleDouble| Phase { start: DoubleDouble::ZERO, rate: rate / DoubleDouble::PI.scale(4.0 * scale) };
        let at_start = start.momentum_frame_from_primed([1.0, 0.0]);
        let [w, x, y, _] = at_start.0.map(DoubleDouble::hi);
        Self {
            spin: turns(about_axis.scale(2.0)),
            omega: start.omega.map(|component| component.hi() / scale),
            destinations: start.frame.destinations(),
            phases: [turns(about_momentum + about_axis), turns(about_momentum - about_axis)],
            pair: (w, [x, y]),
            attitude_map: start.attitude_map(at_start),
        }
    }

    pub fn fill_rates(&self, times: &[f64], states: &mut States) {
        let [w1, w2, w3] = self.omega;
        let [(to_1, sign_1), (to_2, sign_2), (to_3, sign_3)] = self.destinations;
        for (row, &t) in times.iter().enumerate() {
            let (sin, cos) = self.spin.at(t).sin_cos();
            states.angular_velocity[to_1][row] = sign_1 * (w1 * cos + w2 * sin);
            states.angular_velocity[to_2][row] = sign_2 * (w2 * cos - w1 * sin);
            states.angular_velocity[to_3][row] = sign_3 * w3;
        }
    }

    pub fn fill_attitude(&self, times: &[f64], states: &mut States) {
        let (size, [x, y]) = self.pair;
        let [qw, qx, qy, qz] = &mut states.attitude;
        let rows = qw.iter_mut().zip(qx).zip(qy).zip(qz);
        for ((((qw, qx), qy), qz), &t) in rows.zip(times) {
            let (sin_a, cos_a) = self.phases[0].at(t).sin_cos();
            let (sin_b, cos_b) = self.phases[1].at(t).sin_cos();
            let p = Vector4::new(size * cos_a, x * cos_b - y * sin_b, y * cos_b + x * sin_b, size * sin_a);
            [*qw, *qx, *qy, *qz] = unit(self.attitude_map * p);
        }
    }
}
