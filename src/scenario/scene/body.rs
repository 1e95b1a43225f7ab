use std::path::{Path, PathBuf};

#[cfg(feature = "schema")]
use schemars::JsonSchema;
#[cfg(feature = "serde")]
use serde::Deserialize;

use super::{ForceSpecs, ImuSpec, ProbeSpec, RotorSpec, SolidSpecs, TorqueSpecs};
#[cfg(feature = "schema")]
use crate::scenario::schema::structure;

/// One body: what it is, how it starts, what acts on it.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
#[cfg_attr(feature = "schema", derive(JsonSchema), schemars(transform = structure::body))]
pub struct BodySpec {
    /// Names its topics and entities: at most 64 letters, digits, `_` and `-`; left out: `body`, of a body that is alone.
    #[cfg_attr(feature = "schema", schemars(pattern(r"^[A-Za-z0-9_-]{0,64}$")))]
    pub name: String,
    /// Mass, kg, of a body given by its moments or tensor; gravity and forces need it; left out: not known.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub mass_kg: Option<f64>,
    /// Moments of inertia about body axes that are principal axes, kg m²: none above the sum of the others; left out: the
    /// inertia has another source.
    #[cfg_attr(feature = "schema", schemars(transform = structure::each_positive))]
    pub principal_moments_kg_m2: Option<[f64; 3]>,
    /// Inertia tensor in body axes, kg m²: symmetric, of a possible body, the element x, y being −∫ x y dm; left out: the
    /// inertia has another source.
    pub inertia_kg_m2: Option<[[f64; 3]; 3]>,
    /// Point masses, not all on one line.
    pub particle: Vec<ParticleSpec>,
    /// Solids, summed: where they overlap their densities add.
    pub solid: SolidSpecs,
    /// A body of uniform density inside a closed surface from a file.
    pub mesh: Option<MeshSpec>,
    /// Centre of mass, from the body's origin, m, of a body given by moments or tensor; left out: the origin.
    pub centre_of_mass_m: Option<[f64; 3]>,
    /// World from body, quaternion w, x, y, z, of length 1 within 1e-12; left out: `[1, 0, 0, 0]`.
    pub attitude: Option<[f64; 4]>,
    /// Angular velocity in body axes, rad/s; left out: zero.
    pub angular_velocity_rad_s: Option<[f64; 3]>,
    /// Angular momentum in body axes, N m s, in place of the angular velocity; left out: that of the angular velocity.
    pub angular_momentum_n_m_s: Option<[f64; 3]>,
    /// Position of the centre of mass (or of the pivot), world axes, m; left out: the origin.
    pub position_m: Option<[f64; 3]>,
    /// Velocity of the centre of mass, world axes, m/s; not with a pivot; left out: zero.
    pub velocity_m_s: Option<[f64; 3]>,
    /// Uniform gravity, world axes, m/s²: pulls at the centre of mass, and needs the mass; left out: zero.
    pub gravity_m_s2: Option<[f64; 3]>,
    /// A point of the body that is held fixed; left out: the body is free.
    pub pivot: Option<PivotSpec>,
    /// Points whose motion is recorded.
    pub probe: Vec<ProbeSpec>,
    /// Gyroscopes with accelerometers, whose readings are recorded.
    pub imu: Vec<ImuSpec>,
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
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct ParticleSpec {
    /// Mass, kg.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub mass_kg: f64,
    /// Position in body axes, from the body's origin, m.
    pub position_m: [f64; 3],
}

/// The fixed point of a body that turns about one.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct PivotSpec {
    /// Position in body axes, from the body's origin, m; left out: the origin.
    pub position_m: [f64; 3],
    /// Whether the moments or the tensor given are about the pivot already, and not about the centre of mass: with
    /// these alone; left out: `false`.
    pub inertia_about_pivot: bool,
}

/// A triangle mesh of uniform density.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct MeshSpec {
    /// `.stl` or `.obj`, relative to the scene's folder: closed, triangles counter-clockwise seen from outside.
    pub file: PathBuf,
    /// Density, kg/m³.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub density_kg_m3: f64,
    /// Metres per unit of the file: 0.001 where it is in mm; left out: `1`.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub metres_per_unit: Option<f64>,
}
