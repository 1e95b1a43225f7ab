use std::borrow::Cow;
use std::path::Path;

use super::Shapes;
use crate::recording::{Heading, Recording, RecordingError, Subject, carried_scene};
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

    /// The scene, or that which a recording carries, if it does and it can be planned.
    pub(super) fn plan(&self) -> Option<Cow<'_, Plan>> {
        match self {
            Self::Scene(plan) => Some(Cow::Borrowed(plan)),
            Self::Recording { name, recording } => {
                let heading = recording.heading();
                let folder = Path::new(name).parent().unwrap_or(Path::new(""));
                let scene = heading.fact("scene").unwrap_or("scene");
                carried_scene(heading.scene.as_deref()?, scene, folder).ok().map(Cow::Owned)
            }
        }
    }

    /// What its bodies look like: of a recording, if it carries a scene that can be planned.
    #[must_use]
    pub fn shapes(&self) -> Shapes {
        self.plan().as_deref().map(Shapes::of).unwrap_or_default()
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
