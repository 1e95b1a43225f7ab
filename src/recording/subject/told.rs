use super::{Sampling, facts};
use crate::recording::picture::Picture;
use crate::recording::{Heading, RecordedBody};
use crate::scenario::{Plan, Watched};

/// What a recording is of. A run makes it from its plan, a [`Conversion`](crate::recording::Conversion) from what the
/// recording that it reads says of itself.
#[derive(Debug, Clone)]
pub struct Subject<'a> {
    /// Name of the scene, or of the file that the samples come from.
    pub name: String,
    /// One line: what this is.
    pub title: String,
    /// Bodies, provenance, scene text.
    pub heading: Heading,
    /// How many samples, and when.
    pub sampling: Sampling,
    /// All that tells this recording from others, in words: those of equal identity hold the same samples.
    pub identity: String,
    /// What can be drawn: only where the scene is known. Without it a recording holds columns and words.
    pub drawing: Option<(&'a Plan, &'a Picture)>,
    /// Whether it is to be small rather than fast to write and good to look at: an `.rrd` without layout and colours, its
    /// chunks compressed.
    pub is_compact: bool,
}

impl<'a> Subject<'a> {
    /// Of the run of `plan`, without a picture.
    #[must_use]
    pub fn of(plan: &Plan) -> Self {
        let provenance: Vec<_> = facts::of_plan(plan).into_iter().collect();
        let scene = (!plan.text.is_empty()).then(|| plan.text.clone());
        let heading = Heading { bodies: bodies(plan, &provenance), provenance, scene };
        Self {
            name: plan.name.clone(),
            title: plan.title.clone(),
            heading,
            sampling: Sampling::of(&plan.grid),
            identity: plan.identity.clone(),
            drawing: None,
            is_compact: false,
        }
    }

    /// Of the run of `plan`, as small as can be: columns and words, and nothing to look at.
    #[must_use]
    pub fn compact(plan: &Plan) -> Self {
        // Recordings of equal identity are one to a viewer.
        Self { is_compact: true, identity: format!("{}\ncompact", plan.identity), ..Self::of(plan) }
    }

    /// Of the run of `plan`, drawn as `picture` says.
    #[must_use]
    pub fn drawn(plan: &'a Plan, picture: &'a Picture) -> Self {
        Self { drawing: Some((plan, picture)), ..Self::of(plan) }
    }
}

/// The plan's bodies and the points of them, as far as recordings tell of them.
pub fn bodies(plan: &Plan, provenance: &[(String, String)]) -> Vec<RecordedBody> {
    let body = |watched: Watched| RecordedBody {
        name: watched.name().to_owned(),
        channels: watched.channels().to_vec(),
        certificate: facts::certificate(provenance, watched.name()),
    };
    plan.watched().map(body).collect()
}
