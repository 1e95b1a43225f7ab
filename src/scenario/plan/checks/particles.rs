use super::plan::body;
use crate::scenario::plan::rules::{not_negative, positive};
use crate::scenario::{CheckKind, CheckPlan, Checks, Key, PlannedBody, Refusal};

/// The checks of particles on springs.
pub fn plan(root: &Key, checks: &Checks, bodies: &[PlannedBody], end: f64) -> Result<Vec<CheckPlan>, Refusal> {
    let mut plans = Vec::new();
    for (index, spec) in checks.internal_forces.iter().enumerate() {
        let key = root.field("internal_forces").index(index);
        plans.push(CheckPlan {
            point: None,
            body: of_particles(&key, spec.body.as_deref(), bodies)?,
            kind: CheckKind::InternalForces { duration: positive(&key.field("over_s"), spec.over_s.unwrap_or(end))? },
            expected: 0.0,
            tolerance: positive(&key.field("tolerance"), spec.tolerance)?,
            unit: "",
            observed: None,
        });
    }
    for (index, spec) in checks.departure_from_rigid.iter().enumerate() {
        let key = root.field("departure_from_rigid").index(index);
        plans.push(CheckPlan {
            point: None,
            body: of_particles(&key, spec.body.as_deref(), bodies)?,
            kind: CheckKind::DepartureFromRigid { time: not_negative(&key.field("time_s"), spec.time_s)? },
            expected: not_negative(&key.field("expected_rad"), spec.expected_rad)?,
            tolerance: positive(&key.field("tolerance_rad"), spec.tolerance_rad)?,
            unit: "rad",
            observed: None,
        });
    }
    Ok(plans)
}

fn of_particles(key: &Key, name: Option<&str>, bodies: &[PlannedBody]) -> Result<usize, Refusal> {
    let number = body(key, name, bodies)?;
    if bodies[number].problem.cloud().is_some() {
        return Ok(number);
    }
    Err(key.refuse(format_args!("{:?} is rigid: this is of particles on springs", bodies[number].name)))
}
