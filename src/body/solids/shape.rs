use std::f64::consts::PI;

use nalgebra::Vector3;

use crate::body::error::positive;
use crate::body::{BodyError, PrincipalMoments};

/// A simple solid in its own axes; lengths in m. Its origin is its centre, but of the cone, where it is its base's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// A cuboid, edges along the axes.
    Box {
        /// Full lengths along x, y, z, m.
        size: [f64; 3],
    },
    /// A circular cylinder around z.
    Cylinder {
        /// m.
        radius: f64,
        /// Full length along z, m.
        length: f64,
    },
    /// x²/a² + y²/b² + z²/c² ≤ 1.
    Ellipsoid {
        /// a, b, c: half lengths along x, y, z, m.
        semi_axes: [f64; 3],
    },
    /// A ball.
    Sphere {
        /// m.
        radius: f64,
    },
    /// A circular cone around z: base at z = 0 with the origin in its centre, apex at z = `height`.
    Cone {
        /// Of the base, m.
        radius: f64,
        /// Along z, m.
        height: f64,
    },
    /// A cylinder around z with a half ball on each end.
    Capsule {
        /// Of the cylinder and of the half balls, m.
        radius: f64,
        /// Of the cylinder alone, m: the whole is two radii longer.
        length: f64,
    },
    /// A ring around z.
    Torus {
        /// From the centre of the ring to the centre of the tube, m.
        major_radius: f64,
        /// Of the tube, m; at most the major radius.
        minor_radius: f64,
    },
}

impl Shape {
    /// Whether such a solid exists.
    ///
    /// # Errors
    /// If a length is not positive and finite (the message names it), or a torus would pass through itself.
    pub fn check(&self) -> Result<(), BodyError> {
        let each = |lengths: [(&'static str, f64); 3]| {
            lengths.into_iter().try_for_each(|(name, length)| positive(name, length, "m").map(drop))
        };
        let both = |first: (&'static str, f64), second: (&'static str, f64)| each([first, second, second]);
        match *self {
            Self::Box { size: [x, y, z] } => each([("box size[0]", x), ("box size[1]", y), ("box size[2]", z)]),
            Self::Cylinder { radius, length } => both(("cylinder radius", radius), ("cylinder length", length)),
            Self::Ellipsoid { semi_axes: [a, b, c] } => {
                each([("ellipsoid semi_axes[0]", a), ("ellipsoid semi_axes[1]", b), ("ellipsoid semi_axes[2]", c)])
            }
            Self::Sphere { radius } => positive("sphere radius", radius, "m").map(drop),
            Self::Cone { radius, height } => both(("cone radius", radius), ("cone height", height)),
            Self::Capsule { radius, length } => both(("capsule radius", radius), ("capsule length", length)),
            Self::Torus { major_radius, minor_radius } => {
                both(("torus major_radius", major_radius), ("torus minor_radius", minor_radius))?;
                if minor_radius > major_radius {
                    return Err(BodyError::SpindleTorus { major_radius, minor_radius });
                }
                Ok(())
            }
        }
    }

    /// Volume, m³.
    #[must_use]
    pub fn volume(&self) -> f64 {
        match *self {
            Self::Box { size: [x, y, z] } => x * y * z,
            Self::Cylinder { radius, length } => PI * radius * radius * length,
            Self::Ellipsoid { semi_axes: [a, b, c] } => 4.0 / 3.0 * PI * a * b * c,
            Self::Sphere { radius } => 4.0 / 3.0 * PI * radius * radius * radius,
            Self::Cone { radius, height } => PI * radius * radius * height / 3.0,
            Self::Capsule { radius, length } => PI * radius * radius * (length + 4.0 / 3.0 * radius),
            Self::Torus { major_radius, minor_radius } => 2.0 * PI * PI * major_radius * minor_radius * minor_radius,
        }
    }

    /// Centre of mass at uniform density, from the shape's origin, in its axes, m.
    #[must_use]
    pub fn centre_of_mass(&self) -> Vector3<f64> {
        match *self {
            Self::Cone { height, .. } => Vector3::new(0.0, 0.0, 0.25 * height),
            _ => Vector3::zeros(),
        }
    }

    /// Mean of x², y², z² over the volume about the centre of mass, in the shape's axes, m². The products vanish.
    #[must_use]
    pub fn mean_squares(&self) -> Vector3<f64> {
        match *self {
            Self::Box { size } => Vector3::from(size.map(|edge| edge * edge / 12.0)),
            Self::Cylinder { radius, length } => round(0.25 * radius * radius, length * length / 12.0),
            Self::Ellipsoid { semi_axes } => Vector3::from(semi_axes.map(|half| 0.2 * half * half)),
            Self::Sphere { radius } => Vector3::repeat(0.2 * radius * radius),
            Self::Cone { radius, height } => round(0.15 * radius * radius, 0.0375 * height * height),
            Self::Capsule { radius, length } => {
                // Volumes of the cylinder and of the two half balls over π r².
                let (cylinder, balls) = (length, 4.0 / 3.0 * radius);
                let across = (0.25 * cylinder + 0.2 * balls) * radius * radius;
                // A half ball of centroid 3r/8 from its plane, which lies length/2 from the centre.
                let ball_along = 0.25 * length * length + 0.375 * length * radius + 0.2 * radius * radius;
                let along = cylinder * length * length / 12.0 + balls * ball_along;
                round(across / (cylinder + balls), along / (cylinder + balls))
            }
            Self::Torus { major_radius, minor_radius } => {
                let tube = minor_radius * minor_radius;
                round(0.5 * major_radius * major_radius + 0.375 * tube, 0.25 * tube)
            }
        }
    }

    /// Edges in m of the uniform box of this mass in kg that has these principal moments: a² = 6 (I₂ + I₃ − I₁) / M.
    ///
    /// A flat body's box has an edge of zero, to rounding.
    #[must_use]
    pub fn equivalent_size(moments: PrincipalMoments, mass: f64) -> [f64; 3] {
        let [a, b, c] = moments.vector().into();
        // Rounding may have left a lamina's difference below zero.
        [b + c - a, c + a - b, a + b - c].map(|excess| (6.0 * excess.max(0.0) / mass).sqrt())
    }

    /// The moments of inertia about the centre of mass at density 1 kg/m³, in the shape's axes, m⁵.
    #[must_use]
    pub fn moments_per_density(&self) -> Vector3<f64> {
        let [xx, yy, zz] = self.mean_squares().into();
        Vector3::new(yy + zz, zz + xx, xx + yy) * self.volume()
    }
}

/// Mean squares of a body of revolution around z.
fn round(across: f64, along: f64) -> Vector3<f64> {
    Vector3::new(across, across, along)
}
