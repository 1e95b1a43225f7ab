use nalgebra::Vector3;

/// Half the height of what is seen at distance 1: the viewer opens 55° from top to bottom, and a little stays free.
const HALF_HEIGHT: f64 = 0.47;
/// Half the width: the 3-D view is rather more than one and a half times as wide as high.
const HALF_WIDTH: f64 = 0.78;

/// Room that a body takes: a ball of `radius` about every point of the box from `lowest` to `highest`; world axes, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Room {
    pub lowest: Vector3<f64>,
    pub highest: Vector3<f64>,
    pub radius: f64,
}

/// Where the camera stands and what it looks at so that all rooms are in the picture.
///
/// One body is looked at from the front, a little from the left and from above: x comes forward, y goes right, z up;
/// where its L (`momentum`, world axes) lies level, from beside it, a little from its tip: an arrow that points away is
/// behind the body. A row of bodies is looked at from its side.
pub fn place(rooms: &[Room], momentum: &Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
    let low = |room: &Room| room.lowest - Vector3::repeat(room.radius);
    let high = |room: &Room| room.highest + Vector3::repeat(room.radius);
    let lowest = rooms.iter().map(low).reduce(|a, b| a.inf(&b)).unwrap_or_default();
    let highest = rooms.iter().map(high).reduce(|a, b| a.sup(&b)).unwrap_or_default();
    let size = highest - lowest;
    let direction = if size.y > 1.5 * size.x {
        Vector3::new(0.93, -0.2, 0.3)
    } else if size.x > 1.5 * size.y {
        Vector3::new(0.2, -0.93, 0.3)
    } else {
        beside(momentum, Vector3::new(0.78, -0.52, 0.36))
    };
    let direction = direction.normalize();
    let right = Vector3::z().cross(&direction).normalize();
    let up = direction.cross(&right);
    let target = 0.5 * (lowest + highest);
    // A ball is in the picture where its far side from the line of sight is at most so much of its depth.
    let distance_for = |(centre, radius): (Vector3<f64>, f64)| {
        let from_target = centre - target;
        let sideways = (from_target.dot(&right).abs() + radius) / HALF_WIDTH;
        let upwards = (from_target.dot(&up).abs() + radius) / HALF_HEIGHT;
        from_target.dot(&direction) + sideways.max(upwards)
    };
    let distance = rooms.iter().flat_map(corners).map(distance_for).fold(0.0, f64::max);
    (target + distance * direction, target)
}

/// A direction of the height of `usual`, across what lies level, on the usual side of it; else `usual`.
fn beside(momentum: &Vector3<f64>, usual: Vector3<f64>) -> Vector3<f64> {
    let level = Vector3::new(momentum.x, momentum.y, 0.0);
    let Some(along) = level.try_normalize(0.5 * momentum.norm()) else { return usual };
    let across = Vector3::new(-along.y, along.x, 0.0);
    let across = across * usual.dot(&across).signum();
    let flat = libm::hypot(usual.x, usual.y);
    (0.95 * across + 0.3 * along).normalize() * flat + Vector3::new(0.0, 0.0, usual.z)
}

/// The balls about the eight corners of a room's box.
fn corners(room: &Room) -> impl Iterator<Item = (Vector3<f64>, f64)> {
    let Room { lowest, highest, radius } = *room;
    (0..8_u8).map(move |corner| {
        let at = |axis: usize| if (corner >> axis) & 1 == 0 { lowest[axis] } else { highest[axis] };
        (Vector3::new(at(0), at(1), at(2)), radius)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_seen_from_its_side_and_one_body_from_nearer() {
        let ball = |y: f64| {
            let centre = Vector3::new(0.0, y, 0.0);
            Room { lowest: centre, highest: centre, radius: 1.0 }
        };
        let (eye, target) = place(&[ball(-6.0), ball(0.0), ball(6.0)], &Vector3::y());
        assert_eq!(target, Vector3::zeros());
        assert!(eye.x > 4.0 * eye.y.abs(), "{eye}");
        let (near, _) = place(&[ball(0.0)], &Vector3::z());
        assert!((near.norm() - 1.0 / HALF_HEIGHT).abs() < 1e-12, "{near}");
    }

    #[test]
    fn what_lies_level_is_seen_across_and_points_out_of_the_picture() {
        let room = Room { lowest: Vector3::zeros(), highest: Vector3::zeros(), radius: 1.0 };
        for angle in [0.0, 0.7, 1.6, 3.0, 4.4, 5.5] {
            let (sin, cos) = libm::sincos(angle);
            let momentum = Vector3::new(cos, sin, 0.1);
            let (eye, _) = place(&[room], &momentum);
            let towards = eye.normalize().dot(&momentum.normalize());
            assert!((0.2..0.4).contains(&towards), "{towards}");
        }
    }
}
