use super::plan::{Quantity, observation, quantity};
use crate::scenario::plan::rules::{finite, not_negative, positive};
use crate::scenario::{
    CheckKind, CheckPlan, Checks, ConservedSpec, ExtremumSpec, Key, PeriodSpec, PlannedBody, RateSpec, Refusal,
};

/// Periods that a mean is taken over, at most: each is looked for.
const MOST_CYCLES: u16 = 1000;

/// The checks that look at a channel over time.
pub fn plan(root: &Key, checks: &Checks, bodies: &[PlannedBody], end: f64) -> Result<Vec<CheckPlan>, Refusal> {
    let mut plans = Vec::new();
    for (index, spec) in checks.period.iter().enumerate() {
        plans.push(period(&root.field("period").index(index), spec, bodies)?);
    }
    for (index, spec) in checks.rate.iter().enumerate() {
        plans.push(rate(&root.field("rate").index(index), spec, bodies, end)?);
    }
    for (index, spec) in checks.extremum.iter().enumerate() {
        plans.push(extremum(&root.field("extremum").index(index), spec, bodies, end)?);
    }
    for (index, spec) in checks.conserved.iter().enumerate() {
        plans.push(conserved(&root.field("conserved").index(index), spec, bodies, end)?);
    }
    Ok(plans)
}

fn period(key: &Key, spec: &PeriodSpec, bodies: &[PlannedBody]) -> Result<CheckPlan, Refusal> {
    let Quantity { body, point, channel, component } =
        quantity(key, bodies, spec.body.as_deref(), (&spec.channel, spec.component.as_deref()))?;
    let cycles = spec.cycles.unwrap_or(1);
    if !(1..=MOST_CYCLES).contains(&cycles) {
        return Err(key.field("cycles").refuse(format_args!("{cycles} is not from 1 to {MOST_CYCLES}")));
    }
    Ok(CheckPlan {
        body,
        point,
        kind: CheckKind::Period {
            channel,
            component,
            level: finite(&key.field("level"), spec.level.unwrap_or(0.0))?,
            cycles,
        },
        expected: positive(&key.field("expected_s"), spec.expected_s)?,
        tolerance: positive(&key.field("tolerance_s"), spec.tolerance_s)?,
        unit: "s",
        observed: observation(key, spec.observed)?,
    })
}

fn rate(key: &Key, spec: &RateSpec, bodies: &[PlannedBody], end: f64) -> Result<CheckPlan, Refusal> {
    let Quantity { body, point, channel, component } =
        quantity(key, bodies, spec.body.as_deref(), (&spec.channel, spec.component.as_deref()))?;
    if !channel.comes_round() {
        let name = &spec.channel;
        let rule = format_args!("{name:?} is no angle that comes round; its values are for check.value");
        return Err(key.field("channel").refuse(rule));
    }
    Ok(CheckPlan {
        body,
        point,
        kind: CheckKind::Rate {
            channel,
            component,
            duration: positive(&key.field("over_s"), spec.over_s.unwrap_or(end))?,
        },
        expected: finite(&key.field("expected_rad_s"), spec.expected_rad_s)?,
        tolerance: positive(&key.field("tolerance_rad_s"), spec.tolerance_rad_s)?,
        unit: "rad/s",
        observed: observation(key, spec.observed)?,
    })
}

fn extremum(key: &Key, spec: &ExtremumSpec, bodies: &[PlannedBody], end: f64) -> Result<CheckPlan, Refusal> {
    let Quantity { body, point, channel, component } =
        quantity(key, bodies, spec.body.as_deref(), (&spec.channel, spec.component.as_deref()))?;
    let from = not_negative(&key.field("from_s"), spec.from_s.unwrap_or(0.0))?;
    let to = finite(&key.field("to_s"), spec.to_s.unwrap_or(end))?;
    if to <= from {
        return Err(key.field("to_s").refuse(format_args!("{to} is not after from_s = {from}")));
    }
    Ok(CheckPlan {
        body,
        point,
        kind: CheckKind::Extremum { channel, component, extremum: spec.extremum, from, to },
        expected: finite(&key.field("expected"), spec.expected)?,
        tolerance: positive(&key.field("tolerance"), spec.tolerance)?,
        unit: channel.row().unit,
        observed: None,
    })
}

fn conserved(key: &Key, spec: &ConservedSpec, bodies: &[PlannedBody], end: f64) -> Result<CheckPlan, Refusal> {
    let Quantity { body, point, channel, component } =
        quantity(key, bodies, spec.body.as_deref(), (&spec.channel, spec.component.as_deref()))?;
    Ok(CheckPlan {
        body,
        point,
        kind: CheckKind::Conserved { channel, component, duration: end },
        expected: 0.0,
        tolerance: positive(&key.field("tolerance"), spec.tolerance)?,
        unit: "",
        observed: None,
    })
}
