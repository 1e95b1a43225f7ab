//! What was asked ([`Scenario`]), what will be done ([`Plan`]), what is happening ([`Run`]).

mod certificate;
mod check;
mod error;
mod event;
#[cfg(feature = "serde")]
mod file;
mod grid;
mod key;
#[cfg(feature = "serde")]
pub mod library;
mod locate;
mod near_miss;
mod plan;
mod planned;
mod run;
mod scene;
mod watch;

pub use certificate::Certificate;
pub use check::{CheckKind, CheckOutcome, CheckPlan};
pub use error::{Excerpt, Refused, ScenarioError};
pub use event::{Event, EventKind};
pub use grid::Grid;
pub use key::{Key, Refusal, Segment};
pub(crate) use near_miss::nearest;
pub(crate) use plan::{MOST_BODIES, nudged};
pub use planned::{Path, Plan, PlannedBody};
pub use run::{Run, nanoseconds};
pub use scene::{
    AfterTable, BDotSpec, BodySpec, BoxSpec, BrakeSpec, Checks, DampingSpec, DriftSpec, EllipsoidSpec, FlipPeriodSpec,
    ForceFormulaSpec, ForceSpec, ForceSpecs, Frame, GravityGradientSpec, InnerSphereSpec, MagneticDipoleSpec, MeshSpec,
    Method, MomentSpec, ParticleSpec, PivotSpec, PrecessionRateSpec, Provenance, QuadraticDampingSpec,
    QuadraticDragSpec, QuaternionFeedbackSpec, RateFeedbackSpec, RotorSpec, RoundSpec, Scenario, Setting, SolidSpecs,
    SphereSpec, SpringSpec, TableSpec, ThrusterSpec, TorqueFormulaSpec, TorqueSpecs, TorusSpec, ValueSpec,
};
