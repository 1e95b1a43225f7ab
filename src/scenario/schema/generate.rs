use schemars::generate::SchemaSettings;

use super::finish;
use crate::scenario::Scenario;

/// The JSON Schema of scenes (draft 7, which editors of TOML understand), as indented text.
///
/// Keys, types, ranges and defaults are those of the structs that scenes are read into; `x-unit` names a key's unit. What
/// it accepts may still break a rule that a schema cannot state: [`Plan::new`](crate::scenario::Plan::new) knows them all.
#[must_use]
pub fn schema() -> String {
    let schema = SchemaSettings::draft07().into_generator().into_root_schema_for::<Scenario>();
    let mut value = schema.to_value();
    finish::finish(&mut value);
    format!("{value:#}\n")
}
