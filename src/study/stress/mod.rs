//! Every method against the motions that break methods: near separatrices, needles, spheres, extreme units, long spans.
//!
//! [`cases`] lists the motions, [`stress`] runs methods on one of them and says how each ended, against limits that are
//! stated beforehand: [`Verdict`] and [`Truth::limit_rad`].

mod cases;
mod cell;
mod condition;
mod laws;
mod monodromy;
mod row;
mod settings;
mod trial;
mod truth;
mod verdict;

pub use cases::{Case, Depth, cases};
pub use cell::Cell;
pub use laws::Drift;
pub use row::{NoTruth, Row, stress};
pub use trial::{Ending, Trial};
pub use truth::Truth;
pub use verdict::Verdict;
