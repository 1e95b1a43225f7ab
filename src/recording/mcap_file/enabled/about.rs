use std::borrow::Cow;
use std::collections::BTreeMap;

use mcap::Attachment;
use mcap::records::Metadata;
use sha2::{Digest, Sha256};

use crate::scenario::{Certificate, Plan};

/// Version of the layout: topics, schemas and what they mean. Adding to it does not change it.
const SCHEMA_VERSION: &str = "1";

/// What made the recording, from what, how, and in which units and frames.
pub(super) fn metadata(plan: &Plan) -> Metadata {
    let mut facts: BTreeMap<String, String> = [
        ("schema_version", SCHEMA_VERSION.into()),
        ("polhode_version", env!("CARGO_PKG_VERSION").into()),
        ("scene", plan.name.clone()),
        ("title", plan.title.clone()),
        ("scene_sha256", format!("{:x}", Sha256::digest(&plan.text))),
        ("samples", plan.grid.len().to_string()),
        ("units", "SI; drifts in parts per 1e15".into()),
        ("frames", "world: inertial, right-handed; body/<name>: fixed in the body at its reference point".into()),
        ("attitude", "unit quaternion, world from body".into()),
        ("time", "log time, publish time and timestamps: simulated time, ns; time_s: the same, exact".into()),
    ]
    .map(|(key, value): (&str, String)| (key.to_owned(), value))
    .into();
    for body in &plan.bodies {
        facts.insert(format!("body.{}.method", body.name), body.path.name().into());
        facts.insert(format!("body.{}.reason", body.name), body.reason.clone());
        for (name, value) in body.certificate.iter().flat_map(Certificate::facts) {
            facts.insert(format!("body.{}.certificate.{name}", body.name), value);
        }
    }
    Metadata { name: "polhode".into(), metadata: facts }
}

/// The scene as text, if the plan was made from one.
pub(super) fn scene_text(plan: &Plan) -> Option<Attachment<'_>> {
    (!plan.text.is_empty()).then(|| Attachment {
        log_time: 0,
        create_time: 0,
        name: format!("{}.toml", plan.name),
        media_type: "application/toml".into(),
        data: Cow::Borrowed(plan.text.as_bytes()),
    })
}
