use crate::numerics::DoubleDouble;
use crate::propagation::exact::ExactQuaternion;
use crate::propagation::exact::Frame;

/// What a start determines, in double-double: moments and ω in primed axes and of the order of 1.
#[derive(Debug, Clone, Copy)]
pub struct Start {
    pub frame: Frame,
    /// J₁, J₂, J₃.
    pub moments: [DoubleDouble; 3],
    /// ω₁, ω₂, ω₃.
    pub omega: [DoubleDouble; 3],
    /// World from principal axes, exactly unit.
    pub attitude: ExactQuaternion,
}

impl Start {
    pub fn new(frame: Frame, moments: [f64; 3], omega: [f64; 3], attitude: ExactQuaternion) -> Self {
        Self {
            frame,
            moments: frame.unsigned(moments).map(DoubleDouble::from),
            omega: frame.vector(omega).map(DoubleDouble::from),
            attitude,
        }
    }

    /// Jᵢ − Jⱼ, exactly.
    pub fn difference(&self, i: usize, j: usize) -> DoubleDouble {
        DoubleDouble::sum(self.moments[i].hi(), -self.moments[j].hi())
    }

    /// Jᵢ (Jᵢ − Jⱼ) ωᵢ²: the share of axis i in L² − 2E Jⱼ.
    pub fn share(&self, i: usize, j: usize) -> DoubleDouble {
        self.moments[i] * self.difference(i, j) * self.omega[i].square()
    }

    /// L = J ω.
    pub fn momentum(&self) -> [DoubleDouble; 3] {
        [0, 1, 2].map(|k| self.moments[k] * self.omega[k])
    }

    /// |L|.
    pub fn momentum_size(&self) -> DoubleDouble {
        let [x, y, z] = self.momentum();
        (x.square() + y.square() + z.square()).sqrt()
    }

    /// 2E.
    pub fn twice_energy(&self) -> DoubleDouble {
        let [x, y, z] = [0, 1, 2].map(|k| self.moments[k] * self.omega[k].square());
        x + y + z
    }

    /// The swing that takes primed axes to the frame whose third axis is L, turned about L by the half-angle whose
    /// cosine and sine are given. L₃ must not be negative.
    ///
    /// As a pair of complex numbers a = w + iz, b = x + iy: conj(a) b = (l₂ − i l₁)/2 for l = L/|L|.
    pub fn momentum_frame_from_primed(&self, [cos, sin]: [f64; 2]) -> ExactQuaternion {
        let over_size = self.momentum_size().recip();
        let [l1, l2, l3] = self.momentum().map(|component| component * over_size);
        let swing = ExactQuaternion::normalised([DoubleDouble::ONE + l3, l2, -l1, DoubleDouble::ZERO]);
        let zero = DoubleDouble::ZERO;
        ExactQuaternion::normalised([cos.into(), zero, zero, sin.into()]).times(swing)
    }

    /// The matrix that takes the components of "momentum frame from primed axes" to the attitude, given the former at t = 0.
    pub fn attitude_map(&self, at_start: ExactQuaternion) -> nalgebra::Matrix4<f64> {
        let principal_from_primed = self.frame.principal_from_primed();
        let world_from_momentum = self.attitude.times(principal_from_primed).times(at_start.conjugate());
        world_from_momentum.around(principal_from_primed.conjugate())
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
    /// c: cosine of the angle from 3′ to L where cn = 1.
    pub cosine: DoubleDouble,
    /// √(1 − c²), formed without that subtraction.
    pub sine: DoubleDouble,
    /// (2E + |L| w₃₀)/(2(|L| + J₃ w₃₀)): half the rate about L of an axis that stays in step with L and 3′.
    pub half_rate: DoubleDouble,
}

impl Polhode {
    /// `separation` is L² − 2E J₂, at least zero times the sign of J₃ − J₁.
    pub fn new(start: &Start, separation: DoubleDouble) -> Self {
        let [j1, j2, j3] = start.moments;
        let [w1, w2, w3] = start.omega;
        // Each of L² − 2E J₁ and 2E J₃ − L² as a sum of terms of one sign.
        let (d1, d3) = (start.share(1, 0) + start.share(2, 0), -(start.share(0, 2) + start.share(1, 2)));
        let (j21, j31, j32) = (start.difference(1, 0), start.difference(2, 0), start.difference(2, 1));
        let sense = if j31.hi() < 0.0 { -1.0 } else { 1.0 };
        let (w10_squared, w20_squared) = (d3 / (j1 * j31), d3 / (j2 * j32));
        let w30_squared = d1 / (j3 * j31);
        let amplitudes = [w10_squared.sqrt(), w20_squared.sqrt() * sense, w30_squared.sqrt()];
        let size = start.momentum_size();
        let along = j3 * amplitudes[2];
        let denominator = (d1 * j32).recip();
        Self {
            amplitudes,
            sn: w2 / amplitudes[1],
            cn_squared: w1.square() / w10_squared,
            dn_squared: w3.square() / w30_squared,
            rate: (d1 * j32 / (j1 * j2 * j3)).sqrt(),
            parameter: d3 * j21 * denominator,
            complement: separation * j31 * denominator,
            sense,
            cosine: along / size,
            sine: j1 * amplitudes[0] / size,
            half_rate: (start.twice_energy() + size * amplitudes[2]) / (size + along).scale(2.0),
        }
    }
}
