use super::{bodies, checks, sampling};
use crate::dynamics::{Load, Torque};
use crate::scenario::{Event, Key, Plan, PlannedBody, Refusal, Scenario, ScenarioError};

impl Plan {
    /// Checks every key of `scenario` and chooses each body's path.
    ///
    /// # Errors
    /// If a key breaks a rule: the message names file, key, value and rule, with the line where the text is at hand.
    pub fn new(scenario: &Scenario) -> Result<Self, ScenarioError> {
        plan(scenario).map_err(|refusal| refusal.locate(scenario))
    }
}

fn plan(scenario: &Scenario) -> Result<Plan, Refusal> {
    let grid = sampling::grid(scenario)?;
    if scenario.body.is_empty() {
        return Err(Key::root("body").refuse("a scene needs at least one [[body]]"));
    }
    let bodies = bodies::plan(scenario, &grid)?;
    let or = |text: &str, other: &str| if text.is_empty() { other.to_owned() } else { text.to_owned() };
    let name = or(&scenario.name, "scene");
    Ok(Plan {
        title: or(&scenario.title, &name),
        name,
        summary: scenario.summary.clone(),
        text: scenario.text.clone(),
        identity: identity(scenario, &bodies),
        provenance: scenario.provenance.clone(),
        events: events(&bodies, grid.end()),
        tolerance_rad: scenario.tolerance_rad,
        checks: checks::plan(scenario, &bodies, grid.end())?,
        grid,
        bodies,
    })
}

/// The scene in words, and what follows from the mesh files that it names.
fn identity(scenario: &Scenario, bodies: &[PlannedBody]) -> String {
    let scene = if scenario.text.is_empty() { format!("{scenario:?}") } else { scenario.text.clone() };
    let properties: Vec<_> = bodies.iter().map(|body| &body.properties).collect();
    format!("{scene}\n{properties:?}")
}

/// The edges of windows within the run.
fn events(bodies: &[PlannedBody], end: f64) -> Vec<Event> {
    let mut events = Vec::new();
    for (number, body) in bodies.iter().enumerate() {
        for load in &body.problem.loads {
            for (time_s, word) in [(load.window.start, "on"), (load.window.end, "off")] {
                if time_s > 0.0 && time_s <= end {
                    events.push(Event { time_s, body: number, text: format!("{} {word}", describe(load)) });
                }
            }
        }
    }
    events.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
    events
}

fn describe(load: &Load) -> String {
    let three = |v: &nalgebra::Vector3<f64>| format!("({}, {}, {})", v.x, v.y, v.z);
    match &load.torque {
        Torque::ConstantBody { moment } => format!("body torque {} N m", three(moment)),
        Torque::ConstantWorld { moment } => format!("world torque {} N m", three(moment)),
        Torque::MomentumBrake { rate } => format!("brake of {rate} /s"),
        Torque::LinearDamping { coefficient } => format!("damping {coefficient} N m s"),
        Torque::ForceBody { force, .. } => format!("body force {} N", three(force)),
        Torque::ForceWorld { force, .. } => format!("world force {} N", three(force)),
        Torque::GravityGradient { .. } => "gravity gradient".to_owned(),
    }
}
