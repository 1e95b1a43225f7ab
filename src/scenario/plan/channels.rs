use crate::dynamics::{Kovalevskaya, Problem, Torque};
use crate::scenario::nearest;
use crate::scenario::{Key, Refusal, Scenario};
use crate::telemetry::{Channel, Encircled, FigureAxis, FigureFrame};

/// What is recorded of one body: what was asked for, or what the scene makes interesting; in the order of
/// [`Channel::ALL`].
pub fn choose(scenario: &Scenario, problem: &Problem, moves: bool) -> Result<Vec<Channel>, Refusal> {
    let Some(names) = &scenario.channels else { return Ok(interesting(problem, moves)) };
    let key = Key::root("channels");
    if names.is_empty() {
        return Err(key.refuse("empty: name at least one channel, or leave the key out"));
    }
    let mut asked = Vec::new();
    for (index, name) in names.iter().enumerate() {
        let key = key.index(index);
        let channel = named(&key, name)?;
        if asked.contains(&channel) {
            return Err(key.refuse(format_args!("{name:?} is named twice")));
        }
        if let Some(rule) = missing_law(problem, channel) {
            return Err(key.refuse(format_args!("{name:?} {rule}")));
        }
        asked.push(channel);
    }
    asked.sort_unstable();
    Ok(asked)
}

/// The channel called `name`.
pub fn named(key: &Key, name: &str) -> Result<Channel, Refusal> {
    Channel::from_name(name).ok_or_else(|| {
        let names = Channel::ALL.map(|channel| channel.row().name);
        let hint = nearest(name, names.into_iter())
            .map_or_else(|| format!("known are {}", names.join(", ")), |near| format!("did you mean {near:?}?"));
        key.refuse(format_args!("{name:?} is no channel; {hint}"))
    })
}

/// Why a channel cannot be told: nothing is conserved, or nothing leans.
pub fn missing_law(problem: &Problem, channel: Channel) -> Option<&'static str> {
    match channel {
        Channel::EnergyDrift if problem.energy_law().is_none() => {
            Some("has no meaning here: these torques conserve no energy")
        }
        Channel::MomentumDrift if problem.momentum_law().is_none() => {
            Some("has no meaning here: these torques leave no component of L with a known law")
        }
        Channel::Slip if !rolls(problem) => {
            Some("has no meaning here: only a body that turns without loads rolls on the invariable plane")
        }
        Channel::Tilt if FigureAxis::of(problem).is_none() => Some(
            "has no meaning here: the body has no axis of symmetry that leans from L, from the vertical, from a field or in an orbit",
        ),
        Channel::PrecessionRate if !precesses(problem) => {
            Some("has no meaning here: the body has no axis of symmetry that goes round L, the vertical or a field")
        }
        Channel::FigureAngles | Channel::FigureRates if FigureFrame::of(problem).is_none() => Some(
            "has no meaning here: the body neither turns without loads about an axis that L goes round, nor is it a top of \
             two equal moments under one steady force",
        ),
        Channel::MomentumTilt if Encircled::of(problem).is_none() => Some(
            "has no meaning here: L goes round no principal axis of a body that stands still, has three equal moments or \
             starts on the separatrix",
        ),
        Channel::PolhodePhase if !goes_round(problem) => Some(
            "has no meaning here: only a body that nothing acts on, and whose angular velocity moves in it but not along \
             the separatrix, goes round its polhode",
        ),
        Channel::SeparatrixDistance if !has_separatrix(problem) => {
            Some("has no meaning here: only a body of three different moments that turns has a separatrix")
        }
        Channel::JacobiIntegral if problem.jacobi_integral(0.0, &problem.initial).is_none() => {
            Some("has no meaning here: one gravity gradient must act, all the time")
        }
        Channel::KovalevskayaIntegral if Kovalevskaya::of(problem).is_none() => Some(
            "has no meaning here: it is of a top whose moments are as 2 to 2 to 1, under one force constant in the world, \
             all the time, at an arm across the axis of the least moment",
        ),
        Channel::Gyroscope | Channel::Accelerometer => {
            Some("is read by an IMU: give the body an [[body.imu]], which names its place")
        }
        _ => None,
    }
}

/// Whether the body has an axis that goes round something that stands still.
fn precesses(problem: &Problem) -> bool {
    FigureAxis::of(problem).is_some_and(|figure| figure.precesses())
}

/// Whether ω goes round an axis in the body, for ever the same way.
fn goes_round(problem: &Problem) -> bool {
    let omega = problem.initial.angular_velocity.in_body();
    problem.loads.is_empty() && Encircled::of(problem).is_some_and(|encircled| encircled.goes_round(&omega))
}

/// Whether the least, the middle and the greatest moment differ, and there is a spin to compare.
fn has_separatrix(problem: &Problem) -> bool {
    let [a, b, c]: [f64; 3] = problem.moments.vector().into();
    a != b && b != c && c != a && problem.initial.angular_velocity.in_body() != nalgebra::Vector3::zeros()
}

/// Whether Poinsot's construction describes the motion.
fn rolls(problem: &Problem) -> bool {
    problem.loads.is_empty() && problem.initial.angular_velocity.in_body().norm() > 0.0
}

const fn has_potential(torque: &Torque) -> bool {
    matches!(torque, Torque::ForceWorld { .. } | Torque::MagneticDipole { .. } | Torque::GravityGradient { .. })
}

fn interesting(problem: &Problem, moves: bool) -> Vec<Channel> {
    let has_potential =
        problem.loads.iter().any(|load| has_potential(&load.torque)) || moves && problem.gravity.norm() > 0.0;
    let conserves = problem.energy_law().is_some();
    let has_moment = problem.loads.iter().any(|load| match load.torque {
        Torque::ForceBody { arm, .. }
        | Torque::ForceWorld { arm, .. }
        | Torque::ForceProfileBody { arm, .. }
        | Torque::ForceProfileWorld { arm, .. } => arm.norm() > 0.0,
        Torque::Rotor { .. } => false,
        _ => true,
    });
    let is_interesting = |channel: &Channel| match channel {
        Channel::Attitude | Channel::AngularVelocity | Channel::AngularMomentumWorld | Channel::RotationalEnergy => {
            true
        }
        Channel::MomentBody => has_moment,
        Channel::Position | Channel::Velocity | Channel::ForceWorld | Channel::TranslationalEnergy => moves,
        Channel::PotentialEnergy | Channel::TotalEnergy => has_potential && conserves,
        Channel::EnergyDrift => conserves,
        Channel::MomentumDrift => problem.momentum_law().is_some(),
        Channel::Slip => rolls(problem),
        Channel::Tilt => FigureAxis::of(problem).is_some(),
        Channel::PrecessionRate => precesses(problem),
        _ => false,
    };
    Channel::ALL.into_iter().filter(is_interesting).collect()
}
