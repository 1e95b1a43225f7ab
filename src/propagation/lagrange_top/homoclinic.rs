use super::nutation::{Form, Nutation, even_rates, signed};
use super::roots::Roots;
use super::start::Start;
use crate::numerics::{DoubleDouble, ShiftedPair, carlson_rf, exp_of_negative};

/// u₂ = u₃ = 1: down from upright and back to it, once and for ever. sn → tanh.
///
/// The limit of the sums of Gaussians with one term left in B and two in A.
#[derive(Debug, Clone, Copy)]
pub struct Homoclinic {
    /// u of the elliptic functions at the start, and du/dt in 1/s.
    u0: DoubleDouble,
    rate: DoubleDouble,
    /// cos and sin of the angle by which A passes the bottom.
    direction: [f64; 2],
}

impl Homoclinic {
    pub fn form(start: &Start, roots: &Roots) -> Form<Self> {
        let rate = (start.strength * roots.lower_gap).sqrt().scale(0.5);
        // artanh √(below/gap) = ½ ln ((1 + s)/(1 − s)); as an integral it is R_F with two equal arguments.
        let share = roots.above / roots.lower_gap;
        let integral = carlson_rf(share, share, DoubleDouble::ONE);
        let size = (roots.below / roots.lower_gap).sqrt() * integral;
        let cos = (roots.lower_gap / roots.from_bottom_2).sqrt();
        let sin = signed((roots.from_bottom_1 / roots.from_bottom_2).sqrt(), roots.sum);
        Form {
            nutation: Self { u0: signed(size, start.slope()), rate, direction: [cos.hi(), sin.hi()] },
            rates: even_rates(start, roots),
            zeta: (roots.from_top_1 / roots.from_bottom_2).sqrt().scale(2.0),
            slope_rate: rate,
        }
    }
}

impl Nutation for Homoclinic {
    #[inline(always)]
    fn at(&self, time: f64) -> ShiftedPair {
        let u = (self.u0 + self.rate * time).hi();
        let side = if u < 0.0 { -1.0 } else { 1.0 };
        let root = exp_of_negative(-u.abs());
        let x = root * root;
        let [cos, sin] = self.direction;
        ShiftedPair {
            first: [side * (1.0 - x) * cos, -(1.0 + x) * sin],
            first_slope: [2.0 * x * cos, side * 2.0 * x * sin],
            second: [root, 0.0],
            second_slope: [-side * root, 0.0],
            turns: [0.0; 2],
        }
    }
}
