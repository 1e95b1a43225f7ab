use std::path::{Component, Path};

use crate::scenario::{BodySpec, Plan, Scenario};

/// The plan of the scene in `text`, whose meshes and tables are in `folder` or below. Recordings are not trusted: one that names
/// files elsewhere is refused.
pub fn plan(text: &str, name: &str, folder: &Path) -> Result<Plan, String> {
    let scenario = Scenario::parse(text, &format!("{name}.toml"), &[]).map_err(|error| error.to_string())?;
    let is_below = |file: &Path| file.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
    for (kind, file) in scenario.body.iter().flat_map(BodySpec::files) {
        if !is_below(file) {
            let file = file.display();
            return Err(format!("its {kind} {file} is not beside the recording: --scene names a scene with its files"));
        }
    }
    let scenario = Scenario { name: name.into(), folder: folder.into(), ..scenario };
    Plan::new(&scenario).map_err(|error| error.to_string())
}
