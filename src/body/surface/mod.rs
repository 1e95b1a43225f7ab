//! What a viewer draws of a body. Nothing here enters a motion: single precision, and round things have corners.

mod draw;
mod primitives;
mod revolution;
#[cfg(test)]
mod tests;

use nalgebra::Vector3;

/// A drawable triangulation with normals: smooth where the body is round, with a vertex for each side at an edge.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Surface {
    /// From the reference point, body axes, m.
    pub vertices: Vec<[f32; 3]>,
    /// Outward, of unit length, one for each vertex.
    pub normals: Vec<[f32; 3]>,
    /// Three vertex indices each, from 0, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

impl Surface {
    /// Distance of the farthest vertex from the reference point, m; zero of nothing.
    #[must_use]
    pub fn extent(&self) -> f64 {
        let distance = |vertex: &[f32; 3]| Vector3::from(vertex.map(f64::from)).norm();
        self.vertices.iter().map(distance).fold(0.0, f64::max)
    }

    /// Adds a vertex and answers its index.
    fn add_vertex(&mut self, position: &Vector3<f64>, normal: &Vector3<f64>) -> u32 {
        let index = u32::try_from(self.vertices.len()).unwrap_or(u32::MAX);
        self.vertices.push(single(position));
        self.normals.push(single(normal));
        index
    }

    /// Adds another surface, moved by `offset`.
    fn add(&mut self, other: &Self, offset: &Vector3<f64>) {
        let first = u32::try_from(self.vertices.len()).unwrap_or(u32::MAX);
        let moved = |vertex: &[f32; 3]| single(&(Vector3::from(vertex.map(f64::from)) + offset));
        self.vertices.extend(other.vertices.iter().map(moved));
        self.normals.extend(&other.normals);
        self.triangles.extend(other.triangles.iter().map(|corners| corners.map(|index| index + first)));
    }
}

#[expect(clippy::cast_possible_truncation, reason = "viewers draw in single precision")]
fn single(vector: &Vector3<f64>) -> [f32; 3] {
    [vector.x as f32, vector.y as f32, vector.z as f32]
}
