use super::{bodies, checks, events, sampling};
use crate::scenario::faults::Faults;
use crate::scenario::{Key, Plan, PlannedBody, Refusal, Scenario, ScenarioError};

impl Plan {
    /// Checks every key of `scenario` and chooses each body's path.
    ///
    /// # Errors
    /// If a key breaks a rule: the message names file, key, value and rule, with the line where the text is at hand.
    pub fn new(scenario: &Scenario) -> Result<Self, ScenarioError> {
        plan(scenario).map_err(|refusals| refusals.first.locate(scenario))
    }

    /// As [`Self::new`], and where that fails what is wrong with the sampling, with each body and with the checks.
    ///
    /// # Errors
    /// As [`Self::new`]; there is one at least.
    pub fn new_all(scenario: &Scenario) -> Result<Self, Vec<ScenarioError>> {
        plan(scenario).map_err(|refusals| refusals.map(|refusal| refusal.locate(scenario)).all())
    }
}

fn plan(scenario: &Scenario) -> Result<Plan, Faults<Refusal>> {
    let grid = sampling::grid(scenario)?;
    if scenario.body.is_empty() {
        return Err(Key::root("body").refuse("a scene needs at least one [[body]]").into());
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
        events: events::plan(&bodies, grid.end()),
        outcomes: Vec::new(),
        tolerance_rad: scenario.tolerance_rad,
        checks: checks::plan(scenario, &bodies, grid.end())?,
        grid,
        bodies,
    })
}

/// The scene in words, and what follows from the mesh files and tables that it names.
fn identity(scenario: &Scenario, bodies: &[PlannedBody]) -> String {
    let scene = if scenario.text.is_empty() { format!("{scenario:?}") } else { scenario.text.clone() };
    let properties: Vec<_> = bodies.iter().map(|body| &body.properties).collect();
    let profiles = bodies.iter().flat_map(|body| &body.problem.loads).filter_map(|load| load.torque.profile());
    profiles.fold(format!("{scene}\n{properties:?}"), |text, profile| format!("{text}\n{:032x}", profile.fingerprint()))
}
