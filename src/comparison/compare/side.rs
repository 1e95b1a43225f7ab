use std::path::Path;

use crate::recording::{Heading, Recording, RecordingError, Subject};
use crate::scenario::Plan;

/// One of the two motions that are compared.
#[derive(Debug)]
pub enum Side<'a> {
    /// What was recorded.
    Recording {
        /// As reports call it.
        name: String,
        /// Not read from yet.
        recording: Box<Recording>,
    },
    /// What a scene gives, computed at whatever times the other side has.
    Scene(&'a Plan),
}

impl Side<'_> {
    /// The recording at `path`, called by it.
    ///
    /// # Errors
    /// As [`Recording::open`].
    pub fn open(path: &Path) -> Result<Self, RecordingError> {
        Ok(Self::Recording { name: path.display().to_string(), recording: Box::new(Recording::open(path)?) })
    }

    /// As reports call it: the path, or the name of the scene.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Recording { name, .. } => name,
            Self::Scene(plan) => &plan.name,
        }
    }

    /// Bodies, channels, provenance; of a scene, what its recording would say.
    #[must_use]
    pub fn heading(&self) -> Heading {
        match self {
            Self::Recording { recording, .. } => recording.heading().clone(),
            Self::Scene(plan) => Subject::of(plan).heading,
        }
    }
}
