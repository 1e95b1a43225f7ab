use std::path::Path;

use crate::body::{MassProperties, TriangleMesh};
use crate::scenario::plan::rules::positive;
use crate::scenario::{Key, MeshSpec, Refusal};

/// The mesh and the mass properties of what it encloses.
pub fn plan(key: &Key, spec: &MeshSpec, folder: &Path) -> Result<(TriangleMesh, MassProperties), Refusal> {
    let scale = positive(&key.field("metres_per_unit"), spec.metres_per_unit.unwrap_or(1.0))?;
    let density = positive(&key.field("density_kg_m3"), spec.density_kg_m3)?;
    let file = key.field("file");
    let mesh = TriangleMesh::read(&folder.join(&spec.file), scale).map_err(|error| file.refuse(error))?;
    mesh.check_closed().map_err(|error| file.refuse(error))?;
    let properties = mesh.mass_properties(density).map_err(|error| file.refuse(error))?;
    Ok((mesh, properties))
}
