use super::{Candidates, Clock, Distance, Finding, InertiaFit, Kinematics, Laws, Length, Montgomery};

/// How a file's rotation stands to physics.
#[derive(Debug, Clone, PartialEq)]
pub struct Verification {
    /// The body, as the file names it.
    pub name: String,
    /// The outcome.
    pub verdict: Verdict,
    /// Why that: one line each.
    pub reasons: Vec<String>,
    /// What is likely wrong, the likeliest first; empty where nothing is.
    pub causes: Vec<Finding>,
    /// What explains the errors of ω that there are, where they stay within the tolerance.
    pub habits: Vec<Finding>,
    /// What is odd and no fault.
    pub remarks: Vec<String>,
    /// How far an attitude may be from the exact motion, rad.
    pub tolerance_rad: f64,
    /// When samples were taken.
    pub clock: Clock,
    /// |q|; where there are attitudes.
    pub length: Option<Length>,
    /// What the columns mean.
    pub candidates: Candidates,
    /// Whether attitudes turn as ω says; where there are both, near enough in time.
    pub kinematics: Option<Kinematics>,
    /// What the motion itself says of the body, unless something is known to act on it.
    pub inertia: Option<InertiaFit>,
    /// Whether ω, L and E obey the torques; where a body is given.
    pub laws: Option<Laws>,
    /// The turn about L in each period; of free motion with attitudes.
    pub montgomery: Option<Montgomery>,
    /// How far from the exact motion; where a body and attitudes are given.
    pub distance: Option<Distance>,
}

/// What came out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// What can be checked is right, within the tolerance.
    Clean,
    /// The motion is not what it should be.
    Wrong,
    /// Too little is known to say.
    CannotTell,
}

impl Verdict {
    /// A name for scripts.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Clean => "clean",
            Self::Wrong => "wrong",
            Self::CannotTell => "cannot_tell",
        }
    }
}
