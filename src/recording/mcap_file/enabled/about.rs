use std::borrow::Cow;

use mcap::Attachment;
use mcap::records::Metadata;

use crate::recording::{Interruption, Subject};

/// What made the recording, from what, how, and in which units and frames.
pub(super) fn metadata(subject: &Subject) -> Metadata {
    Metadata { name: "polhode".into(), metadata: subject.heading.provenance.iter().cloned().collect() }
}

/// That the run was stopped, and where.
pub(super) fn interruption(end: &Interruption) -> Metadata {
    Metadata { name: "polhode.interruption".into(), metadata: [("interrupted".to_owned(), end.in_words())].into() }
}

/// The scene as text, if it is known.
pub(super) fn scene_text<'a>(subject: &'a Subject) -> Option<Attachment<'a>> {
    let text = subject.heading.scene.as_ref()?;
    Some(Attachment {
        log_time: 0,
        create_time: 0,
        name: format!("{}.toml", subject.name),
        media_type: "application/toml".into(),
        data: Cow::Borrowed(text.as_bytes()),
    })
}
