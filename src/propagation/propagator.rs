use super::{PropagationError, States};

/// Motion as a function of time.
pub trait Propagator: Send {
    /// Fills `states` with the motion at `times`, s: ascending, and not before those of the last call.
    ///
    /// # Errors
    /// If a time goes back, the state ceases to be finite, or a step cannot be made small enough.
    fn fill(&mut self, times: &[f64], states: &mut States) -> Result<(), PropagationError>;

    /// Evaluations, steps, rejections and the shortest step so far.
    fn effort(&self) -> Effort;
}

/// What a propagation has cost so far. A closed form costs one evaluation per sample and no step.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Effort {
    /// Of the right-hand side, of a series of it, or of a closed form.
    pub evaluations: u64,
    /// Accepted steps.
    pub steps: u64,
    /// Steps tried and thrown away.
    pub rejections: u64,
    /// The shortest of the accepted steps, s; those that end where a load begins or ends are among them.
    pub shortest_step_s: Option<f64>,
}

impl Effort {
    /// Counts a step of `length`, s.
    pub(super) fn include_step(&mut self, length: f64) {
        self.steps += 1;
        self.shortest_step_s = shorter(self.shortest_step_s, Some(length));
    }
}

/// The shorter of two steps, as far as there are any.
fn shorter(one: Option<f64>, other: Option<f64>) -> Option<f64> {
    one.into_iter().chain(other).reduce(f64::min)
}

impl std::ops::Add for Effort {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            evaluations: self.evaluations + other.evaluations,
            steps: self.steps + other.steps,
            rejections: self.rejections + other.rejections,
            shortest_step_s: shorter(self.shortest_step_s, other.shortest_step_s),
        }
    }
}
