use crate::body::State;
use crate::numerics::DoubleDouble;

/// The motion at one instant, to about 30 digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PreciseState {
    /// World from principal axes: w, x, y, z.
    pub attitude: [DoubleDouble; 4],
    /// In principal axes, rad/s.
    pub angular_velocity: [DoubleDouble; 3],
    /// Of the reference point, world axes, m; of no meaning where no translation was asked for.
    pub position: [DoubleDouble; 3],
    /// Of the reference point, world axes, m/s; of no meaning where no translation was asked for.
    pub velocity: [DoubleDouble; 3],
}

impl PreciseState {
    /// The same state, its numbers taken as exact but for the quaternion's length, which becomes 1.
    pub(super) fn from_state(state: &State) -> Self {
        let mut exact = Self {
            attitude: state.attitude.wxyz().map(DoubleDouble::from),
            angular_velocity: <[f64; 3]>::from(state.angular_velocity.in_body()).map(DoubleDouble::from),
            position: <[f64; 3]>::from(state.position).map(DoubleDouble::from),
            velocity: <[f64; 3]>::from(state.velocity).map(DoubleDouble::from),
        };
        exact.normalise();
        exact
    }

    pub(super) fn normalise(&mut self) {
        let square = self.attitude.iter().fold(DoubleDouble::ZERO, |sum, component| sum + component.square());
        let factor = square.sqrt().recip();
        self.attitude = self.attitude.map(|component| component * factor);
    }

    pub(super) fn is_finite(&self) -> bool {
        let groups = [&self.angular_velocity, &self.position, &self.velocity];
        self.attitude.iter().chain(groups.into_iter().flatten()).all(|value| (value.hi() + value.lo()).is_finite())
    }
}
