use super::{Certificate, CheckOutcome, CheckPlan, Event, Grid, Provenance};
use crate::body::{MassProperties, Surface};
use crate::dynamics::Problem;
use crate::propagation::FixedStepMethod;
use crate::telemetry::{Channel, Point};

/// What will be done: every value checked, in SI units and principal axes, the path of each body chosen.
#[derive(Debug, Clone)]
pub struct Plan {
    /// Name of the scene, and of its recordings.
    pub name: String,
    /// One line: what this is.
    pub title: String,
    /// What to see in it.
    pub summary: String,
    /// The scene as text, overrides applied, as recordings carry it; empty where a program made the scene.
    pub text: String,
    /// All that tells this plan from others, in words: recordings of equal identity hold the same motion.
    pub identity: String,
    /// Where the numbers come from.
    pub provenance: Provenance,
    /// Attitude error that the whole run must keep, rad, if one was asked for.
    pub tolerance_rad: Option<f64>,
    /// When samples are taken.
    pub grid: Grid,
    /// The bodies.
    pub bodies: Vec<PlannedBody>,
    /// What the motion must show.
    pub checks: Vec<CheckPlan>,
    /// What was found of them, in their order; empty until someone measures.
    pub outcomes: Vec<CheckOutcome>,
    /// What happens within the run, in order of time.
    pub events: Vec<Event>,
}

/// One body of a plan.
#[derive(Debug, Clone)]
pub struct PlannedBody {
    /// Its name, fit for topics and entity paths.
    pub name: String,
    /// Mass, moments, principal axes.
    pub properties: MassProperties,
    /// What it looks like: body axes, from its reference point.
    pub surfaces: Vec<Surface>,
    /// What is to be propagated, in principal axes.
    pub problem: Problem,
    /// By which method.
    pub path: Path,
    /// Why by that one.
    pub reason: String,
    /// What is recorded, in the order of [`Channel::ALL`].
    pub channels: Vec<Channel>,
    /// What is recorded beside it, under names of their own.
    pub points: Vec<Point>,
    /// What is not done, and why not.
    pub skipped: Vec<String>,
    /// Whether its reference point moves.
    pub moves: bool,
    /// Whether a point of it is held fixed.
    pub is_pivoted: bool,
    /// What was measured of its error; `None` until someone does.
    pub certificate: Option<Certificate>,
}

/// Which propagator a body takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path {
    /// The torque-free closed form: no steps.
    ClosedForm,
    /// The Lagrange top's closed form: no steps.
    LagrangeTop,
    /// The torque-free closed form under a brake along L: no steps.
    MomentumBrake,
    /// Rotation about one axis under a constant torque along it: no steps.
    AxialTorque,
    /// Taylor series.
    Taylor {
        /// Per step, rad.
        tolerance: f64,
    },
    /// A method with a fixed step.
    FixedStep {
        /// Which.
        method: FixedStepMethod,
        /// The longest step, s.
        step: f64,
    },
    /// Dormand–Prince of order 8.
    Dop853 {
        /// Per step, rad.
        tolerance: f64,
    },
}

impl Path {
    /// As tables show it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::ClosedForm => "closed form",
            Self::LagrangeTop => "closed form of the Lagrange top",
            Self::MomentumBrake => "closed form under a brake",
            Self::AxialTorque => "closed form of an axial torque",
            Self::Taylor { .. } => "Taylor",
            Self::FixedStep { method, .. } => method.information().title,
            Self::Dop853 { .. } => "DOP853",
        }
    }
}
