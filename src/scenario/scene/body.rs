use std::path::{Path, PathBuf};

#[cfg(feature = "serde")]
use serde::Deserialize;

use super::{ForceSpecs, RotorSpec, SolidSpecs, TorqueSpecs};

/// One body: what it is, how it starts, what acts on it.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
pub struct BodySpec {
    /// Names its topics and entities: letters, digits, `_` and `-`. One body needs none.
    pub name: String,
    /// Mass, kg, of a body given by its moments or tensor.
    pub mass_kg: Option<f64>,
    /// Moments of inertia about body axes that are principal axes, kg m².
    pub principal_moments_kg_m2: Option<[f64; 3]>,
    /// Inertia tensor in body axes, kg m².
    pub inertia_kg_m2: Option<[[f64; 3]; 3]>,
    /// Point masses.
    pub particle: Vec<ParticleSpec>,
    /// Solids, summed.
    pub solid: SolidSpecs,
    /// A closed surface from a file.
    pub mesh: Option<MeshSpec>,
    /// From the body's origin, m, of a body given by moments or tensor; left out: the origin.
    pub centre_of_mass_m: Option<[f64; 3]>,
    /// World from body, quaternion w, x, y, z; left out: body axes along world axes.
    pub attitude: Option<[f64; 4]>,
    /// In body axes, rad/s.
    pub angular_velocity_rad_s: Option<[f64; 3]>,
    /// In body axes, N m s, in place of the angular velocity.
    pub angular_momentum_n_m_s: Option<[f64; 3]>,
    /// Of the centre of mass (or of the pivot), world axes, m.
    pub position_m: Option<[f64; 3]>,
    /// Of the centre of mass, world axes, m/s.
    pub velocity_m_s: Option<[f64; 3]>,
    /// Uniform gravity, world axes, m/s²: on the centre of mass, and about the pivot if there is one.
    pub gravity_m_s2: Option<[f64; 3]>,
    /// A point of the body that is held fixed.
    pub pivot: Option<PivotSpec>,
    /// Wheels that spin inside; the inertia given includes them.
    pub rotor: Vec<RotorSpec>,
    /// Torques.
    pub torque: TorqueSpecs,
    /// Forces.
    pub force: ForceSpecs,
}

impl BodySpec {
    /// The files that it names, and what they are.
    pub fn files(&self) -> impl Iterator<Item = (&'static str, &Path)> {
        let meshes = self.mesh.iter().map(|mesh| ("mesh", mesh.file.as_path()));
        let tables = self.torque.table.iter().chain(&self.force.table);
        let tables = tables.filter_map(|table| Some(("table", table.file.as_deref()?)));
        meshes.chain(tables)
    }
}

/// One point mass.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
pub struct ParticleSpec {
    /// kg, positive.
    pub mass_kg: f64,
    /// In body axes, m.
    pub position_m: [f64; 3],
}

/// The fixed point of a body that turns about one.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
pub struct PivotSpec {
    /// In body axes, m, from the body's origin.
    pub position_m: [f64; 3],
    /// Whether the moments or the tensor given are about the pivot already.
    pub inertia_about_pivot: bool,
}

/// A triangle mesh of uniform density.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
pub struct MeshSpec {
    /// `.stl` or `.obj`, relative to the scene.
    pub file: PathBuf,
    /// kg/m³, positive.
    pub density_kg_m3: f64,
    /// Metres per unit of the file; left out: 1.
    pub metres_per_unit: Option<f64>,
}
