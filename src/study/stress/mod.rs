//! Every method against the motions that break methods: near separatrices, needles, spheres, extreme units, long spans.
//!
//! [`cases`] lists the motions, [`stress`] runs methods on one of them and says how each ended, against limits that are
//! stated beforehand: [`Verdict`] and [`Truth::limit_rad`].

mod case;
mod cell;
mod forced_cases;
mod free_cases;
mod laws;
mod monodromy;
mod trial;
mod truth;

pub use case::{Case, Depth, cases};
pub use cell::{Cell, Row, Verdict, stress};
pub use laws::Drift;
pub use trial::{Ending, Trial};
pub use truth::Truth;
