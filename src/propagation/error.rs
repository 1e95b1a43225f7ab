use thiserror::Error;

/// A propagation that cannot go on.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum PropagationError {
    /// The state is no longer finite.
    #[error("the state is no longer finite after t = {time} s")]
    NotFinite {
        /// Last time at which it was, s.
        time: f64,
    },
    /// The step has shrunk below what time can resolve.
    #[error("at t = {time} s the step would be {step:e} s, too small to advance the time")]
    StepTooSmall {
        /// Where, s.
        time: f64,
        /// The step asked for, s.
        step: f64,
    },
    /// Particles have gone so far apart that no attitude can be told of them.
    #[error("near t = {time} s the particles have lost their shape: no attitude brings their places near them")]
    NoShape {
        /// Where, s.
        time: f64,
    },
    /// The equations of an implicit step have not been solved.
    #[error("at t = {time} s an implicit step of {step:e} s finds no solution: take shorter steps")]
    NoConvergence {
        /// Start of the step, s.
        time: f64,
        /// Its length, s.
        step: f64,
    },
    /// Times must ascend.
    #[error("sample time {time} s comes before {previous} s: times must ascend")]
    NotAscending {
        /// The offending time, s.
        time: f64,
        /// The one before it, s.
        previous: f64,
    },
    /// The method does not cover the problem.
    #[error("{method} cannot propagate this: {rule}")]
    NotCovered {
        /// The method's name.
        method: &'static str,
        /// What it needs.
        rule: &'static str,
    },
}
