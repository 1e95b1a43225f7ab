use super::{CheckKind, crossing, drift, extremum, montgomery, period, precession, rate, stability, value};
use crate::propagation::PropagationError;
use crate::scenario::{Frame, Plan, PlannedBody, Watched};
use crate::telemetry::Channel;

/// A check, ready to be measured.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckPlan {
    /// Number of the body it speaks of.
    pub body: usize,
    /// Number of the point of that body, if it speaks of one.
    pub point: Option<usize>,
    /// What is measured.
    pub kind: CheckKind,
    /// What must be found, in `unit`.
    pub expected: f64,
    /// How far from it the measured value may be, in `unit`.
    pub tolerance: f64,
    /// Of expected, measured and tolerance.
    pub unit: &'static str,
    /// What the world says, in `unit`.
    pub observed: Option<Observation>,
}

/// What was observed of a real body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observation {
    /// The published value.
    pub published: f64,
    /// Its uncertainty as published.
    pub uncertainty: f64,
    /// How far from it the model may be; `None`: it is told, not judged.
    pub tolerance: Option<f64>,
}

/// A check after the run.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckOutcome {
    /// What was measured, of which body.
    pub name: String,
    /// What must be found.
    pub expected: f64,
    /// What was found; NaN where there was nothing to measure, such as a flip that never came.
    pub measured: f64,
    /// How far apart they may be.
    pub tolerance: f64,
    /// Of all three.
    pub unit: &'static str,
    /// Whether they are near enough.
    pub passed: bool,
    /// What was observed of a real body, in `unit`: where it is judged, `passed` says that too.
    pub observed: Option<Observation>,
}

impl Plan {
    /// Measures every check of the scene.
    ///
    /// # Errors
    /// If the motion cannot be propagated as far as a check needs it.
    pub fn measure_checks(&self) -> Result<Vec<CheckOutcome>, PropagationError> {
        self.checks.iter().map(|check| check.measure(&self.bodies)).collect()
    }
}

impl CheckOutcome {
    /// Name, finding, what was expected, and the verdict.
    #[must_use]
    pub fn in_words(&self) -> String {
        let Self { name, expected, measured, tolerance, unit, passed, observed } = self;
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        let verdict = if *passed { "passed" } else { "FAILED" };
        let observed = observed.map_or_else(String::new, |seen| {
            let Observation { published, uncertainty, .. } = seen;
            format!(", observed {published:?} ± {uncertainty:?} (off by {:.3e})", measured - published)
        });
        format!("{name}: {measured:?}{unit}, expected {expected:?} ± {tolerance:e}{observed}: {verdict}")
    }
}

impl CheckPlan {
    /// What it speaks of.
    pub(super) fn watched<'a>(&self, bodies: &'a [PlannedBody]) -> Watched<'a> {
        let body = &bodies[self.body];
        Watched { body, point: self.point.map(|number| &body.points[number]) }
    }

    fn measure(&self, bodies: &[PlannedBody]) -> Result<CheckOutcome, PropagationError> {
        let body = &bodies[self.body];
        let watched = self.watched(bodies);
        let measured = match &self.kind {
            CheckKind::FlipPeriod => crossing::flip_period(body, self.expected)?,
            CheckKind::Energy { duration } => drift::largest(watched, Channel::EnergyDrift, *duration)?,
            CheckKind::Momentum { duration } => drift::largest(watched, Channel::MomentumDrift, *duration)?,
            CheckKind::PrecessionRate { frame: Frame::World, axis, around, duration } => {
                precession::in_world(body, axis, around.as_ref(), *duration, self.expected)?
            }
            CheckKind::PrecessionRate { frame: Frame::Body, axis, duration, .. } => {
                precession::in_body(body, axis, *duration, self.expected)?
            }
            CheckKind::Value { channel, component, time } => value::at(watched, *channel, *component, *time)?,
            CheckKind::Period { channel, component, level, cycles } => {
                period::mean(watched, (*channel, *component), *level, *cycles, self.expected)?
            }
            CheckKind::Rate { channel, component, duration } => {
                rate::mean(watched, (*channel, *component), *duration, self.expected)?
            }
            CheckKind::Extremum { channel, component, extremum, from, to } => {
                extremum::within(watched, (*channel, *component), *extremum, (*from, *to))?
            }
            CheckKind::Conserved { channel, component, duration } => {
                drift::largest_change(watched, (*channel, *component), *duration)?
            }
            CheckKind::Stability { axis, near, duration, .. } => {
                stability::largest_angle(body, axis, near.as_ref(), *duration)?
            }
            CheckKind::MontgomeryPhase { period } => montgomery::phase(body, *period, self.expected)?,
        };
        let is_observed =
            |seen: &Observation| seen.tolerance.is_none_or(|tolerance| (measured - seen.published).abs() <= tolerance);
        Ok(CheckOutcome {
            name: self.name(bodies),
            expected: self.expected,
            measured,
            tolerance: self.tolerance,
            unit: self.unit,
            passed: (measured - self.expected).abs() <= self.tolerance && self.observed.iter().all(is_observed),
            observed: self.observed,
        })
    }
}
