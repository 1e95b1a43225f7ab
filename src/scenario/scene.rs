//! A scene as typed: the mirror of the file, key by key. Nothing is checked here but names and types.

use std::path::PathBuf;

#[cfg(feature = "serde")]
use serde::Deserialize;

/// What was asked. [`super::Plan::new`] checks it.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
pub struct Scenario {
    /// One line: what this is.
    pub title: String,
    /// What to see in it.
    pub summary: String,
    /// How long, s. May be left out where sample times are listed.
    pub duration_s: Option<f64>,
    /// Time between samples, s.
    pub sample_every_s: Option<f64>,
    /// Sample times, s, in place of a fixed interval: ascending, from 0 on.
    pub sample_times_s: Option<Vec<f64>>,
    /// Names of channels; left out: those that the scene makes interesting.
    pub channels: Option<Vec<String>>,
    /// How to propagate.
    pub method: Method,
    /// Attitude error to aim at, rad, over the whole run; for the methods that choose their steps.
    pub tolerance_rad: Option<f64>,
    /// Step, s, for the methods that do not.
    pub step_s: Option<f64>,
    /// The bodies, each with its own motion.
    pub body: Vec<BodySpec>,
    /// What the motion must show.
    pub check: Checks,
    /// Where the numbers come from.
    pub provenance: Provenance,
    /// The file or scene that messages name; not a key.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub file: String,
    /// Where relative file names start; not a key.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub folder: PathBuf,
    /// The name recordings get; not a key.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub name: String,
    /// The text this was read from, if any; not a key.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub text: String,
}

/// How to propagate.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(rename_all = "snake_case"))]
pub enum Method {
    /// The best there is for each body.
    #[default]
    Auto,
    /// The torque-free closed form.
    ClosedForm,
    /// Taylor series of the equations of motion, with dense output.
    Taylor,
    /// The classical Runge–Kutta method with fixed step.
    Rk4,
    /// Dormand and Prince's Runge–Kutta method of order 8.
    Dop853,
}

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
    /// Torques.
    pub torque: TorqueSpecs,
    /// Forces.
    pub force: ForceSpecs,
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

/// Solids by shape.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
pub struct SolidSpecs {
    /// Cuboids: `size_m`, full edge lengths.
    #[cfg_attr(feature = "serde", serde(rename = "box"))]
    pub cuboid: Vec<BoxSpec>,
    /// Along z: `radius_m`, `length_m`.
    pub cylinder: Vec<RoundSpec>,
    /// `semi_axes_m`.
    pub ellipsoid: Vec<EllipsoidSpec>,
    /// `radius_m`.
    pub sphere: Vec<SphereSpec>,
    /// Base at its origin, apex up z: `radius_m`, `length_m`.
    pub cone: Vec<RoundSpec>,
    /// Along z: `radius_m`, `length_m` of the part between the half spheres.
    pub capsule: Vec<RoundSpec>,
    /// About z: `major_radius_m`, `minor_radius_m`.
    pub torus: Vec<TorusSpec>,
}

macro_rules! solid_spec {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $kind:ty),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, PartialEq)]
        #[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $kind,)+
            /// kg, in place of a density.
            #[cfg_attr(feature = "serde", serde(default))]
            pub mass_kg: Option<f64>,
            /// kg/m³; negative for a hole.
            #[cfg_attr(feature = "serde", serde(default))]
            pub density_kg_m3: Option<f64>,
            /// Of the shape's origin, in body axes, m; left out: the body's origin.
            #[cfg_attr(feature = "serde", serde(default))]
            pub position_m: Option<[f64; 3]>,
            /// Body from shape, quaternion w, x, y, z; left out: shape axes along body axes.
            #[cfg_attr(feature = "serde", serde(default))]
            pub rotation: Option<[f64; 4]>,
        }
    };
}

solid_spec! {
    /// A cuboid.
    BoxSpec {
        /// Full edge lengths along x, y, z, m.
        size_m: [f64; 3],
    }
}
solid_spec! {
    /// A cylinder, cone or capsule along z.
    RoundSpec {
        /// m.
        radius_m: f64,
        /// m.
        length_m: f64,
    }
}
solid_spec! {
    /// An ellipsoid.
    EllipsoidSpec {
        /// Along x, y, z, m.
        semi_axes_m: [f64; 3],
    }
}
solid_spec! {
    /// A sphere.
    SphereSpec {
        /// m.
        radius_m: f64,
    }
}
solid_spec! {
    /// A torus about z.
    TorusSpec {
        /// From the centre to the middle of the tube, m.
        major_radius_m: f64,
        /// Of the tube, m.
        minor_radius_m: f64,
    }
}

