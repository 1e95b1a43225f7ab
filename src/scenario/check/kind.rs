use nalgebra::Vector3;

use super::CheckPlan;
use crate::scenario::{Extremum, Frame, PlannedBody, Verdict};
use crate::telemetry::Channel;

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
    /// Time between upward crossings of a level.
    Period {
        /// Which channel.
        channel: Channel,
        /// Which component.
        component: usize,
        /// In the channel's unit.
        level: f64,
        /// Over how many periods the mean is taken.
        cycles: u16,
    },
    /// Mean rate of an angle that comes round.
    Rate {
        /// Which channel.
        channel: Channel,
        /// Which component.
        component: usize,
        /// s.
        duration: f64,
    },
    /// Least or greatest value in a span of time.
    Extremum {
        /// Which channel.
        channel: Channel,
        /// Which component.
        component: usize,
        /// Which of the two.
        extremum: Extremum,
        /// s.
        from: f64,
        /// s.
        to: f64,
    },
    /// Largest change, relative to the largest magnitude.
    Conserved {
        /// Which channel.
        channel: Channel,
        /// Which component.
        component: usize,
        /// s.
        duration: f64,
    },
    /// Largest angle between a body axis and a direction.
    Stability {
        /// In body axes, unit.
        axis: Vector3<f64>,
        /// In world axes, unit; `None`: where the axis points at t = 0.
        near: Option<Vector3<f64>>,
        /// s.
        duration: f64,
        /// What must be found.
        verdict: Verdict,
        /// rad.
        angle: f64,
    },
    /// Angle turned about L in a period of ω in the body.
    MontgomeryPhase {
        /// Roughly that period, s.
        period: f64,
    },
}

impl CheckPlan {
    /// Until when it looks, s; `None` if that depends on what it finds.
    #[must_use]
    pub const fn time(&self) -> Option<f64> {
        match self.kind {
            CheckKind::FlipPeriod | CheckKind::Period { .. } | CheckKind::MontgomeryPhase { .. } => None,
            CheckKind::Energy { duration }
            | CheckKind::Momentum { duration }
            | CheckKind::PrecessionRate { duration, .. }
            | CheckKind::Rate { duration, .. }
            | CheckKind::Conserved { duration, .. }
            | CheckKind::Stability { duration, .. } => Some(duration),
            CheckKind::Value { time, .. } | CheckKind::Extremum { to: time, .. } => Some(time),
        }
    }

    /// What is measured, of which of several bodies or of which point.
    #[must_use]
    pub fn name(&self, bodies: &[PlannedBody]) -> String {
        let what = match &self.kind {
            CheckKind::FlipPeriod => "flip period".to_owned(),
            CheckKind::Energy { .. } => "energy drift".to_owned(),
            CheckKind::Momentum { .. } => "momentum drift".to_owned(),
            CheckKind::PrecessionRate { frame: Frame::World, .. } => "precession rate".to_owned(),
            CheckKind::PrecessionRate { frame: Frame::Body, .. } => "precession rate in the body".to_owned(),
            CheckKind::Value { channel, component, time } => format!("{} at {time} s", of(*channel, *component)),
            CheckKind::Period { channel, component, .. } => format!("period of {}", of(*channel, *component)),
            CheckKind::Rate { channel, component, .. } => format!("mean rate of {}", of(*channel, *component)),
            CheckKind::Extremum { channel, component, extremum: Extremum::Least, .. } => {
                format!("least {}", of(*channel, *component))
            }
            CheckKind::Extremum { channel, component, .. } => format!("greatest {}", of(*channel, *component)),
            CheckKind::Conserved { channel, component, .. } => format!("drift of {}", of(*channel, *component)),
            CheckKind::Stability { verdict: Verdict::Stays, angle, .. } => format!("stays within {angle} rad"),
            CheckKind::Stability { angle, .. } => format!("leaves {angle} rad"),
            CheckKind::MontgomeryPhase { .. } => "Montgomery phase per period".to_owned(),
        };
        let is_told = bodies.len() > 1 || self.point.is_some();
        if is_told { format!("{}: {what}", self.watched(bodies).name()) } else { what }
    }
}

/// A component as words call it.
fn of(channel: Channel, component: usize) -> String {
    let (name, component) = (channel.row().name, channel.row().components[component]);
    if component.is_empty() { name.to_owned() } else { format!("{name} {component}") }
}
