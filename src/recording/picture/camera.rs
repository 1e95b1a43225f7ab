use nalgebra::Vector3;

/// Half the height of what is seen at distance 1: the viewer opens 55° from top to bottom, and some of it stays free.
const HALF_HEIGHT: f64 = 0.45;
/// Half the width: the 3-D view is about one and a half times as wide as high.
const HALF_WIDTH: f64 = 0.68;

/// Where the camera stands and what it looks at so that all boxes (lowest and highest corner, m) are in the picture.
///
/// One body is looked at from the front, a little from the right and from above: x comes forward, y goes right, z up.
/// A row of bodies is looked at from its side.
pub fn place(boxes: &[[Vector3<f64>; 2]]) -> (Vector3<f64>, Vector3<f64>) {
    let lowest = boxes.iter().map(|[lowest, _]| *lowest).reduce(|a, b| a.inf(&b)).unwrap_or_default();
    let highest = boxes.iter().map(|[_, highest]| *highest).reduce(|a, b| a.sup(&b)).unwrap_or_default();
    let size = highest - lowest;
    let direction = if size.y > 2.0 * size.x {
        Vector3::new(0.93, -0.2, 0.3)
    } else if size.x > 2.0 * size.y {
        Vector3::new(0.2, -0.93, 0.3)
    } else {
        Vector3::new(0.78, -0.52, 0.36)
    };
    let direction = direction.normalize();
    let right = Vector3::z().cross(&direction).normalize();
    let up = direction.cross(&right);
    let target = 0.5 * (lowest + highest);
    // A corner is in the picture where its distance from the line of sight is at most so much of its depth.
    let distance_for = |corner: Vector3<f64>| {
        let from_target = corner - target;
        let sideways = from_target.dot(&right).abs() / HALF_WIDTH;
        let upwards = from_target.dot(&up).abs() / HALF_HEIGHT;
        from_target.dot(&direction) + sideways.max(upwards)
    };
    let distance = boxes.iter().flat_map(corners).map(distance_for).fold(0.0, f64::max);
    (target + distance * direction, target)
}

/// The eight corners of a box.
fn corners([lowest, highest]: &[Vector3<f64>; 2]) -> impl Iterator<Item = Vector3<f64>> {
    (0..8_u8).map(move |corner| {
        Vector3::from_fn(|axis, _| if corner >> axis & 1 == 0 { lowest[axis] } else { highest[axis] })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_seen_from_its_side_and_as_large_as_it_fits() {
        let cube = |y: f64| [Vector3::new(-1.0, y - 1.0, -1.0), Vector3::new(1.0, y + 1.0, 1.0)];
        let (eye, target) = place(&[cube(-6.0), cube(0.0), cube(6.0)]);
        assert_eq!(target, Vector3::zeros());
        assert!(eye.x > 4.0 * eye.y.abs(), "{eye}");
        let (near, _) = place(&[cube(0.0)]);
        assert!(near.norm() < 0.6 * eye.norm(), "one body is looked at from nearer: {near} {eye}");
    }
}
