use super::{forced, free};
use crate::scenario::{BodySpec, Scenario};

/// A motion that some method breaks on, as a scene: what is refused is refused as a user's scene is.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Its name, unique.
    pub key: &'static str,
    /// What it is one of, in a word or two.
    pub group: &'static str,
    /// What is hard about it.
    pub title: &'static str,
    /// From which depth on it is run.
    pub depth: Depth,
    /// Steps to a turn of methods with a fixed step, where only one number is tried, and for as many steps as it takes.
    pub pace: Option<u32>,
    /// The motion: one body.
    pub scenario: Scenario,
}

/// How much is run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Depth {
    /// Some eight turns, two steps: seconds.
    Quick,
    /// Up to 1e9 s or 1e8 steps, many steps and tolerances: many minutes.
    Full,
}

/// Parts of a case's span, at whose ends states are compared.
const PARTS: u32 = 128;

/// Every case, from free bodies to forced ones, quick ones before long ones within each.
#[must_use]
pub fn cases() -> Vec<Case> {
    let mut cases = free::cases();
    cases.extend(forced::cases());
    cases
}

impl Case {
    /// One body for `span` s.
    pub(super) fn new(key: &'static str, title: &'static str, span: f64, body: BodySpec) -> Self {
        let scenario = Scenario {
            name: key.to_owned(),
            title: title.to_owned(),
            duration_s: Some(span),
            sample_every_s: Some(span / f64::from(PARTS)),
            body: vec![body],
            ..Scenario::default()
        };
        Self { key, group: "", title, depth: Depth::Quick, pace: None, scenario }
    }

    /// These as one group.
    pub(super) fn grouped(group: &'static str, cases: Vec<Self>) -> impl Iterator<Item = Self> {
        cases.into_iter().map(move |case| Self { group, ..case })
    }

    /// The same for the full depth only.
    pub(super) fn long(self) -> Self {
        Self { depth: Depth::Full, ..self }
    }

    /// The same at one number of steps to a turn.
    pub(super) fn paced(self, pace: u32) -> Self {
        Self { pace: Some(pace), ..self }
    }
}

/// A body by its principal moments, kg m², with its first rates, rad/s.
pub(super) fn body(moments: [f64; 3], rates: [f64; 3]) -> BodySpec {
    BodySpec {
        mass_kg: Some(1.0),
        principal_moments_kg_m2: Some(moments),
        angular_velocity_rad_s: Some(rates),
        attitude: Some([0.5, 0.5, -0.5, 0.5]),
        ..BodySpec::default()
    }
}
