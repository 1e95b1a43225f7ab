//! Is a recording true? What a file of any program says of a rotation, held against physics: [`verify()`].
//!
//! Nothing is assumed of ω's frame: it is found. Errors are measured from sample to sample against exact motion, and
//! explained by what engines are known to do.

mod candidates;
mod cause;
mod clock;
mod distance;
mod hypotheses;
mod inertia;
mod interpolation;
mod judge;
mod kinematics;
mod laws;
mod length;
mod model;
mod montgomery;
mod pushed;
mod reading;
mod rotation;
mod series;
mod subject;
mod templates;
mod unexplained;
mod update;
mod verification;
#[expect(clippy::module_inception, reason = "the function of this name is what the module is for")]
mod verify;

pub use candidates::Candidates;
pub use cause::{Cause, Finding};
pub use clock::Clock;
pub use distance::Distance;
pub use inertia::InertiaFit;
pub use kinematics::{Estimate, Kinematics};
pub use laws::Laws;
pub use length::Length;
pub use montgomery::Montgomery;
pub use reading::{Reading, axes_name};
pub use update::{Rate, Rotation, Update};
pub use verification::{Verdict, Verification};
pub use verify::{DEFAULT_TOLERANCE_RAD, FEWEST_SAMPLES, VerifyError, verify};
