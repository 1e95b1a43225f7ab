use std::f64::consts::{PI, TAU};

use nalgebra::Vector3;

use super::{Shape, Solid};
use crate::body::BodyError;

/// Volume, mean height and mean squares of a body of revolution from its discs and rings: weight, height, and the
/// squares of the outer and the inner radius there.
fn stacked(discs: &[(f64, f64, f64, f64)]) -> (f64, f64, Vector3<f64>) {
    let sum = |term: &dyn Fn(f64, f64, f64) -> f64| {
        discs.iter().map(|&(weight, height, outer, inner)| weight * term(height, outer, inner)).sum::<f64>()
    };
    let volume = sum(&|_, outer, inner| PI * (outer - inner));
    let height = sum(&|height, outer, inner| PI * (outer - inner) * height) / volume;
    let along = sum(&|z, outer, inner| PI * (outer - inner) * (z - height) * (z - height)) / volume;
    let across = sum(&|_, outer, inner| 0.25 * PI * (outer * outer - inner * inner)) / volume;
    (volume, height, Vector3::new(across, across, along))
}

/// Gauss's three points from `low` to `high`: exact up to the fifth power of the height.
fn discs(low: f64, high: f64, radius_squared: impl Fn(f64) -> f64) -> Vec<(f64, f64, f64, f64)> {
    let half = 0.5 * (high - low);
    let points = [(5.0 / 9.0, -0.6_f64.sqrt()), (8.0 / 9.0, 0.0), (5.0 / 9.0, 0.6_f64.sqrt())];
    let disc = |(weight, place): (f64, f64)| {
        let height = low + half * (1.0 + place);
        (weight * half, height, radius_squared(height), 0.0)
    };
    points.map(disc).to_vec()
}

#[test]
fn formulae_are_those_of_stacked_discs() {
    let (r, l, ring) = (0.3, 1.1, 0.8);
    let ball = |centre: f64| move |z: f64| r * r - (z - centre) * (z - centre);
    let capsule = [
        discs(-0.5 * l - r, -0.5 * l, ball(-0.5 * l)),
        discs(-0.5 * l, 0.5 * l, |_| r * r),
        discs(0.5 * l, 0.5 * l + r, ball(0.5 * l)),
    ];
    // Heights r sin θ: sums over a whole period are exact, and each height comes twice.
    let torus = (0..32).map(|step| {
        let angle = TAU * (f64::from(step) + 0.5) / 32.0;
        let (height, depth) = (r * libm::sin(angle), r * libm::cos(angle).abs());
        (0.5 * depth * TAU / 32.0, height, (ring + depth) * (ring + depth), (ring - depth) * (ring - depth))
    });
    for (shape, discs, room) in [
        (Shape::Cylinder { radius: r, length: l }, discs(-0.5 * l, 0.5 * l, |_| r * r), 1e-15),
        (Shape::Sphere { radius: r }, discs(-r, r, ball(0.0)), 1e-15),
        (Shape::Ellipsoid { semi_axes: [r; 3] }, discs(-r, r, ball(0.0)), 1e-15),
        (Shape::Cone { radius: r, height: l }, discs(0.0, l, |z| (r * (1.0 - z / l)) * (r * (1.0 - z / l))), 1e-15),
        (Shape::Capsule { radius: r, length: l }, capsule.concat(), 1e-15),
        (Shape::Torus { major_radius: ring, minor_radius: r }, torus.collect(), 1e-15),
    ] {
        let (volume, height, squares) = stacked(&discs);
        assert!((shape.volume() - volume).abs() <= room * volume, "{shape:?}: {} {volume}", shape.volume());
        assert!((shape.centre_of_mass().z - height).abs() <= room, "{shape:?}: {height}");
        let off = (shape.mean_squares() - squares).amax();
        assert!(off <= room * squares.amax(), "{shape:?}: {off:e} of {squares:?}");
    }
}

#[test]
fn lengths_and_densities_that_cannot_be_are_named() {
    let refused = |shape: Shape| Solid::new(shape, 1.0).unwrap_err().to_string();
    let message = refused(Shape::Box { size: [1.0, -2.0, 1.0] });
    assert_eq!(message, "box size[1] = -2 m: it must be positive and finite");
    assert!(refused(Shape::Ellipsoid { semi_axes: [1.0, 1.0, f64::NAN] }).starts_with("ellipsoid semi_axes[2] = NaN"));
    assert!(refused(Shape::Cylinder { radius: 0.0, length: 1.0 }).starts_with("cylinder radius = 0"));
    assert!(refused(Shape::Sphere { radius: f64::INFINITY }).starts_with("sphere radius = inf"));
    assert!(refused(Shape::Cone { radius: 1.0, height: 0.0 }).starts_with("cone height = 0"));
    assert!(refused(Shape::Capsule { radius: 1.0, length: 0.0 }).starts_with("capsule length = 0"));
    assert!(refused(Shape::Torus { major_radius: 1.0, minor_radius: 1.1 }).contains("pass through itself"));
    for density in [0.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(Solid::new(Shape::Sphere { radius: 1.0 }, density), Err(BodyError::Density(_))));
    }
    assert!(Solid::from_mass(Shape::Sphere { radius: 1.0 }, -1.0).is_err());
}
