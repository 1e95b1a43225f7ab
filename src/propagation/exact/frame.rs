use super::ExactQuaternion;

/// Principal axes named anew for the formulae: "primed" axes 1′, 2′, 3′, right-handed, along ± the body's.
///
/// ω₁′ ≥ 0 and ω₃′ ≥ 0 at the start, so that no formula needs a case for the side on which L circles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    axis: [usize; 3],
    sign: [f64; 3],
}

impl Frame {
    /// The frame with 1′, 2′, 3′ along these three different principal axes (0, 1, 2), up to sign.
    pub fn new(axis: [usize; 3], omega: [f64; 3]) -> Self {
        let side = |component: f64| if component < 0.0 { -1.0 } else { 1.0 };
        let (first, third) = (side(omega[axis[0]]), side(omega[axis[2]]));
        let parity = if (axis[0] + 1) % 3 == axis[1] { 1.0 } else { -1.0 };
        Self { axis, sign: [first, parity * first * third, third] }
    }

    /// Moments or other quantities without sign, in the primed order.
    pub fn unsigned(&self, values: [f64; 3]) -> [f64; 3] {
        self.axis.map(|axis| values[axis])
    }

    /// Primed components of a vector.
    pub fn vector(&self, in_principal: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| self.sign[k] * in_principal[self.axis[k]])
    }

    /// Where each primed component goes, and the sign it takes.
    pub fn destinations(&self) -> [(usize, f64); 3] {
        [0, 1, 2].map(|k| (self.axis[k], self.sign[k]))
    }

    /// A quaternion of primed components in principal ones: its vector part turned.
    pub fn in_principal(&self, ExactQuaternion(q): ExactQuaternion) -> ExactQuaternion {
        let mut turned = q;
        for (k, (axis, sign)) in self.destinations().into_iter().enumerate() {
            turned[1 + axis] = q[1 + k].scale(sign);
        }
        ExactQuaternion(turned)
    }

    /// The products of `left` with 1, i, j and k of the primed axes.
    pub fn times_units(&self, left: ExactQuaternion) -> [ExactQuaternion; 4] {
        let products = left.times_units();
        let along = |k: usize| {
            let (axis, sign) = self.destinations()[k];
            ExactQuaternion(products[1 + axis].0.map(|part| part.scale(sign)))
        };
        [left, along(0), along(1), along(2)]
    }

    /// The rotation that takes primed components to principal ones, of any length.
    pub fn principal_from_primed(&self) -> ExactQuaternion {
        let mut m = [[0.0; 3]; 3];
        for (k, (axis, sign)) in self.destinations().into_iter().enumerate() {
            m[axis][k] = sign;
        }
        // Four times the products of w, x, y or z with each component: a row with its own square at least 1 will do.
        let rows = [
            [1.0 + m[0][0] + m[1][1] + m[2][2], m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]],
            [m[2][1] - m[1][2], 1.0 + m[0][0] - m[1][1] - m[2][2], m[0][1] + m[1][0], m[0][2] + m[2][0]],
            [m[0][2] - m[2][0], m[0][1] + m[1][0], 1.0 - m[0][0] + m[1][1] - m[2][2], m[1][2] + m[2][1]],
            [m[1][0] - m[0][1], m[0][2] + m[2][0], m[1][2] + m[2][1], 1.0 - m[0][0] - m[1][1] + m[2][2]],
        ];
        let best = if rows[0][0] >= 1.0 {
            rows[0]
        } else if rows[1][1] >= 1.0 {
            rows[1]
        } else if rows[2][2] >= 1.0 {
            rows[2]
        } else {
            rows[3]
        };
        ExactQuaternion::along(best)
    }
}
