use nalgebra::Vector3;

use super::{crossing, drift, precession, value};
use crate::propagation::PropagationError;
use crate::scenario::{Frame, Plan, PlannedBody};
use crate::telemetry::Channel;

/// A check, ready to be measured.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckPlan {
    /// Number of the body it speaks of.
    pub body: usize,
    /// What is measured.
    pub kind: CheckKind,
    /// What must be found, in `unit`.
    pub expected: f64,
    /// How far from it the measured value may be, in `unit`.
    pub tolerance: f64,
    /// Of expected, measured and tolerance.
    pub unit: &'static str,
}

/// What a check measures.
#[derive(Debug, Clone, PartialEq)]
pub enum CheckKind {
    /// Time between every other sign change of ω along the middle principal axis.
    FlipPeriod,
    /// Largest relative change of the energy over the duration.
    Energy {
        /// s.
        duration: f64,
    },
    /// Largest relative departure of L from its law over the duration.
    Momentum {
        /// s.
        duration: f64,
    },
    /// Mean rate at which something goes round an axis.
    PrecessionRate {
        /// World: the body axis round the world's. Body: ω round the body axis.
        frame: Frame,
        /// In body axes, unit.
        axis: Vector3<f64>,
        /// In world axes, unit; `None`: L at t = 0.
        around: Option<Vector3<f64>>,
        /// s.
        duration: f64,
    },
    /// A component of a channel at a time.
    Value {
        /// Which channel.
        channel: Channel,
        /// Which component.
        component: usize,
        /// When, s.
        time: f64,
    },
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
        let Self { name, expected, measured, tolerance, unit, passed } = self;
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        let verdict = if *passed { "passed" } else { "FAILED" };
        format!("{name}: {measured:?}{unit}, expected {expected:?} ± {tolerance:e}: {verdict}")
    }
}

impl CheckPlan {
    /// Until when it looks, s; `None` if that depends on what it finds.
    #[must_use]
    pub const fn time(&self) -> Option<f64> {
        match self.kind {
            CheckKind::FlipPeriod => None,
            CheckKind::Energy { duration }
            | CheckKind::Momentum { duration }
            | CheckKind::PrecessionRate { duration, .. } => Some(duration),
            CheckKind::Value { time, .. } => Some(time),
        }
    }

    fn measure(&self, bodies: &[PlannedBody]) -> Result<CheckOutcome, PropagationError> {
        let body = &bodies[self.body];
        let measured = match &self.kind {
            CheckKind::FlipPeriod => crossing::flip_period(body, self.expected)?,
            CheckKind::Energy { duration } => drift::largest(body, Channel::EnergyDrift, *duration)?,
            CheckKind::Momentum { duration } => drift::largest(body, Channel::MomentumDrift, *duration)?,
            CheckKind::PrecessionRate { frame: Frame::World, axis, around, duration } => {
                precession::in_world(body, axis, around.as_ref(), *duration, self.expected)?
            }
            CheckKind::PrecessionRate { frame: Frame::Body, axis, duration, .. } => {
                precession::in_body(body, axis, *duration, self.expected)?
            }
            CheckKind::Value { channel, component, time } => value::at(body, *channel, *component, *time)?,
        };
        Ok(CheckOutcome {
            name: self.name(bodies),
            expected: self.expected,
            measured,
            tolerance: self.tolerance,
            unit: self.unit,
            passed: (measured - self.expected).abs() <= self.tolerance,
        })
    }

    /// What is measured, of which of several bodies.
    #[must_use]
    pub fn name(&self, bodies: &[PlannedBody]) -> String {
        let what = match &self.kind {
            CheckKind::FlipPeriod => "flip period".to_owned(),
            CheckKind::Energy { .. } => "energy drift".to_owned(),
            CheckKind::Momentum { .. } => "momentum drift".to_owned(),
            CheckKind::PrecessionRate { frame: Frame::World, .. } => "precession rate".to_owned(),
            CheckKind::PrecessionRate { frame: Frame::Body, .. } => "precession rate in the body".to_owned(),
            CheckKind::Value { channel, component, time } => {
                let component = channel.row().components[*component];
                let space = if component.is_empty() { "" } else { " " };
                format!("{}{space}{component} at {time} s", channel.row().name)
            }
        };
        if bodies.len() == 1 { what } else { format!("{}: {what}", bodies[self.body].name) }
    }
}
