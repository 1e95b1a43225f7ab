use super::{channel, motion};
use crate::scenario::plan::channels::{missing_law, named};
use crate::scenario::plan::rules::{finite, not_negative, positive, unit_vector};
use crate::scenario::{
    CheckKind, CheckPlan, Key, Observation, ObservedSpec, PlannedBody, Refusal, Scenario, ValueSpec, nearest,
};
use crate::telemetry::Channel;

/// Every check of the scene, ready to be measured.
pub fn plan(scenario: &Scenario, bodies: &[PlannedBody], end: f64) -> Result<Vec<CheckPlan>, Refusal> {
    let mut plans = Vec::new();
    let root = Key::root("check");
    for (index, spec) in scenario.check.flip_period.iter().enumerate() {
        let key = root.field("flip_period").index(index);
        plans.push(CheckPlan {
            body: body(&key, spec.body.as_deref(), bodies)?,
            point: None,
            kind: CheckKind::FlipPeriod,
            expected: positive(&key.field("expected_s"), spec.expected_s)?,
            tolerance: positive(&key.field("tolerance_s"), spec.tolerance_s)?,
            unit: "s",
            observed: observation(&key, spec.observed)?,
        });
    }
    let laws = [
        ("energy", &scenario.check.energy, Channel::EnergyDrift, CheckKind::Energy { duration: end }),
        ("momentum", &scenario.check.momentum, Channel::MomentumDrift, CheckKind::Momentum { duration: end }),
    ];
    for (field, specs, channel, kind) in laws {
        for (index, spec) in specs.iter().enumerate() {
            let key = root.field(field).index(index);
            let body = body(&key, spec.body.as_deref(), bodies)?;
            if let Some(rule) = missing_law(&bodies[body].problem, channel) {
                return Err(key.refuse(format_args!("{field} {rule}")));
            }
            let tolerance = positive(&key.field("tolerance"), spec.tolerance)?;
            plans.push(CheckPlan {
                body,
                point: None,
                kind: kind.clone(),
                expected: 0.0,
                tolerance,
                unit: "",
                observed: None,
            });
        }
    }
    for (index, spec) in scenario.check.precession_rate.iter().enumerate() {
        let key = root.field("precession_rate").index(index);
        let around = spec.around.map(|around| unit_vector(&key.field("around"), around)).transpose()?;
        plans.push(CheckPlan {
            body: body(&key, spec.body.as_deref(), bodies)?,
            point: None,
            kind: CheckKind::PrecessionRate {
                frame: spec.frame,
                axis: unit_vector(&key.field("axis"), spec.axis)?,
                around,
                duration: positive(&key.field("over_s"), spec.over_s.unwrap_or(end))?,
            },
            expected: finite(&key.field("expected_rad_s"), spec.expected_rad_s)?,
            tolerance: positive(&key.field("tolerance_rad_s"), spec.tolerance_rad_s)?,
            unit: "rad/s",
            observed: observation(&key, spec.observed)?,
        });
    }
    for (index, spec) in scenario.check.value.iter().enumerate() {
        plans.push(value(&root.field("value").index(index), spec, bodies)?);
    }
    plans.extend(channel::plan(&root, &scenario.check, bodies, end)?);
    plans.extend(motion::plan(&root, &scenario.check, bodies, end)?);
    Ok(plans)
}

fn value(key: &Key, spec: &ValueSpec, bodies: &[PlannedBody]) -> Result<CheckPlan, Refusal> {
    let Quantity { body, point, channel, component } =
        quantity(key, bodies, spec.body.as_deref(), (&spec.channel, spec.component.as_deref()))?;
    Ok(CheckPlan {
        body,
        point,
        kind: CheckKind::Value { channel, component, time: not_negative(&key.field("time_s"), spec.time_s)? },
        expected: finite(&key.field("expected"), spec.expected)?,
        tolerance: positive(&key.field("tolerance"), spec.tolerance)?,
        unit: channel.row().unit,
        observed: None,
    })
}

