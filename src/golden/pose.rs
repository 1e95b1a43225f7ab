/// What a simulation says of a body at one time: its attitude and, if that is to be compared too, its angular velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    pub(super) attitude_wxyz: [f64; 4],
    pub(super) angular_velocity: Option<Turning>,
}

/// An angular velocity, rad/s, with the axes it is told in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Turning {
    InBody([f64; 3]),
    InWorld([f64; 3]),
}

impl Pose {
    /// The quaternion that turns body components into world components, scalar part first. Its length does not count.
    #[must_use]
    pub const fn wxyz(quaternion: [f64; 4]) -> Self {
        Self { attitude_wxyz: quaternion, angular_velocity: None }
    }

    /// The same with the scalar part last, as many engines keep it.
    #[must_use]
    pub const fn xyzw([x, y, z, w]: [f64; 4]) -> Self {
        Self::wxyz([w, x, y, z])
    }

    /// The same, turning by `angular_velocity`, rad/s, in body axes.
    #[must_use]
    pub const fn turning_in_body(self, angular_velocity: [f64; 3]) -> Self {
        Self { angular_velocity: Some(Turning::InBody(angular_velocity)), ..self }
    }

    /// The same, turning by `angular_velocity`, rad/s, in world axes, as physics engines have it.
    #[must_use]
    pub const fn turning_in_world(self, angular_velocity: [f64; 3]) -> Self {
        Self { angular_velocity: Some(Turning::InWorld(angular_velocity)), ..self }
    }

    /// The quaternion w, x, y, z, world from body.
    #[must_use]
    pub const fn attitude_wxyz(&self) -> [f64; 4] {
        self.attitude_wxyz
    }

    /// ω in body axes, rad/s, if it is told.
    #[must_use]
    pub fn angular_velocity_in_body(&self) -> Option<[f64; 3]> {
        let [w, x, y, z] = self.attitude_wxyz;
        Some(match self.angular_velocity? {
            Turning::InBody(rates) => rates,
            Turning::InWorld(rates) => rotated([w, -x, -y, -z], rates),
        })
    }

    /// ω in world axes, rad/s, if it is told.
    #[must_use]
    pub fn angular_velocity_in_world(&self) -> Option<[f64; 3]> {
        Some(match self.angular_velocity? {
            Turning::InBody(rates) => rotated(self.attitude_wxyz, rates),
            Turning::InWorld(rates) => rates,
        })
    }

    /// Whether its angular velocity is told in world axes.
    pub(super) const fn is_turning_in_world(&self) -> bool {
        matches!(self.angular_velocity, Some(Turning::InWorld(_)))
    }

    /// The same attitude as a unit quaternion; not finite where there is none.
    pub(super) fn unit_wxyz(&self) -> [f64; 4] {
        let length = self.length();
        self.attitude_wxyz.map(|part| part / length)
    }

    /// Of the quaternion.
    pub(super) fn length(&self) -> f64 {
        let [w, x, y, z] = self.attitude_wxyz;
        libm::hypot(libm::hypot(w, x), libm::hypot(y, z))
    }
}

/// v + 2 r × (r × v + w v) / |q|².
fn rotated([w, x, y, z]: [f64; 4], vector: [f64; 3]) -> [f64; 3] {
    let axis = [x, y, z];
    let first = cross(axis, vector);
    let inner = [0, 1, 2].map(|k| first[k] + w * vector[k]);
    let turned = cross(axis, inner);
    let square = w * w + x * x + y * y + z * z;
    [0, 1, 2].map(|k| vector[k] + 2.0 * turned[k] / square)
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A turn of ¼ about z, of twice the length: x of the body is y of the world.
    #[test]
    fn axes_are_those_of_the_quaternion_whatever_its_length() {
        let quarter = Pose::wxyz([2.0, 0.0, 0.0, 2.0]);
        let close = |a: Option<[f64; 3]>, b: [f64; 3]| a.is_some_and(|a| (0..3).all(|k| (a[k] - b[k]).abs() < 1e-15));
        assert!(close(quarter.turning_in_body([1.0, 0.0, 0.5]).angular_velocity_in_world(), [0.0, 1.0, 0.5]));
        assert!(close(quarter.turning_in_world([0.0, 1.0, 0.5]).angular_velocity_in_body(), [1.0, 0.0, 0.5]));
        assert_eq!(Pose::xyzw([0.1, 0.2, 0.3, 0.4]), Pose::wxyz([0.4, 0.1, 0.2, 0.3]));
        assert_eq!(quarter.angular_velocity_in_body(), None);
    }
}
