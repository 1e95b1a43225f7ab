//! What methods are worth: their errors against a reference that says how far it can be trusted itself, and their costs.

mod pareto;
mod reference;
mod search;
mod timing;
mod work_precision;

pub use pareto::pareto_front;
pub use reference::{Reference, attitude_distance, reference_states};
pub use timing::{Clock, Spread, interleaved, wall_clock};
pub use work_precision::{Level, Point, Request, WorkPrecision, work_precision};
