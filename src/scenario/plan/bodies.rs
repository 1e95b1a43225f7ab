use std::collections::HashSet;

use super::rules::{optional_vector, rotation, unused, vector};
use super::{channels, loads, mass, path, points, work};
use crate::body::{AngularVelocity, Attitude, MassProperties, State};
use crate::dynamics::{Load, Problem, rotor_momentum};
use crate::scenario::faults::{Faults, MOST_FAULTS};
use crate::scenario::watch::wants_translation;
use crate::scenario::{BodySpec, Grid, Key, PlannedBody, Refusal, Scenario};

/// Bodies of a scene, with their probes and IMUs: as many as a recording can have.
pub const MOST_BODIES: usize = 65_535;

/// All bodies, each with its path, or what is refused of each.
pub fn plan(scenario: &Scenario, grid: &Grid) -> Result<Vec<PlannedBody>, Faults<Refusal>> {
    let count = scenario.body.len();
    if count > MOST_BODIES {
        return Err(Key::root("body").refuse(format_args!("{count} bodies: at most {MOST_BODIES}")).into());
    }
    let (mut bodies, mut refusals) = (Vec::new(), Vec::new());
    let mut names = HashSet::new();
    for (index, spec) in scenario.body.iter().enumerate() {
        let key = Key::root("body").index(index);
        let planned = name(&key, spec, count).and_then(|name| {
            if !names.insert(name.clone()) {
                return Err(key.field("name").refuse(format_args!("{name:?} is the name of two bodies")));
            }
            body(scenario, grid, &key, spec, name)
        });
        match planned {
            Ok(body) => bodies.push(body),
            // What the scene says of all bodies is refused once.
            Err(refusal) if refusals.contains(&refusal) => {}
            Err(refusal) => refusals.push(refusal),
        }
        if refusals.len() == MOST_FAULTS {
            break;
        }
    }
    let recorded = bodies.len() + bodies.iter().map(|body| body.points.len()).sum::<usize>();
    if refusals.is_empty() && recorded > MOST_BODIES {
        let rule = format_args!("{recorded} bodies, probes and IMUs: at most {MOST_BODIES}");
        refusals.push(Key::root("body").refuse(rule));
    }
    Faults::of(refusals).map_or(Ok(bodies), Err)
}

fn name(key: &Key, spec: &BodySpec, count: usize) -> Result<String, Refusal> {
    let key = key.field("name");
    let name = &spec.name;
    if name.is_empty() {
        let rule = "missing: bodies of a scene with several need names";
        return if count == 1 { Ok("body".to_owned()) } else { Err(key.refuse(rule)) };
    }
    let is_fit = |letter: char| letter.is_ascii_alphanumeric() || letter == '_' || letter == '-';
    if name.len() > 64 || !name.chars().all(is_fit) {
        return Err(key.refuse(format_args!("{name:?}: at most 64 letters, digits, _ and -, as it names topics")));
    }
    Ok(name.clone())
}

fn body(scenario: &Scenario, grid: &Grid, key: &Key, spec: &BodySpec, name: String) -> Result<PlannedBody, Refusal> {
    let (properties, surfaces) = mass::plan(key, spec, &scenario.folder)?;
    let is_pivoted = spec.pivot.is_some();
    let rotors = loads::rotors(key, spec, &properties)?;
    let initial = initial(key, spec, &properties, &rotors)?;
    let acting = loads::plan(key, spec, &properties, &initial, rotors, &scenario.folder, grid.end())?;
    extent(key, spec, &properties, &initial)?;
    let moves = acting.moves || initial.velocity.norm() > 0.0;
    let mut problem = Problem {
        moments: properties.moments,
        mass: properties.mass,
        initial,
        loads: acting.on_rotation,
        gravity: acting.gravity,
        wants_attitude: true,
        wants_translation: false,
    };
    let recorded = channels::choose(scenario, &problem, moves)?;
    // What else is propagated bears on the steps, and a trial is to make those of the run.
    let points = points::plan(key, spec, &name, &properties)?;
    let all = recorded.iter().chain(points.iter().flat_map(|point| &point.channels));
    problem.wants_translation = wants_translation(&problem, moves, all);
    let accuracy = path::accuracy(scenario, grid)?;
    work::check(scenario, &problem, moves, grid.end())?;
    let (path, reason) = path::choose(scenario, &problem, moves, &accuracy)?;
    let body = PlannedBody {
        name,
        properties,
        surfaces,
        problem,
        path,
        reason,
        channels: Vec::new(),
        points,
        skipped: Vec::new(),
        is_pivoted,
        moves,
        certificate: None,
    };
    Ok(body.watching(&recorded))
}

/// Moments outside of this, kg m², and rates above it, rad/s, have squares and products that f64 cannot hold.
const LEAST: f64 = 1e-60;
const LARGEST: f64 = 1e60;

/// Refuses bodies and rates that are beyond the numbers.
fn extent(key: &Key, spec: &BodySpec, properties: &MassProperties, initial: &State) -> Result<(), Refusal> {
    let moments = properties.moments.vector();
    // A needle may have no moment about its axis at all.
    if moments.max() > LARGEST || moments.max() < LEAST {
        let rule = format!("the largest moment of inertia is {:e} kg m²: {LEAST:e} to {LARGEST:e}", moments.max());
        return Err(key.refuse(rule));
    }
    let fastest = initial.angular_velocity.in_body().amax();
    // Written so that NaN is refused too.
    if fastest <= LARGEST {
        return Ok(());
    }
    let given = if spec.angular_momentum_n_m_s.is_some() { "angular_momentum_n_m_s" } else { "angular_velocity_rad_s" };
    Err(key.field(given).refuse(format_args!("makes {fastest:e} rad/s: at most {LARGEST:e}")))
}

/// The first state, in principal axes.
fn initial(key: &Key, spec: &BodySpec, properties: &MassProperties, loads: &[Load]) -> Result<State, Refusal> {
    let principal_from_body = properties.body_from_principal.inverse();
    let momentum_key = key.field("angular_momentum_n_m_s");
    let angular_velocity = match (spec.angular_velocity_rad_s, spec.angular_momentum_n_m_s) {
        (Some(_), Some(_)) => {
            return Err(momentum_key.refuse("given beside angular_velocity_rad_s: one of the two"));
        }
        (velocity, None) => principal_from_body * optional_vector(&key.field("angular_velocity_rad_s"), velocity)?,
        (None, Some(momentum)) => {
            // Of body and rotors together, as it is recorded.
            let momentum = principal_from_body * vector(&momentum_key, momentum)? - rotor_momentum(loads, 0.0);
            momentum.component_div(&properties.moments.vector())
        }
    };
    if spec.pivot.is_some() {
        let rule = "a body with a pivot goes nowhere";
        unused(&key.field("velocity_m_s"), spec.velocity_m_s.as_ref(), rule)?;
    }
    let world_from_body = rotation(&key.field("attitude"), spec.attitude)?.world_from_body();
    Ok(State {
        attitude: Attitude::from_world_from_body(world_from_body * properties.body_from_principal),
        angular_velocity: AngularVelocity::from_vector(angular_velocity),
        position: optional_vector(&key.field("position_m"), spec.position_m)?,
        velocity: optional_vector(&key.field("velocity_m_s"), spec.velocity_m_s)?,
    })
}
