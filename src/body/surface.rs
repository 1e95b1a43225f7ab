//! placeholder
/// A drawable triangulation.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Surface {
    /// From the reference point, body axes, m.
    pub vertices: Vec<[f32; 3]>,
    /// Outward, of unit length, one for each vertex.
    pub normals: Vec<[f32; 3]>,
    /// Three vertex indices each, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}
