use super::invariants::Start;
use crate::numerics::{DoubleDouble, Phase};
use crate::propagation::exact::{Motion, QuaternionMap, Rates};

/// Regular precession of a body with J₁ = J₂: axis 3′ circles L while the body turns about axis 3′.
#[derive(Debug, Clone, Copy)]
pub struct Symmetric {
    /// By how much ω turns about −3′ in the body.
    spin: Phase,
    /// ω₁′, ω₂′ at the start, and ω₃′ for ever, rad/s.
    omega: [f64; 3],
    axes: [usize; 3],
    signs: [f64; 3],
    /// Phases of the pair (a, b) = (w + iz, x + iy) of "momentum frame from primed axes".
    phases: [Phase; 2],
    /// |a| and b at the start.
    pair: (f64, [f64; 2]),
    attitude_map: QuaternionMap<4>,
}

impl Symmetric {
    /// From a start whose ω was multiplied by `scale`, a power of two.
    pub fn new(start: &Start, scale: f64) -> Self {
        let j1 = DoubleDouble::from(start.moments[0]);
        let (w3, momentum_size) = (start.omega[2], start.momentum_squared().sqrt());
        // φ₁ about L and φ₂ about 3′, both half-angles: attitude(t) = e^(φ₁ l) attitude(0) e^(φ₂ e₃).
        let about_momentum = momentum_size / j1;
        let about_axis = start.difference(0, 2) / j1 * w3;
        let per_turn = DoubleDouble::TURNS_PER_RADIAN.scale(0.5);
        let turns =
            |rate: DoubleDouble| Phase { start: DoubleDouble::ZERO, rate: (rate * per_turn).scale(1.0 / scale) };
        let at_start = start.momentum_frame_from_primed(momentum_size, [1.0, 0.0]);
        let [w, x, y, _] = at_start.0.map(DoubleDouble::hi);
        let destinations = start.frame.destinations();
        Self {
            spin: turns(about_axis.scale(2.0)),
            omega: start.omega.map(|component| component / scale),
            axes: destinations.map(|(axis, _)| axis),
            signs: destinations.map(|(_, sign)| sign),
            phases: [turns(about_momentum + about_axis), turns(about_momentum - about_axis)],
            pair: (w, [x, y]),
            attitude_map: start.attitude_map(at_start),
        }
    }
}

impl Rates for Symmetric {
    fn axes(&self) -> [usize; 3] {
        self.axes
    }

    #[inline(always)]
    fn rates(&self, time: f64) -> [f64; 3] {
        let ([w1, w2, w3], [sign_1, sign_2, sign_3]) = (self.omega, self.signs);
        let (sin, cos) = self.spin.at(time).sin_cos();
        [sign_1 * (w1 * cos + w2 * sin), sign_2 * (w2 * cos - w1 * sin), sign_3 * w3]
    }
}

impl Motion for Symmetric {
    #[inline(always)]
    fn rates_and_attitude(&self, time: f64) -> ([f64; 3], [f64; 4]) {
        let (size, [x, y]) = self.pair;
        let (sin_a, cos_a) = self.phases[0].at(time).sin_cos();
        let (sin_b, cos_b) = self.phases[1].at(time).sin_cos();
        let pair = [size * cos_a, x * cos_b - y * sin_b, y * cos_b + x * sin_b, size * sin_a];
        (self.rates(time), self.attitude_map.unit(pair))
    }
}