/// A component of a channel, and of what.
pub struct Quantity {
    /// Number of the body.
    pub body: usize,
    /// Number of its point, if it is of one.
    pub point: Option<usize>,
    /// Which channel.
    pub channel: Channel,
    /// Number of the component.
    pub component: usize,
}

/// The channel and the component that a check names, of the body or the point that it names; the first body, if none.
pub fn quantity(
    key: &Key,
    bodies: &[PlannedBody],
    watched: Option<&str>,
    (name, component): (&str, Option<&str>),
) -> Result<Quantity, Refusal> {
    let (body, point) = numbers(key, watched, bodies)?;
    let channel_key = key.field("channel");
    let channel = named(&channel_key, name)?;
    match point.map(|number| &bodies[body].points[number]) {
        Some(point) if !point.channels.contains(&channel) => {
            let known: Vec<_> = point.channels.iter().map(|channel| channel.row().name).collect();
            let rule = format_args!("{name:?} is not recorded of {}: {} are", point.name, known.join(", "));
            return Err(channel_key.refuse(rule));
        }
        Some(_) => {}
        None => {
            if let Some(rule) = missing_law(&bodies[body].problem, channel) {
                return Err(channel_key.refuse(format_args!("{name:?} {rule}")));
            }
        }
    }
    let components = channel.row().components;
    let asked = component.unwrap_or_default();
    let component = components.iter().position(|component| *component == asked).ok_or_else(|| {
        let known = components.join(", ");
        key.field("component").refuse(format_args!("{asked:?} is no component of {name}: {known}"))
    })?;
    Ok(Quantity { body, point, channel, component })
}

/// Numbers of the body and of the point of that name.
fn numbers(key: &Key, name: Option<&str>, bodies: &[PlannedBody]) -> Result<(usize, Option<usize>), Refusal> {
    let is_point = name.is_some_and(|name| name.contains('/'));
    if !is_point {
        return Ok((body(key, name, bodies)?, None));
    }
    let name = name.unwrap_or_default();
    let points = || bodies.iter().enumerate().flat_map(|(body, planned)| std::iter::repeat(body).zip(&planned.points));
    let found = points().find(|(_, point)| point.name == name).map(|(body, _)| body);
    let Some(body) = found else {
        let known = || points().map(|(_, point)| point.name.as_str());
        let hint = nearest(name, known()).map_or_else(
            || format!(": {}", known().collect::<Vec<_>>().join(", ")),
            |near| format!("; did you mean {near:?}?"),
        );
        let hint = if known().next().is_some() { hint } else { ", which has none".to_owned() };
        return Err(key.field("body").refuse(format_args!("{name:?} is no probe or IMU of this scene{hint}")));
    };
    Ok((body, bodies[body].points.iter().position(|point| point.name == name)))
}

/// What was observed, if a check tells it.
pub fn observation(key: &Key, spec: Option<ObservedSpec>) -> Result<Option<Observation>, Refusal> {
    let Some(spec) = spec else { return Ok(None) };
    let key = key.field("observed");
    let tolerance = spec.tolerance.map(|tolerance| positive(&key.field("tolerance"), tolerance)).transpose()?;
    Ok(Some(Observation {
        published: finite(&key.field("published"), spec.published)?,
        uncertainty: not_negative(&key.field("uncertainty"), spec.uncertainty)?,
        tolerance,
    }))
}

pub fn body(key: &Key, name: Option<&str>, bodies: &[PlannedBody]) -> Result<usize, Refusal> {
    let Some(name) = name else { return Ok(0) };
    bodies.iter().position(|body| body.name == name).ok_or_else(|| {
        let known: Vec<_> = bodies.iter().map(|body| body.name.as_str()).collect();
        let hint = nearest(name, known.iter().copied())
            .map_or_else(|| format!(": {}", known.join(", ")), |near| format!("; did you mean {near:?}?"));
        key.field("body").refuse(format_args!("{name:?} is no body of this scene{hint}"))
    })
}
