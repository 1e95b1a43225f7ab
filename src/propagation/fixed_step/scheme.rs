use crate::propagation::PropagationError;
use crate::propagation::equations::{Equations, Values};

/// One step of a method, within a span in which the same loads act.
pub(in crate::propagation) trait Scheme: Send {
    /// The values at `time` + `step`, s, from those at `time`.
    fn step(
        &mut self,
        equations: &mut Equations,
        time: f64,
        step: f64,
        values: &Values,
    ) -> Result<Values, PropagationError>;
}
