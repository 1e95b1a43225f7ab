use nalgebra::Vector3;

use super::Surface;
use super::primitives::{ellipsoid, placed};
use crate::body::{ParticleCloud, PrincipalMoments, Shape, Solid, TriangleMesh};

/// Corners of a particle's circle; there may be many particles.
const AROUND_PARTICLE: u32 = 16;

/// Radius of the heaviest particle, as a part of the cloud's extent.
const PARTICLE_RADIUS: f64 = 0.08;

/// Least thickness of an equivalent box, as a part of its longest edge: a plate would be invisible from its side.
const LEAST_THICKNESS: f64 = 0.02;

impl Surface {
    /// One surface for each solid that is not a hole, in body axes from `origin` (itself from the body's origin, m).
    ///
    /// Holes are left out: what they are cut from is drawn whole.
    #[must_use]
    pub fn of_solids(solids: &[Solid], origin: &Vector3<f64>) -> Vec<Self> {
        let surface =
            |solid: &Solid| placed(&Self::of_shape(&solid.shape), &solid.body_from_shape, &(solid.position - origin));
        solids.iter().filter(|solid| !solid.is_hole()).map(surface).collect()
    }

    /// The triangles of a mesh, each flat, in body axes from `origin` (m). Triangles without area or with a missing
    /// vertex are left out.
    #[must_use]
    pub fn of_mesh(mesh: &TriangleMesh, origin: &Vector3<f64>) -> Self {
        let mut surface = Self::default();
        for triangle in &mesh.triangles {
            let [Some(a), Some(b), Some(c)] = triangle.map(|index| mesh.vertices.get(index as usize)) else { continue };
            let Some(normal) = (b - a).cross(&(c - a)).try_normalize(0.0) else { continue };
            let corners = [a, b, c].map(|corner| surface.add_vertex(&(corner - origin), &normal));
            surface.triangles.push(corners);
        }
        surface
    }

    /// A small ball for each particle, in body axes from `origin` (m); equal densities, the heaviest with a radius of
    /// 8 % of the distance of the farthest particle from the centre of mass (of 1 m, if there is but one place).
    #[must_use]
    pub fn of_particles(cloud: &ParticleCloud, origin: &Vector3<f64>) -> Self {
        let centre = cloud.centre_of_mass();
        let particles = cloud.particles();
        let spread = particles.iter().map(|particle| (particle.position - centre).norm()).fold(0.0, f64::max);
        let heaviest = particles.iter().map(|particle| particle.mass).fold(0.0, f64::max);
        let largest = PARTICLE_RADIUS * if spread > 0.0 { spread } else { 1.0 };
        let mut surface = Self::default();
        for particle in particles {
            let radius = largest * libm::cbrt(particle.mass / heaviest);
            surface.add(&ellipsoid([radius; 3], AROUND_PARTICLE), &(particle.position - origin));
        }
        surface
    }

    /// The box of [`Shape::equivalent_size`], centred, edges along the principal axes. A picture only: it is drawn at
    /// least 2 % as thick as it is long, and of 1 kg where the mass is unknown.
    #[must_use]
    pub fn equivalent_box(moments: PrincipalMoments, mass: Option<f64>) -> Self {
        let size = Shape::equivalent_size(moments, mass.unwrap_or(1.0));
        let least = LEAST_THICKNESS * size.into_iter().fold(0.0, f64::max);
        Self::of_shape(&Shape::Box { size: size.map(|edge| edge.max(least)) })
    }
}
