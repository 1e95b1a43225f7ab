use super::{Following, Path, Plan, PlannedBody, ScenarioError};
use crate::propagation::{
    AxialTorque, BrakedRotation, Dop853, Effort, FixedStep, FreeRotation, LagrangeTop, PropagationError, Propagator,
    Taylor,
};
use crate::telemetry::Samples;

/// What is happening: the propagators and the buffers, allocated once.
pub struct Run<'plan> {
    plan: &'plan Plan,
    bodies: Following,
    samples: Samples,
    next: u64,
}

impl Plan {
    /// Samples in a batch: large enough that a batch's overhead vanishes, small enough for the cache.
    pub const BATCH: usize = 8192;

    /// Starts at t = 0.
    ///
    /// # Errors
    /// If a path does not cover its body's problem.
    pub fn start(&self) -> Result<Run<'_>, ScenarioError> {
        let samples = Samples { bodies: Following::samples(&self.bodies), ..Samples::default() };
        Ok(Run { plan: self, bodies: Following::new(&self.bodies)?, samples, next: 0 })
    }
}

impl PlannedBody {
    /// The propagator that this body's path names, at t = 0.
    ///
    /// # Errors
    /// If it does not cover the problem.
    pub fn propagator(&self) -> Result<Box<dyn Propagator>, PropagationError> {
        Ok(match self.path {
            Path::ClosedForm => Box::new(FreeRotation::new(&self.problem)?),
            Path::LagrangeTop => Box::new(LagrangeTop::new(&self.problem)?),
            Path::MomentumBrake => Box::new(BrakedRotation::new(&self.problem)?),
            Path::AxialTorque => Box::new(AxialTorque::new(&self.problem)?),
            Path::Taylor { tolerance } => Box::new(Taylor::new(&self.problem, tolerance)?),
            Path::FixedStep { method, step } => Box::new(FixedStep::new(&self.problem, method, step)?),
            Path::Dop853 { tolerance } => Box::new(Dop853::new(&self.problem, tolerance)?),
        })
    }
}

impl Run<'_> {
    /// The next samples, or `None` after the last. They are lent until the next call.
    ///
    /// # Errors
    /// If a state ceases to be finite or a step cannot be made small enough.
    pub fn next_batch(&mut self) -> Result<Option<&Samples>, ScenarioError> {
        self.plan.grid.fill(self.next, Plan::BATCH, &mut self.samples.times_s);
        if self.samples.times_s.is_empty() {
            return Ok(None);
        }
        self.samples.first_index = self.next;
        self.samples.stamps_ns.clear();
        self.samples.stamps_ns.extend(self.samples.times_s.iter().map(|time| nanoseconds(*time)));
        self.bodies.fill(&self.samples.times_s, &mut self.samples.bodies)?;
        self.next += self.samples.times_s.len() as u64;
        Ok(Some(&self.samples))
    }

    /// How much of the run is done, 0 to 1.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "a fraction for people")]
    pub fn fraction(&self) -> f64 {
        self.next as f64 / self.plan.grid.len().max(1) as f64
    }

    /// What the propagation has cost so far, all bodies together.
    #[must_use]
    pub fn effort(&self) -> Effort {
        self.bodies.effort()
    }
}

/// `time` in whole ns. The plan admits only times that fit.
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "the plan bounds sample times by 9e9 s, 9e18 ns")]
pub fn nanoseconds(time_s: f64) -> i64 {
    (time_s * 1e9).round() as i64
}
