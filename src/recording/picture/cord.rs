use nalgebra::Vector3;

use crate::dynamics::{General, Torque};
use crate::scenario::PlannedBody;

/// A spring that holds a body: from a point of the world to a point of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cord {
    /// Its end in the world, m.
    pub anchor: Vector3<f64>,
    /// Its end on the body, from the reference point, body axes, m.
    pub point: Vector3<f64>,
}

impl Cord {
    /// All that hold `body`, whether they always do or not.
    pub(super) fn of(body: &PlannedBody) -> Vec<Self> {
        let springs = body.problem.loads.iter().filter_map(|load| match &load.torque {
            Torque::General(load) => match load.kind {
                General::Spring(spring) => Some(spring),
                _ => None,
            },
            _ => None,
        });
        let to_body = body.properties.body_from_principal;
        springs.map(|spring| Self { anchor: spring.anchor, point: to_body * spring.arm }).collect()
    }
}
