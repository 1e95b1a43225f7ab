use std::fmt;

use super::locate::locate;
use super::{Refused, Scenario, ScenarioError};

/// Path of a key in a scene: `body[0].torque.constant_body[1].moment_n_m`.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Key(Vec<Segment>);

/// One step of a [`Key`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Segment {
    /// Into a table.
    Field(&'static str),
    /// Into an array.
    Index(usize),
}

impl Key {
    /// A key of the whole scene.
    #[must_use]
    pub fn root(field: &'static str) -> Self {
        Self::default().field(field)
    }

    /// A key of the table that this leads to.
    #[must_use]
    pub fn field(&self, field: &'static str) -> Self {
        Self(self.0.iter().cloned().chain([Segment::Field(field)]).collect())
    }

    /// An element of the array that this leads to.
    #[must_use]
    pub fn index(&self, index: usize) -> Self {
        Self(self.0.iter().cloned().chain([Segment::Index(index)]).collect())
    }

    /// The steps from the root.
    #[must_use]
    pub fn segments(&self) -> &[Segment] {
        &self.0
    }

    /// The refusal of what stands at this key.
    pub fn refuse(&self, message: impl fmt::Display) -> Refusal {
        Refusal { key: self.clone(), message: message.to_string() }
    }
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (position, segment) in self.0.iter().enumerate() {
            match segment {
                Segment::Field(field) if position == 0 => write!(f, "{field}")?,
                Segment::Field(field) => write!(f, ".{field}")?,
                Segment::Index(index) => write!(f, "[{index}]")?,
            }
        }
        Ok(())
    }
}

/// A key that breaks a rule, not yet located in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    key: Key,
    message: String,
}

impl Refusal {
    /// As an error about `scenario`, with the line where its text is at hand.
    #[must_use]
    pub fn locate(self, scenario: &Scenario) -> ScenarioError {
        ScenarioError::Refused(Box::new(Refused {
            file: scenario.file.clone(),
            key: self.key.to_string(),
            message: self.message,
            excerpt: locate(&scenario.text, &self.key),
        }))
    }
}
