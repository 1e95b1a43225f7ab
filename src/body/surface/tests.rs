use std::collections::HashMap;

use nalgebra::{UnitQuaternion, Vector3};

use super::Surface;
use crate::body::{Particle, ParticleCloud, PrincipalMoments, Shape, Solid, TriangleMesh};

const SHAPES: [Shape; 8] = [
    Shape::Box { size: [1.0, 2.0, 3.0] },
    Shape::Cylinder { radius: 0.5, length: 2.0 },
    Shape::Ellipsoid { semi_axes: [1.0, 0.6, 0.3] },
    Shape::Sphere { radius: 0.7 },
    Shape::Cone { radius: 0.5, height: 1.5 },
    Shape::Capsule { radius: 0.3, length: 1.0 },
    Shape::Torus { major_radius: 1.0, minor_radius: 0.3 },
    Shape::Torus { major_radius: 0.5, minor_radius: 0.5 },
];

/// One vertex for all that are in the same place: the surface as a closed skin.
fn skin(surface: &Surface) -> TriangleMesh {
    let mut mesh = TriangleMesh::default();
    let mut known = HashMap::new();
    for corners in &surface.triangles {
        mesh.triangles.push(corners.map(|index| {
            let vertex = surface.vertices[index as usize];
            *known.entry(vertex.map(|value| (value + 0.0).to_bits())).or_insert_with(|| {
                mesh.vertices.push(Vector3::from(vertex.map(f64::from)));
                u32::try_from(mesh.vertices.len() - 1).unwrap()
            })
        }));
    }
    mesh
}

/// Normals of unit length, and on the same side as their triangle.
fn assert_normals(surface: &Surface) {
    assert_eq!(surface.vertices.len(), surface.normals.len());
    for corners in &surface.triangles {
        let [a, b, c] = corners.map(|index| Vector3::from(surface.vertices[index as usize]));
        let flat = (b - a).cross(&(c - a)).normalize();
        for index in corners {
            let normal = Vector3::from(surface.normals[*index as usize]);
            assert!((normal.norm() - 1.0).abs() < 4.0 * f32::EPSILON);
            assert!(normal.dot(&flat) > 0.9, "normal {normal:?} of a triangle facing {flat:?}");
        }
    }
}

#[test]
fn shapes_are_drawn_closed_and_slightly_inside_themselves() {
    for shape in SHAPES {
        let surface = Surface::of_shape(&shape);
        assert_normals(&surface);
        let drawn = skin(&surface).mass_properties(1.0).unwrap();
        let share = drawn.mass.unwrap() / shape.volume();
        assert!((0.975..=1.0 + 1e-6).contains(&share), "{shape:?} is drawn with {share} of its volume");
        let centre = (drawn.centre_of_mass - shape.centre_of_mass()).norm();
        assert!(centre < 1e-3 * surface.extent(), "{shape:?} is drawn {centre} m off");
        // The formulae, against a body drawn by other means: to the coarseness of the drawing.
        let moments = drawn.moments.vector().component_div(&shape.moments_per_density());
        assert!(moments.iter().all(|share| (0.95..=1.0 + 1e-6).contains(share)), "{shape:?}: {moments:?}");
    }
}

#[test]
fn solids_are_drawn_where_they_are_and_holes_are_not() {
    let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::FRAC_PI_2);
    let cone = Solid::new(Shape::Cone { radius: 0.1, height: 2.0 }, 3.0).unwrap().at(Vector3::x()).turned(turn);
    let hole = Solid { density: -1.0, ..cone };
    let [surface] = Surface::of_solids(&[cone, hole], &Vector3::y()).try_into().unwrap();
    assert_normals(&surface);
    // The apex, from z to −y and by the origin another one down.
    let lowest = surface.vertices.iter().map(|vertex| vertex[1]).fold(f32::INFINITY, f32::min);
    assert!((lowest + 3.0).abs() < 1e-6);
    assert!((surface.extent() - 10.0_f64.sqrt()).abs() < 1e-6);
}

#[test]
fn particles_are_balls_of_volumes_like_their_masses() {
    let particle = |mass, position| Particle { mass, position };
    let cloud = vec![particle(1.0, Vector3::zeros()), particle(8.0, Vector3::x()), particle(1.0, Vector3::x() * 2.0)];
    let surface = Surface::of_particles(&ParticleCloud::new(cloud).unwrap(), &Vector3::x());
    assert_normals(&surface);
    let radii = surface.vertices.iter().map(|vertex| vertex[2]).fold(0.0, f32::max);
    assert!((radii - 0.08).abs() < 1e-6);
    assert!((surface.extent() - 1.04).abs() < 1e-6);
    let alone = ParticleCloud::new(vec![particle(2.0, Vector3::y())]).unwrap();
    assert!((Surface::of_particles(&alone, &Vector3::y()).extent() - 0.08).abs() < 1e-6);
}

#[test]
fn box_of_given_moments_has_them_and_a_plate_can_be_seen() {
    let shape = Shape::Box { size: [1.0, 2.0, 3.0] };
    let moments = PrincipalMoments::new((shape.moments_per_density() * 7.0).into()).unwrap();
    let size = Vector3::from(Shape::equivalent_size(moments, 7.0 * shape.volume()));
    assert!((size - Vector3::new(1.0, 2.0, 3.0)).norm() < 1e-14);
    let drawn = Surface::equivalent_box(moments, Some(7.0 * shape.volume()));
    assert!((drawn.extent() - 0.5 * 14.0_f64.sqrt()).abs() < 1e-6);
    let plate = Surface::equivalent_box(PrincipalMoments::new([1.0, 1.0, 2.0]).unwrap(), None);
    let thickness = plate.vertices.iter().map(|vertex| vertex[2]).fold(0.0, f32::max) * 2.0;
    assert!((f64::from(thickness) - 0.02 * 12.0_f64.sqrt()).abs() < 1e-6);
}

#[test]
fn meshes_are_drawn_flat_without_their_slivers() {
    let vertices = vec![Vector3::zeros(), Vector3::x(), Vector3::y(), Vector3::x() * 2.0];
    let mesh = TriangleMesh { vertices, triangles: vec![[0, 1, 2], [0, 1, 3], [0, 1, 9]] };
    let surface = Surface::of_mesh(&mesh, &Vector3::zeros());
    assert_eq!((surface.triangles.len(), surface.normals[0]), (1, [0.0, 0.0, 1.0]));
}
