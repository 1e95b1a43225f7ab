use std::f64::consts::PI;

use super::plan::body;
use crate::scenario::plan::rules::{finite, positive, unit_vector};
use crate::scenario::{
    CheckKind, CheckPlan, Checks, Key, MontgomeryPhaseSpec, PlannedBody, Refusal, StabilitySpec, Verdict,
};

/// The checks that look at the attitude.
pub fn plan(root: &Key, checks: &Checks, bodies: &[PlannedBody], end: f64) -> Result<Vec<CheckPlan>, Refusal> {
    let mut plans = Vec::new();
    for (index, spec) in checks.stability.iter().enumerate() {
        plans.push(stability(&root.field("stability").index(index), spec, bodies, end)?);
    }
    for (index, spec) in checks.montgomery_phase.iter().enumerate() {
        plans.push(montgomery_phase(&root.field("montgomery_phase").index(index), spec, bodies)?);
    }
    Ok(plans)
}

/// An axis that stays is off by 0 to the angle, one that leaves by the angle to π.
fn stability(key: &Key, spec: &StabilitySpec, bodies: &[PlannedBody], end: f64) -> Result<CheckPlan, Refusal> {
    let angle_key = key.field("angle_rad");
    let angle = positive(&angle_key, spec.angle_rad)?;
    if angle >= PI {
        return Err(angle_key.refuse(format_args!("{angle} is not below pi: no axis is further off than that")));
    }
    let (expected, tolerance) = match spec.verdict {
        Verdict::Stays => (0.0, angle),
        Verdict::Leaves => (0.5 * (PI + angle), 0.5 * (PI - angle)),
    };
    Ok(CheckPlan {
        body: body(key, spec.body.as_deref(), bodies)?,
        point: None,
        kind: CheckKind::Stability {
            axis: unit_vector(&key.field("axis"), spec.axis)?,
            near: spec.near.map(|near| unit_vector(&key.field("near"), near)).transpose()?,
            duration: positive(&key.field("over_s"), spec.over_s.unwrap_or(end))?,
            verdict: spec.verdict,
            angle,
        },
        expected,
        tolerance,
        unit: "rad",
        observed: None,
    })
}

fn montgomery_phase(key: &Key, spec: &MontgomeryPhaseSpec, bodies: &[PlannedBody]) -> Result<CheckPlan, Refusal> {
    let body = body(key, spec.body.as_deref(), bodies)?;
    let problem = &bodies[body].problem;
    let [a, b, c]: [f64; 3] = problem.moments.vector().into();
    if !problem.loads.is_empty() || a == b || b == c || c == a {
        let rule = "montgomery_phase is of a body of three different moments that nothing acts on";
        return Err(key.refuse(rule));
    }
    Ok(CheckPlan {
        body,
        point: None,
        kind: CheckKind::MontgomeryPhase { period: positive(&key.field("period_s"), spec.period_s)? },
        expected: finite(&key.field("expected_rad"), spec.expected_rad)?,
        tolerance: positive(&key.field("tolerance_rad"), spec.tolerance_rad)?,
        unit: "rad",
        observed: None,
    })
}
