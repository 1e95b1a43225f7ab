use super::{CheckOutcome, Plan};
use crate::propagation::PropagationError;

/// Something that happens at one instant.
#[derive(Debug, Clone, PartialEq)]
pub struct Event {
    /// When, s.
    pub time_s: f64,
    /// To which body: its number.
    pub body: usize,
    /// What kind of thing.
    pub kind: EventKind,
    /// What, in words.
    pub text: String,
}

/// What kinds of things happen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EventKind {
    /// A load begins or ends.
    Load,
    /// The body turns over.
    Flip,
    /// A check was measured and passed.
    Passed,
    /// A check was measured and failed.
    Failed,
}

impl Plan {
    /// The plan with its checks measured, as [`Self::with_outcomes`] holds what they found.
    ///
    /// # Errors
    /// As [`Self::measure_checks`].
    pub fn checked(self) -> Result<Self, PropagationError> {
        let outcomes = self.measure_checks()?;
        Ok(self.with_outcomes(outcomes))
    }

    /// The plan with what its checks have found, which joins the events at the time that each check looks at.
    ///
    /// `outcomes` are those of [`Plan::measure_checks`], in the order of the checks.
    #[must_use]
    pub fn with_outcomes(mut self, outcomes: Vec<CheckOutcome>) -> Self {
        let end = self.grid.end();
        let found = self.checks.iter().zip(&outcomes).map(|(check, outcome)| Event {
            time_s: check.time().map_or(end, |time| time.min(end)),
            body: check.body,
            kind: if outcome.passed { EventKind::Passed } else { EventKind::Failed },
            text: outcome.in_words(),
        });
        self.events.extend(found);
        self.events.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
        self.outcomes = outcomes;
        self
    }
}