macro_rules! windowed {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $kind:ty),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, PartialEq)]
        #[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $kind,)+
            /// First instant at which it acts, s; left out: from the beginning.
            #[cfg_attr(feature = "serde", serde(default))]
            pub start_s: Option<f64>,
            /// First instant at which it no longer acts, s; left out: to the end.
            #[cfg_attr(feature = "serde", serde(default))]
            pub end_s: Option<f64>,
        }
    };
}

/// Torques by kind; any number of each.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
pub struct TorqueSpecs {
    /// Constant in body axes.
    pub constant_body: Vec<MomentSpec>,
    /// Constant in world axes.
    pub constant_world: Vec<MomentSpec>,
    /// τ = −c ω.
    pub linear_damping: Vec<DampingSpec>,
    /// On a circular orbit in the world x-y plane, from (1, 0, 0) at t = 0.
    pub gravity_gradient: Vec<GravityGradientSpec>,
}

windowed! {
    /// A constant moment.
    MomentSpec {
        /// N m.
        moment_n_m: [f64; 3],
    }
}
windowed! {
    /// Damping in proportion to ω.
    DampingSpec {
        /// c, N m s, not negative.
        coefficient_n_m_s: f64,
    }
}
windowed! {
    /// The gravity gradient's torque.
    GravityGradientSpec {
        /// n, rad/s, of the orbit.
        mean_motion_rad_s: f64,
    }
}
windowed! {
    /// A force at a point of the body.
    ForceSpec {
        /// N.
        force_n: [f64; 3],
        /// Where it acts, in body axes, from the body's origin, m.
        point_m: [f64; 3],
    }
}

/// Forces by kind; any number of each.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
pub struct ForceSpecs {
    /// Constant in body axes: a thruster.
    pub constant_body: Vec<ForceSpec>,
    /// Constant in world axes.
    pub constant_world: Vec<ForceSpec>,
}

/// Where a scene's numbers come from.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
pub struct Provenance {
    /// Author, title, place, year.
    pub source: String,
    /// Where to read it.
    pub url: String,
    /// What was taken from it, and how the numbers were checked.
    pub note: String,
}

/// What the motion must show, by kind; any number of each.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
pub struct Checks {
    /// Time from one flip to the next but one: the period of the polhode.
    pub flip_period: Vec<FlipPeriodSpec>,
    /// The energy law, at a thousand times over the duration.
    pub energy: Vec<DriftSpec>,
    /// The momentum law, at a thousand times over the duration.
    pub momentum: Vec<DriftSpec>,
    /// Mean rate at which an axis goes round.
    pub precession_rate: Vec<PrecessionRateSpec>,
    /// A channel's component at a time.
    pub value: Vec<ValueSpec>,
}

/// Period of the flips: of the principal component of ω that changes sign.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
pub struct FlipPeriodSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// s.
    pub expected_s: f64,
    /// s.
    pub tolerance_s: f64,
}

/// A conserved quantity.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
pub struct DriftSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// Largest relative change allowed.
    pub tolerance: f64,
}

/// Mean rate at which the body's axis goes round an axis of the world, or ω goes round an axis of the body.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
pub struct PrecessionRateSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// `world` (the default): the body axis goes round `around`, or round L. `body`: ω goes round the body axis.
    #[cfg_attr(feature = "serde", serde(default))]
    pub frame: Frame,
    /// The body's axis, in body axes.
    pub axis: [f64; 3],
    /// The world's axis, in world axes; left out: L at t = 0.
    #[cfg_attr(feature = "serde", serde(default))]
    pub around: Option<[f64; 3]>,
    /// Over which time the rate is averaged, s; left out: the duration.
    #[cfg_attr(feature = "serde", serde(default))]
    pub over_s: Option<f64>,
    /// rad/s.
    pub expected_rad_s: f64,
    /// rad/s.
    pub tolerance_rad_s: f64,
}

/// Which axes a check speaks of.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(rename_all = "snake_case"))]
pub enum Frame {
    /// Inertial axes.
    #[default]
    World,
    /// Axes fixed in the body.
    Body,
}

/// One component of one channel at one time.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
pub struct ValueSpec {
    /// Which body; left out: the first.
    #[cfg_attr(feature = "serde", serde(default))]
    pub body: Option<String>,
    /// The channel's name.
    pub channel: String,
    /// `w`, `x`, `y`, `z`; left out for a scalar.
    #[cfg_attr(feature = "serde", serde(default))]
    pub component: Option<String>,
    /// s.
    pub time_s: f64,
    /// In the channel's unit.
    pub expected: f64,
    /// In the channel's unit.
    pub tolerance: f64,
}
