//! What was asked ([`Scenario`]), what will be done ([`Plan`]), what is happening ([`Run`]).

mod certificate;
mod check;
mod cost;
mod error;
mod event;
mod faults;
#[cfg(feature = "serde")]
mod file;
mod following;
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
#[cfg(feature = "schema")]
mod schema;
mod watch;
mod watched;

pub use certificate::Certificate;
pub use check::{CheckKind, CheckOutcome, CheckPlan, Observation};
pub use cost::Cost;
pub use error::{Excerpt, Refused, ScenarioError};
pub use event::{Event, EventKind};
pub use following::Following;
pub use grid::Grid;
pub use key::{Key, Refusal, Segment};
pub(crate) use near_miss::nearest;
pub(crate) use plan::{MOST_BODIES, nudged};
pub use planned::{Path, Plan, PlannedBody};
pub use run::{Run, nanoseconds};
pub use scene::{
    AfterTable, BDotSpec, BodySpec, BoxSpec, BrakeSpec, Checks, ConservedSpec, DampingSpec, DriftSpec, EllipsoidSpec,
    Extremum, ExtremumSpec, FlipPeriodSpec, ForceFormulaSpec, ForceSpec, ForceSpecs, Frame, GravityGradientSpec,
    ImuSpec, InnerSphereSpec, MagneticDipoleSpec, MeshSpec, Method, MomentSpec, MontgomeryPhaseSpec, ObservedSpec,
    ParticleSpec, PeriodSpec, PivotSpec, PrecessionRateSpec, ProbeSpec, Provenance, QuadraticDampingSpec,
    QuadraticDragSpec, QuaternionFeedbackSpec, RateFeedbackSpec, RateSpec, RotorSpec, RoundSpec, Scenario, Setting,
    SolidSpecs, SphereSpec, SpringSpec, StabilitySpec, TableSpec, ThrusterSpec, TorqueFormulaSpec, TorqueSpecs,
    TorusSpec, ValueSpec, Verdict,
};
#[cfg(feature = "schema")]
pub use schema::schema;
pub use watched::Watched;
