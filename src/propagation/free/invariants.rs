use crate::numerics::DoubleDouble;
use crate::propagation::exact::{ExactQuaternion, Frame, QuaternionMap};

/// What a start determines: moments and ω in primed axes, of the order of 1 and exact.
#[derive(Debug, Clone, Copy)]
pub struct Start {
    pub frame: Frame,
    /// J₁, J₂, J₃.
    pub moments: [f64; 3],
    /// ω₁, ω₂, ω₃.
    pub omega: [f64; 3],
    /// World from principal axes, of any length.
    pub attitude: ExactQuaternion,
}

impl Start {
    pub fn new(frame: Frame, moments: [f64; 3], omega: [f64; 3], attitude: ExactQuaternion) -> Self {
        Self { frame, moments: frame.unsigned(moments), omega: frame.vector(omega), attitude }
    }

    /// Jᵢ − Jⱼ.
    pub fn difference(&self, i: usize, j: usize) -> DoubleDouble {
        DoubleDouble::sum(self.moments[i], -self.moments[j])
    }

    /// Jᵢ (Jᵢ − Jⱼ) ωᵢ²: the share of axis i in L² − 2E Jⱼ.
    pub fn share(&self, i: usize, j: usize) -> DoubleDouble {
        self.difference(i, j) * self.moments[i] * DoubleDouble::product(self.omega[i], self.omega[i])
    }

    /// L = J ω.
    pub fn momentum(&self) -> [DoubleDouble; 3] {
        [0, 1, 2].map(|k| DoubleDouble::product(self.moments[k], self.omega[k]))
    }

    /// L².
    pub fn momentum_squared(&self) -> DoubleDouble {
        let [x, y, z] = self.momentum().map(DoubleDouble::square);
        x + y + z
    }

    /// 2E.
    pub fn twice_energy(&self) -> DoubleDouble {
        let [x, y, z] = [0, 1, 2].map(|k| DoubleDouble::product(self.omega[k], self.omega[k]) * self.moments[k]);
        x + y + z
    }

    /// Along the swing that takes primed axes to the frame whose third axis is L, turned about L by the half-angle whose
    /// cosine and sine are in the ratio given. L₃ must not be negative; |L| is given.
    ///
    /// As a pair of complex numbers a = w + iz, b = x + iy: conj(a) b = (l₂ − i l₁)/2 for l = L/|L|.
    pub fn momentum_frame_from_primed(&self, size: DoubleDouble, [cos, sin]: [f64; 2]) -> ExactQuaternion {
        let [l1, l2, l3] = self.momentum();
        let upright = size + l3;
        ExactQuaternion([upright * cos, l2 * cos + l1 * sin, l2 * sin - l1 * cos, upright * sin])
    }

    /// What takes the components of "momentum frame from primed axes" to the attitude, given the former at t = 0.
    pub fn attitude_map(&self, at_start: ExactQuaternion) -> QuaternionMap<4> {
        // With P = "principal from primed" the attitude is A P s* q P*, and P s* q P* is s* q in principal axes.
        let world_from_momentum = self.attitude.times(self.frame.in_principal(at_start.conjugate()));
        QuaternionMap::new(self.frame.times_units(world_from_momentum))
    }
}

/// Where the polhode runs, of a body with three different moments that L circles about axis 3′:
/// ω = (w₁₀ cn u, ±w₂₀ sn u, w₃₀ dn u), u = u₀ + rate t.
#[derive(Debug, Clone, Copy)]
pub struct Polhode {
    /// w₁₀, w₂₀ (with the sign of J₃ − J₁), w₃₀.
    pub amplitudes: [DoubleDouble; 3],
    /// sn u₀ with its sign.
    pub sn: DoubleDouble,
    /// (cn u₀)².
    pub cn_squared: DoubleDouble,
    /// (dn u₀)².
    pub dn_squared: DoubleDouble,
    /// du/dt.
    pub rate: DoubleDouble,
    /// m.
    pub parameter: DoubleDouble,
    /// 1 − m.
    pub complement: DoubleDouble,
    /// Sign of J₃ − J₁.
    pub sense: f64,
    /// |L|.
    pub momentum_size: DoubleDouble,
    /// tan θ/2, θ the angle from 3′ to L where cn = 1.
    pub half_tangent: DoubleDouble,
    /// (2E + |L| w₃₀)/(2(|L| + J₃ w₃₀)): half the rate about L of an axis that stays in step with L and 3′.
    pub half_rate: DoubleDouble,
    /// s² with s = sn(σ, 1 − m), σ being where L points, and 1 − s² and 1 − (1 − m) s².
    pub shift: [DoubleDouble; 3],
}

impl Polhode {
    /// `separation` is L² − 2E J₂, at least zero times the sign of J₃ − J₁.
    pub fn new(start: &Start, separation: DoubleDouble) -> Self {
        let [j1, j2, j3] = start.moments;
        // Each of L² − 2E J₁ and 2E J₃ − L² as a sum of terms of one sign.
        let ([share_1, share_3], momentum_squared) =
            ([-start.share(0, 2), start.share(2, 0)], start.momentum_squared());
        let (d1, d3) = (start.share(1, 0) + share_3, share_1 - start.share(1, 2));
        let (j21, j31, j32) = (start.difference(1, 0), start.difference(2, 0), start.difference(2, 1));
        let sense = if j31.hi() < 0.0 { -1.0 } else { 1.0 };
        let (w10, w20) = ((d3 / (j31 * j1)).sqrt(), (d3 / (j32 * j2)).sqrt() * sense);
        let w30 = (d1 / (j31 * j3)).sqrt();
        let momentum_size = momentum_squared.sqrt();
        let size_and_along = momentum_size + w30 * j3;
        let (span, wide) = (d1 * j32, j31 * j2);
        let over_span = span.recip();
        Self {
            amplitudes: [w10, w20, w30],
            sn: DoubleDouble::from(start.omega[1]) / w20,
            cn_squared: share_1 / d3,
            dn_squared: share_3 / d1,
            rate: (span / (DoubleDouble::product(j1, j2) * j3)).sqrt(),
            parameter: d3 * j21 * over_span,
            complement: separation * j31 * over_span,
            sense,
            momentum_size,
            half_tangent: w10 * j1 / size_and_along,
            half_rate: (start.twice_energy() + momentum_size * w30) / size_and_along.scale(2.0),
            shift: [j32 * j1 / wide, j21 * j3 / wide, j21 * momentum_squared / (d1 * j2)],
        }
    }
}
