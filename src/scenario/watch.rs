use nalgebra::UnitQuaternion;

use super::{PlannedBody, Watched};
use crate::dynamics::Problem;
use crate::propagation::PropagationError;
use crate::telemetry::{BodySamples, Channel, Derivation, Point};

impl PlannedBody {
    /// The same body with other channels watched, and nothing propagated that they do not need.
    #[must_use]
    pub fn watching(mut self, channels: &[Channel]) -> Self {
        let is_free = self.problem.loads.is_empty();
        let of_points = || self.points.iter().flat_map(|point| &point.channels);
        self.problem.wants_attitude = channels.iter().any(|channel| needs_attitude(&self.problem, *channel))
            || self.points.iter().any(Point::needs_attitude);
        self.problem.wants_translation =
            wants_translation(&self.problem, self.moves, channels.iter().chain(of_points()));
        self.channels = channels.to_vec();
        let mut skipped = Vec::new();
        let mut skip = |condition: bool, what: &str| {
            if condition {
                skipped.push(what.to_owned());
            }
        };
        skip(!self.problem.wants_attitude, "attitude: no channel needs it");
        skip(!self.moves, "translation: nothing moves the reference point");
        skip(self.moves && !self.problem.wants_translation, "translation: no channel needs it");
        skip(is_free, "torques: none acts");
        let is_aligned = self.properties.body_from_principal == UnitQuaternion::identity();
        skip(is_aligned, "turning back from principal axes: they are the body axes");
        let absent: Vec<_> = Channel::ALL.into_iter().filter(|channel| !channels.contains(channel)).collect();
        let names: Vec<_> = absent.iter().map(|channel| channel.row().name).collect();
        skip(!absent.is_empty(), &format!("channels: {}", names.join(", ")));
        self.skipped = skipped;
        self
    }

    /// What `channels` read at `times` (ascending, s), propagated afresh from t = 0.
    ///
    /// # Errors
    /// If the state ceases to be finite or a step cannot be made small enough.
    pub fn sample(&self, channels: &[Channel], times: &[f64]) -> Result<BodySamples, PropagationError> {
        Watched::from(self).sample(channels, times)
    }

    /// What makes its channels of its states.
    #[must_use]
    pub fn derivation(&self) -> Derivation {
        let derivation = Derivation::new(&self.problem, self.properties.body_from_principal);
        if self.is_pivoted { derivation.held() } else { derivation }
    }
}

fn needs_attitude(problem: &Problem, channel: Channel) -> bool {
    match channel {
        Channel::AngularVelocity
        | Channel::AngularMomentumBody
        | Channel::RotationalEnergy
        | Channel::TranslationalEnergy
        | Channel::KineticEnergy
        | Channel::Position
        | Channel::Velocity
        | Channel::Gyroscope
        // They look at ω in the body, and at no direction.
        | Channel::MomentumTilt
        | Channel::PolhodePhase
        | Channel::SeparatrixDistance => false,
        // They look at the attitude only through the loads.
        Channel::TotalEnergy
        | Channel::EnergyDrift
        | Channel::PotentialEnergy
        | Channel::MomentBody
        | Channel::ForceWorld
        | Channel::Acceleration
        // Of a body that nothing acts on, the direction of L in the body is that of Iω.
        | Channel::Tilt
        | Channel::PrecessionRate
        | Channel::FigureRates => !problem.loads.is_empty(),
        Channel::Attitude
        | Channel::AngularVelocityWorld
        | Channel::AngularMomentumWorld
        | Channel::MomentWorld
        | Channel::MomentumDrift
        | Channel::Slip
        | Channel::EulerZxz
        | Channel::EulerZyz
        | Channel::EulerZyx
        | Channel::EulerXyz
        | Channel::FigureAngles
        | Channel::JacobiIntegral
        | Channel::KovalevskayaIntegral
        | Channel::PositionBody
        | Channel::VelocityBody
        | Channel::AccelerationBody
        | Channel::Accelerometer => true,
    }
}

/// Whether position and velocity are propagated, for the sake of these channels or of the loads.
pub fn wants_translation<'a>(problem: &Problem, moves: bool, mut channels: impl Iterator<Item = &'a Channel>) -> bool {
    moves && (problem.looks_at_translation() || channels.any(|channel| needs_translation(*channel)))
}

const fn needs_translation(channel: Channel) -> bool {
    matches!(
        channel,
        Channel::Position
            | Channel::Velocity
            | Channel::PositionBody
            | Channel::VelocityBody
            | Channel::TranslationalEnergy
            | Channel::KineticEnergy
            | Channel::PotentialEnergy
            | Channel::TotalEnergy
            | Channel::EnergyDrift
    )
}
