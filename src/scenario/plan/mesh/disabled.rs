use std::path::Path;

use crate::body::{MassProperties, TriangleMesh};
use crate::scenario::{Key, MeshSpec, Refusal};

/// Refuses: the readers are left out.
pub fn plan(key: &Key, _spec: &MeshSpec, _folder: &Path) -> Result<(TriangleMesh, MassProperties), Refusal> {
    Err(key.field("file").refuse("this build reads no mesh files (cargo feature `serde`)"))
}
