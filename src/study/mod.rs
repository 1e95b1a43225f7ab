//! How good a run is and what methods are worth: certificates, and errors against costs, measured by references that say
//! how far they can be trusted themselves.

mod certificate;
mod deviation;
mod exact_motion;
mod pareto;
mod reference;
mod search;
mod stress;
mod timing;
mod work_precision;

pub use certificate::{certify, certify_body};
pub use pareto::pareto_front;
pub use reference::{Reference, reference_states};
pub use stress::{Case, Cell, Depth, Drift, Ending, NoTruth, Row, Trial, Truth, Verdict, cases, stress};
pub use timing::{Clock, Spread, interleaved, wall_clock};
pub use work_precision::{Level, Point, Request, WorkPrecision, work_precision};
