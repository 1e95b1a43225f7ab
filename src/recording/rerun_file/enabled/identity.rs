use re_log_types::{ApplicationId, RecordingId, StoreId, StoreKind};
use sha2::{Digest as _, Sha256};
use uuid::Uuid;

use crate::recording::Subject;

/// The store of the samples.
///
/// # Errors
/// If Rerun refuses the name.
pub(super) fn recording(subject: &Subject) -> Result<StoreId, String> {
    Ok(StoreId::new(StoreKind::Recording, application(subject)?, RecordingId::from(hash(subject))))
}

/// The store of the layout.
///
/// # Errors
/// If Rerun refuses the name.
pub(super) fn blueprint(subject: &Subject) -> Result<StoreId, String> {
    Ok(StoreId::new(
        StoreKind::Blueprint,
        application(subject)?,
        RecordingId::from(format!("layout-{}", hash(subject))),
    ))
}

/// The viewer merges stores with equal ids, and leaves out chunks whose ids it has: so equal ids mean equal contents. A
/// hash of what identifies the subject, of its name, of this crate's version and of all that it says of itself.
fn hash(subject: &Subject) -> String {
    let mut hash = Sha256::new();
    let facts = subject.heading.provenance.iter().flat_map(|(name, value)| [name.as_str(), value.as_str()]);
    let known = [env!("CARGO_PKG_VERSION"), subject.name.as_str(), subject.identity.as_str()];
    for part in known.into_iter().chain(facts) {
        hash.update(part.as_bytes());
        hash.update([0]);
    }
    let hash: [u8; 32] = hash.finalize().into();
    let id = hash.iter().take(16).fold(0_u128, |id, byte| id << 8 | u128::from(*byte));
    format!("{id:032x}")
}

/// One per scene: the viewer keeps one layout per application, and layouts name the scene's bodies.
fn application(subject: &Subject) -> Result<ApplicationId, String> {
    ApplicationId::try_new(format!("polhode-{}", subject.name)).map_err(|error| error.to_string())
}

/// The id of the layout's part `number`. Constant, so that the same layout has the same bytes.
pub(super) fn part(number: u64) -> Uuid {
    const POLHODE: u128 = 0x706f_6c68_6f64_4065_8000_0000_0000_0000;
    Uuid::from_u128(POLHODE | u128::from(number))
}
