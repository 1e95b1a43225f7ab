use std::collections::HashMap;

use nalgebra::{Matrix3, Vector3};

use super::assembly::{Piece, assemble, compensated_sum};
use super::error::positive;
use super::{BodyError, MassProperties};

/// A body's skin: triangles that share vertices, counter-clockwise seen from outside.
///
/// Vertices are the same where their index is the same. A triangle of no area is allowed (it encloses nothing); one
/// that uses a vertex twice counts for nothing at all.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TriangleMesh {
    /// From the body's origin, body axes, m.
    pub vertices: Vec<Vector3<f64>>,
    /// Three vertex indices each, from 0.
    pub triangles: Vec<[u32; 3]>,
}

impl TriangleMesh {
    /// The mass properties of the enclosed volume at this density in kg/m³, about its centre of mass.
    ///
    /// The integrals of 1, r and r rᵀ are exact for a polyhedron: each triangle adds the tetrahedron that it spans with
    /// one point, signed (`[Mirtich96]` by way of `[BB04]`). That point is the mean of the vertices, and in a second
    /// pass the centre of volume, so that a body far from its origin loses no digits.
    ///
    /// # Errors
    /// If the density is not positive, the mesh not closed ([`Self::check_closed`]), or inside out.
    pub fn mass_properties(&self, density: f64) -> Result<MassProperties, BodyError> {
        positive("density of a mesh", density, "kg/m³")?;
        self.check_closed()?;
        let (volume, offset, _) = self.integrals_from(&self.vertex_mean());
        if !(volume > 0.0 && volume.is_finite()) {
            return Err(BodyError::InsideOut { volume });
        }
        let centre = self.vertex_mean() + offset;
        let (volume, offset, second) = self.integrals_from(&centre);
        if !(volume > 0.0 && volume.is_finite()) {
            return Err(BodyError::InsideOut { volume });
        }
        let about_centre = second - offset * offset.transpose() * volume;
        assemble(&[Piece { mass: density * volume, centre: centre + offset, second_moment: about_centre * density }])
    }

    /// Volume enclosed, m³; negative where the triangles face inwards.
    ///
    /// # Errors
    /// If the mesh is not closed.
    pub fn volume(&self) -> Result<f64, BodyError> {
        self.check_closed()?;
        Ok(self.integrals_from(&self.vertex_mean()).0)
    }

    /// Whether the triangles enclose a volume: each edge is used exactly once each way.
    ///
    /// # Errors
    /// If there is no triangle, a vertex is missing or not finite, or an edge is not used so; the message names the
    /// first.
    pub fn check_closed(&self) -> Result<(), BodyError> {
        if self.triangles.is_empty() {
            return Err(BodyError::Empty("mesh triangles"));
        }
        self.check_vertices()?;
        let mut uses: HashMap<(u32, u32), usize> = HashMap::with_capacity(3 * self.triangles.len());
        for edge in self.edges() {
            *uses.entry(edge).or_default() += 1;
        }
        for (from, to) in self.edges() {
            let count = |edge| uses.get(&edge).copied().unwrap_or(0);
            let (forward, backward) = (count((from, to)), count((to, from)));
            if (forward, backward) != (1, 1) {
                return Err(BodyError::NotClosed { from, to, forward, backward });
            }
        }
        Ok(())
    }

    /// Indices in range, coordinates finite.
    fn check_vertices(&self) -> Result<(), BodyError> {
        let vertices = self.vertices.len();
        for (triangle, corners) in self.triangles.iter().enumerate() {
            for &vertex in corners {
                if vertex as usize >= vertices {
                    return Err(BodyError::VertexMissing { triangle, vertex, vertices });
                }
            }
        }
        self.vertices.iter().try_for_each(|vertex| super::error::finite("mesh vertex", *vertex).map(drop))
    }

    /// Directed edges of all triangles with three different vertices.
    fn edges(&self) -> impl Iterator<Item = (u32, u32)> {
        let whole = |&&[a, b, c]: &&[u32; 3]| a != b && b != c && c != a;
        self.triangles.iter().filter(whole).flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)])
    }

    pub(super) fn corners(&self, triangle: [u32; 3]) -> [Vector3<f64>; 3] {
        triangle.map(|index| self.vertices[index as usize])
    }

    fn vertex_mean(&self) -> Vector3<f64> {
        #[expect(clippy::cast_precision_loss, reason = "any point near the mesh will do")]
        let share = 1.0 / self.vertices.len() as f64;
        self.vertices.iter().map(|vertex| vertex * share).sum()
    }

    /// Volume, mean of r, and integral of r rᵀ, with r from `origin`.
    fn integrals_from(&self, origin: &Vector3<f64>) -> (f64, Vector3<f64>, Matrix3<f64>) {
        let tetrahedra = || {
            self.triangles.iter().map(|&triangle| {
                let [a, b, c] = self.corners(triangle).map(|corner| corner - origin);
                (a.dot(&b.cross(&c)) / 6.0, [a, b, c], a + b + c)
            })
        };
        let volume = compensated_sum(tetrahedra().map(|(volume, ..)| volume));
        let mean =
            [0, 1, 2].map(|axis| compensated_sum(tetrahedra().map(|(part, _, sum)| 0.25 * part * sum[axis])) / volume);
        let second = Matrix3::from_fn(|row, column| {
            // The same order of factors for both halves, so that they agree to the last bit.
            let (row, column) = (row.min(column), row.max(column));
            compensated_sum(tetrahedra().map(|(part, corners, sum)| {
                let squares: f64 = corners.iter().map(|corner| corner[row] * corner[column]).sum();
                0.05 * part * (squares + sum[row] * sum[column])
            }))
        });
        (volume, Vector3::from(mean), second)
    }
}
