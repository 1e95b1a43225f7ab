use crate::dynamics::{Load, Torque};
use crate::propagation::FreeRotation;
use crate::scenario::{Event, EventKind, PlannedBody};

/// Flips of a body that are told, at most: a log of more is read by nobody.
const MOST_FLIPS: usize = 1000;

/// Beginnings and ends of the pulses of one load that are told, at most.
const MOST_SWITCHES: usize = 1000;

/// L within 45° of an end of the middle axis is a spin about it: to the other end, the body turns over.
const NEAR: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// What happens within the run, in order of time.
pub fn plan(bodies: &[PlannedBody], end: f64) -> Vec<Event> {
    let mut events = Vec::new();
    for (number, body) in bodies.iter().enumerate() {
        events.extend(body.problem.loads.iter().flat_map(|load| edges(load, number, end)));
        events.extend(flips(body, number, end));
    }
    events.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
    events
}

/// When the load begins and ends.
fn edges(load: &Load, body: usize, end: f64) -> impl Iterator<Item = Event> {
    let window = load.window;
    let edges = [(window.start, "on"), (window.end, "off")].into_iter();
    // A rotor is there whether it spins or not.
    let profile = load.torque.profile().filter(|_| !load.torque.is_internal());
    let switches = profile.into_iter().flat_map(|profile| profile.switches()).take(MOST_SWITCHES);
    let within = switches.filter(move |(time_s, _)| window.start < *time_s && *time_s < window.end);
    edges
        .chain(within.map(|(time_s, on)| (time_s, if on { "on" } else { "off" })))
        .filter(move |(time_s, _)| *time_s > 0.0 && *time_s <= end)
        .map(move |(time_s, word)| Event {
            time_s,
            body,
            kind: EventKind::Load,
            text: format!("{} {word}", describe(load)),
        })
}

/// When a body that nothing acts on turns over: ω along its middle axis changes sign, and L goes from near one end of
/// that axis to near the other. The times are those of the exact motion.
fn flips(planned: &PlannedBody, body: usize, end: f64) -> Vec<Event> {
    // What the closed form does not cover has no flips that could be told.
    let Ok(Some(reversals)) = FreeRotation::reversals(&planned.problem) else { return Vec::new() };
    if reversals.nearness < NEAR {
        return Vec::new();
    }
    let flip = |(number, time_s): (usize, f64)| Event {
        time_s,
        body,
        kind: EventKind::Flip,
        text: format!("flip {}: the spin about the middle axis reverses", number + 1),
    };
    reversals.until(end).take(MOST_FLIPS).enumerate().map(flip).collect()
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
        Torque::ProfileBody { .. } => "body torque by a table".to_owned(),
        Torque::ProfileWorld { .. } => "world torque by a table".to_owned(),
        Torque::ForceProfileBody { arm, .. } => format!("thrust at {} m from the reference point", three(arm)),
        Torque::ForceProfileWorld { .. } => "world force by a table".to_owned(),
        Torque::Rotor { .. } => "rotor".to_owned(),
        Torque::MagneticDipole { dipole, .. } => format!("magnetic dipole {} A m²", three(dipole)),
        Torque::GravityGradient { .. } => "gravity gradient".to_owned(),
        Torque::General(load) => load.kind.name().to_owned(),
    }
}
