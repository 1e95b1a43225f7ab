use nalgebra::{Rotation3, UnitQuaternion, Vector3};

use super::Surface;
use super::revolution::{ProfilePoint, quarter_circle, whole_circle};
use crate::body::Shape;

/// Corners of a circle: light, and round to the eye. A multiple of eight.
const AROUND: u32 = 32;

impl Surface {
    /// The shape in its own axes, about its own origin.
    ///
    /// Corners lie on the true surface, so that a round body is drawn inside itself by up to half a percent of its
    /// radius.
    #[must_use]
    pub fn of_shape(shape: &Shape) -> Self {
        match *shape {
            Shape::Box { size } => cuboid(size),
            Shape::Cylinder { radius, length } => cylinder(radius, length),
            Shape::Ellipsoid { semi_axes } => ellipsoid(semi_axes, AROUND),
            Shape::Sphere { radius } => ellipsoid([radius; 3], AROUND),
            Shape::Cone { radius, height } => cone(radius, height),
            Shape::Capsule { radius, length } => capsule(radius, length),
            Shape::Torus { major_radius, minor_radius } => {
                let mut surface = Surface::default();
                surface.sweep(&whole_circle(major_radius, minor_radius, AROUND / 4 * 3), AROUND);
                surface
            }
        }
    }
}

/// Six faces of four vertices each.
fn cuboid(size: [f64; 3]) -> Surface {
    let half = Vector3::from(size) * 0.5;
    let mut surface = Surface::default();
    for axis in 0..3 {
        let (right, up) = ((axis + 1) % 3, (axis + 2) % 3);
        for side in [1.0, -1.0] {
            let normal = Vector3::ith(axis, side);
            // Counter-clockwise from outside: seen from the other side, one of the two directions is mirrored.
            let [a, b, c, d] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[along_right, along_up]| {
                let corner = normal + Vector3::ith(right, side * along_right) + Vector3::ith(up, along_up);
                surface.add_vertex(&corner.component_mul(&half), &normal)
            });
            surface.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    surface
}

fn cylinder(radius: f64, length: f64) -> Surface {
    let mut surface = Surface::default();
    surface.sweep_disc(radius, -0.5 * length, -1.0, AROUND);
    let side = [-0.5, 0.5].map(|end| ProfilePoint::new([radius, end * length], [1.0, 0.0]));
    surface.sweep(&side, AROUND);
    surface.sweep_disc(radius, 0.5 * length, 1.0, AROUND);
    surface
}

fn cone(radius: f64, height: f64) -> Surface {
    let mut surface = Surface::default();
    surface.sweep_disc(radius, 0.0, -1.0, AROUND);
    let slant = libm::hypot(radius, height);
    let normal = [height / slant, radius / slant];
    let side = [[radius, 0.0], [0.0, height]].map(|point| ProfilePoint::new(point, normal));
    surface.sweep(&side, AROUND);
    surface
}

fn capsule(radius: f64, length: f64) -> Surface {
    let mut profile = quarter_circle(radius, -0.5 * length, -1.0, AROUND / 4);
    profile.extend(quarter_circle(radius, 0.5 * length, 1.0, AROUND / 4));
    let mut surface = Surface::default();
    surface.sweep(&profile, AROUND);
    surface
}

/// A unit sphere, stretched: normals stretch by the inverse.
pub(super) fn ellipsoid(semi_axes: [f64; 3], around: u32) -> Surface {
    let mut profile = quarter_circle(1.0, 0.0, -1.0, around / 4);
    profile.pop();
    profile.extend(quarter_circle(1.0, 0.0, 1.0, around / 4));
    let mut surface = Surface::default();
    surface.sweep(&profile, around);
    let axes = Vector3::from(semi_axes);
    let sphere = std::mem::take(&mut surface.vertices);
    surface.normals.clear();
    for vertex in sphere {
        let vertex = Vector3::from(vertex.map(f64::from));
        surface.add_vertex(&vertex.component_mul(&axes), &vertex.component_div(&axes).normalize());
    }
    surface
}

/// The surface turned, then moved.
pub(super) fn placed(surface: &Surface, rotation: &UnitQuaternion<f64>, position: &Vector3<f64>) -> Surface {
    let rotation: Rotation3<f64> = rotation.to_rotation_matrix();
    let mut placed = Surface { triangles: surface.triangles.clone(), ..Surface::default() };
    for (vertex, normal) in surface.vertices.iter().zip(&surface.normals) {
        let [vertex, normal] = [vertex, normal].map(|vector| rotation * Vector3::from(vector.map(f64::from)));
        placed.add_vertex(&(vertex + position), &normal);
    }
    placed
}
