use nalgebra::{Complex, Vector3};

use super::{Problem, Torque};
use crate::body::State;

/// The fourth integral of Kovalevskaya's top `[Kow89]`: I₁ = I₂ = 2 I₃, under one force constant in the world, all the time,
/// at an arm across axis 3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kovalevskaya {
    /// Numbers of the axes 1 and 2.
    across: [usize; 2],
    /// World axes, N.
    force: Vector3<f64>,
    /// (a₁ + i a₂) / I₃, 1/(kg m).
    leverage: Complex<f64>,
}

impl Kovalevskaya {
    /// Of this problem, if it is such a top: moments to a few units in the last place, the arm exactly.
    #[must_use]
    pub fn of(problem: &Problem) -> Option<Self> {
        let [load] = problem.loads.as_slice() else { return None };
        let Torque::ForceWorld { force, arm } = load.torque else { return None };
        let moments = problem.moments.vector();
        let axis = moments.imin();
        let [one, other] = [(axis + 1) % 3, (axis + 2) % 3];
        let twice = 2.0 * moments[axis];
        let fits = |moment: f64| (moment - twice).abs() <= 4.0 * f64::EPSILON * twice;
        let acts_always = load.window.start <= 0.0 && load.window.end == f64::INFINITY;
        let is_such = acts_always && fits(moments[one]) && fits(moments[other]) && arm[axis] == 0.0;
        let leverage = Complex::new(arm[one], arm[other]) / moments[axis];
        (is_such && arm != Vector3::zeros() && force != Vector3::zeros()).then_some(Self {
            across: [one, other],
            force,
            leverage,
        })
    }

    /// |(ω₁ + iω₂)² + (a₁ + ia₂)(f₁ + if₂)/I₃|², f the force in the body, rad⁴/s⁴.
    #[must_use]
    pub fn value(&self, state: &State) -> f64 {
        let [one, other] = self.across;
        let across = |v: Vector3<f64>| Complex::new(v[one], v[other]);
        let omega = across(state.angular_velocity.in_body());
        let pull = self.leverage * across(state.attitude.to_body(&self.force));
        // (p + iq)² by factors: no squares are taken from each other.
        let (p, q) = (omega.re, omega.im);
        (Complex::new((p - q) * (p + q), 2.0 * p * q) + pull).norm_sqr()
    }
}
