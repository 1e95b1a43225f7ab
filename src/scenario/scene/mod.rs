//! A scene as typed: the mirror of the file, key by key. Nothing is checked here but names and types.

mod body;
mod channel_checks;
mod checks;
mod general_loads;
mod loads;
mod motion_checks;
mod points;
mod scenario;
mod solids;

pub use body::{BodySpec, MeshSpec, ParticleSpec, PivotSpec};
pub use channel_checks::{ConservedSpec, Extremum, ExtremumSpec, PeriodSpec, RateSpec};
pub use checks::{Checks, DriftSpec, FlipPeriodSpec, Frame, PrecessionRateSpec, ValueSpec};
pub use general_loads::{
    BDotSpec, ForceFormulaSpec, InnerSphereSpec, QuadraticDampingSpec, QuadraticDragSpec, QuaternionFeedbackSpec,
    RateFeedbackSpec, SpringSpec, TorqueFormulaSpec,
};
pub use loads::{
    AfterTable, BrakeSpec, DampingSpec, ForceSpec, ForceSpecs, GravityGradientSpec, MagneticDipoleSpec, MomentSpec,
    RotorSpec, TableSpec, ThrusterSpec, TorqueSpecs,
};
pub use motion_checks::{MontgomeryPhaseSpec, ObservedSpec, StabilitySpec, Verdict};
pub use points::{ImuSpec, ProbeSpec};
pub use scenario::{Method, Provenance, Scenario, Setting};
pub use solids::{BoxSpec, EllipsoidSpec, RoundSpec, SolidSpecs, SphereSpec, TorusSpec};
