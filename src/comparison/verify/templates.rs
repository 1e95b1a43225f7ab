use nalgebra::Vector3;

use super::cause::{Cause, Finding};
use super::kinematics::CLEAR;
use super::laws::Steps;
use super::series::{Series, rms};
use super::subject::Subject;
use crate::dynamics::EulerEquations;

/// What an error of a known kind leaves in ω in an interval, up to a factor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Template {
    /// −ω Δt.
    Damping,
    /// −½ (ω̇ after − ω̇ before): a step at first order.
    FirstOrder,
    /// The same of ω kept in world axes, and q moved by the old ω.
    FirstOrderInWorld,
    /// What the torques make of ω in the interval.
    Torque,
}

const ALL: [Template; 4] = [Template::Damping, Template::FirstOrder, Template::FirstOrderInWorld, Template::Torque];
/// A template explains errors if it leaves less than this of them.
const EXPLAINS: f64 = 0.6;

/// The template that explains most of the errors, and what it leaves, rad/s.
pub(super) fn best(
    subject: &Subject,
    series: &Series,
    steps: &Steps,
    defects: &[Vector3<f64>],
) -> Option<((Template, f64), f64)> {
    let longest = steps.intervals.iter().map(|k| series.times[k + 1] - series.times[*k]).fold(0.0, f64::max);
    let fits = ALL.into_iter().filter_map(|template| {
        let shapes: Vec<_> = steps.intervals.iter().map(|k| template.shape(subject, series, *k)).collect();
        let factor = factor(defects, &shapes).filter(|factor| template.admits(*factor, longest))?;
        let left = rms(defects.iter().zip(&shapes).map(|(defect, shape)| (defect - shape * factor).norm()));
        Some(((template, factor), left))
    });
    fits.min_by(|one, other| one.1.total_cmp(&other.1))
}

/// One template after the other, as long as they explain.
pub(super) fn explain(
    subject: &Subject,
    series: &Series,
    steps: &Steps,
    mut defects: Vec<Vector3<f64>>,
    floor: f64,
    all: f64,
) -> Vec<Finding> {
    let mut findings = Vec::new();
    for _ in 0..2 {
        let before = rms(defects.iter().map(Vector3::norm));
        let Some(((template, factor), left)) = best(subject, series, steps, &defects) else { break };
        if left > EXPLAINS * before || before <= CLEAR * floor {
            break;
        }
        let explained = (before * before - left * left) / (all * all);
        let cause = template.cause(factor);
        let evidence = template.evidence(factor, left / before);
        findings.push(Finding { cause, share: explained.clamp(0.0, 1.0), evidence });
        for (defect, &k) in defects.iter_mut().zip(&steps.intervals) {
            *defect -= template.shape(subject, series, k) * factor;
        }
    }
    findings
}

fn factor(defects: &[Vector3<f64>], shapes: &[Vector3<f64>]) -> Option<f64> {
    let over: f64 = defects.iter().zip(shapes).map(|(defect, shape)| defect.dot(shape)).sum();
    let under: f64 = shapes.iter().map(Vector3::norm_squared).sum();
    (under > 0.0).then(|| over / under)
}

impl Template {
    fn shape(self, subject: &Subject, series: &Series, k: usize) -> Vector3<f64> {
        let duration = series.times[k + 1] - series.times[k];
        let problem = subject.problem();
        let euler = EulerEquations::new(problem.moments);
        let moment = |k: usize| subject.moment(series.times[k], &subject.state(k));
        let rate = |k: usize| euler.acceleration(&subject.omega[k], &moment(k));
        match self {
            Self::Damping => -duration * 0.5 * (subject.omega[k] + subject.omega[k + 1]),
            Self::FirstOrder => -0.5 * (rate(k + 1) - rate(k)),
            Self::FirstOrderInWorld => {
                let mean = 0.5 * (rate(k) + rate(k + 1));
                -0.5 * (rate(k + 1) - rate(k)) - duration * subject.omega[k].cross(&mean)
            }
            Self::Torque => duration * (0.5 * (moment(k) + moment(k + 1))).component_div(&problem.moments.vector()),
        }
    }

    /// No step is longer than the time between samples.
    fn admits(self, factor: f64, longest: f64) -> bool {
        const ROOM: f64 = 1.5;
        match self {
            Self::Damping => factor > 0.0,
            Self::FirstOrder | Self::FirstOrderInWorld => factor.abs() < ROOM * longest,
            Self::Torque => true,
        }
    }

    fn cause(self, factor: f64) -> Cause {
        match self {
            Self::Damping => Cause::Damping { rate: factor },
            Self::FirstOrder | Self::FirstOrderInWorld if factor > 0.0 => Cause::ExplicitStep { step_s: factor },
            Self::FirstOrder | Self::FirstOrderInWorld => Cause::ImplicitStep { step_s: -factor },
            Self::Torque => Cause::TorqueScaled { factor: 1.0 + factor },
        }
    }

    fn evidence(self, factor: f64, left: f64) -> String {
        let explained = 100.0 * (1.0 - left);
        match self {
            Self::Damping => format!("errors of ω lie along −ω: {explained:.0} % of them are {factor:.4e}/s of it"),
            Self::FirstOrder | Self::FirstOrderInWorld => {
                let sign = if factor > 0.0 { "−" } else { "+" };
                format!(
                    "errors of ω are {sign}h/2 of the change of ω̇, {explained:.0} % of them, with h = {:.4e} s",
                    factor.abs()
                )
            }
            Self::Torque => format!("errors of ω lie along I⁻¹ τ, {explained:.0} % of them"),
        }
    }
}
