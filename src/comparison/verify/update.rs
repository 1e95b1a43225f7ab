use nalgebra::Vector3;

use super::series::{Series, rms};

/// How an engine makes an attitude of the one before: the formula that holds to rounding from sample to sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Update {
    /// Which rotation.
    pub rotation: Rotation,
    /// By which ω.
    pub rate: Rate,
}

/// The rotation made of h ω.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rotation {
    /// exp(h ω): by the angle |ω| h.
    Exponential,
    /// q + h q̇, normalised: by 2 arctan(|ω| h/2).
    NormalisedQuaternion,
    /// R + h Ṙ, orthogonalised: by arctan(|ω| h).
    OrthogonalisedMatrix,
}

/// The ω in it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rate {
    /// Of the sample before: explicit.
    Before,
    /// Of the sample after: semi-implicit.
    After,
    /// Their mean.
    Mean,
}

/// Doubts within which a formula holds.
const HOLDS: f64 = 16.0;

impl Update {
    /// The one that holds for the turns kept, if one does where they can be told apart.
    pub(super) fn of(series: &Series, recorded: &[Vector3<f64>], kept: &[usize]) -> Option<Self> {
        let turn = rms(recorded.iter().map(Vector3::norm));
        let doubt = 2.0 * series.attitude_doubt + series.omega_doubt * turn / series.rate().max(f64::MIN_POSITIVE);
        // Three orders beyond the first are told apart only where they are not lost in rounding; and of a steady spin
        // every formula by the angle holds.
        let misses = |update: &Self| rms(kept.iter().map(|k| (update.turn(series, *k) - recorded[*k]).norm()));
        let mut all: Vec<(Self, f64)> = Self::all().map(|update| (update, misses(&update))).collect();
        all.sort_by(|one, other| one.1.total_cmp(&other.1));
        let [(best, miss), (_, next), ..] = all.as_slice() else { return None };
        (*miss <= HOLDS * doubt && *next > 3.0 * HOLDS * doubt).then_some(*best)
    }

    fn all() -> impl Iterator<Item = Self> {
        let rotations = [Rotation::Exponential, Rotation::NormalisedQuaternion, Rotation::OrthogonalisedMatrix];
        let rates = [Rate::Before, Rate::After, Rate::Mean];
        rotations.into_iter().flat_map(move |rotation| rates.into_iter().map(move |rate| Self { rotation, rate }))
    }

    fn turn(self, series: &Series, k: usize) -> Vector3<f64> {
        let step = series.times[k + 1] - series.times[k];
        let (before, after) = (series.omega[k], series.omega[k + 1]);
        let turn = step
            * match self.rate {
                Rate::Before => before,
                Rate::After => after,
                Rate::Mean => 0.5 * (before + after),
            };
        let angle = turn.norm();
        if angle == 0.0 {
            return turn;
        }
        let made = match self.rotation {
            Rotation::Exponential => angle,
            Rotation::NormalisedQuaternion => 2.0 * libm::atan(0.5 * angle),
            Rotation::OrthogonalisedMatrix => libm::atan(angle),
        };
        turn * (made / angle)
    }

    /// As an engine's author would say it.
    #[must_use]
    pub fn words(self) -> String {
        let rate = match self.rate {
            Rate::Before => "ω before the step",
            Rate::After => "ω after the step",
            Rate::Mean => "the mean of ω before and after the step",
        };
        let rotation = match self.rotation {
            Rotation::Exponential => "the rotation exp(h ω)",
            Rotation::NormalisedQuaternion => "q + h q̇, normalised",
            Rotation::OrthogonalisedMatrix => "R + h Ṙ, orthogonalised",
        };
        format!("{rotation}, with {rate}")
    }

    /// Whether it turns by another angle than |ω| h.
    #[must_use]
    pub fn is_first_order(self) -> bool {
        self.rotation != Rotation::Exponential
    }
}
