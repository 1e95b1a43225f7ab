use super::cell::best;
use super::trial::{Ending, Trial};
use crate::scenario::Method;

/// How a method fares on a case; at its finest setting, where it has several.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Within its limit: as right as f64 and the motion allow, and as what was promised.
    Kept,
    /// It follows the motion, less exactly than f64 allows.
    Coarse,
    /// The motion itself magnifies single roundings to more than 0.1 rad, and nothing can be asked of it.
    Chaotic,
    /// It loses the motion, or ends with an error on the way.
    Lost,
    /// What it gave must never be given: beyond its promise, not finite without an error, not of unit length, or with a jump
    /// of the quaternion's sign. Of `auto`, an error on the way, too.
    Wrong,
    /// Refused before the run, with a reason.
    Refused,
    /// Not tried: it would take too many steps.
    TooLong,
    /// Run, perhaps, but there is nothing to measure it by.
    Unjudged,
}

impl Verdict {
    /// On runs of `method`, from coarse to fine.
    pub(super) fn of(method: Method, trials: &[Trial]) -> Self {
        if !trials.iter().all(Trial::is_sound) {
            return Self::Wrong;
        }
        let Some(finest) = best(trials) else { return Self::TooLong };
        let is_bound = matches!(method, Method::Auto | Method::ClosedForm);
        let is_done = finest.ending == Ending::Done;
        if finest.ending == Ending::TooLong {
            Self::TooLong
        } else if is_done && finest.limit_rad > Trial::LOST_RAD {
            Self::Chaotic
        } else if is_done && finest.error_rad <= finest.limit_rad {
            Self::Kept
        } else if is_bound {
            Self::Wrong
        } else if finest.follows() {
            Self::Coarse
        } else {
            Self::Lost
        }
    }
}
