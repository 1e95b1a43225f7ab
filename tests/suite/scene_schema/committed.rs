use std::fs;
use std::path::Path;

use polhode::scenario::schema;

/// Editors read the file. `POLHODE_BLESS=1 cargo test scene_schema` writes it anew.
#[test]
fn the_committed_schema_is_the_one_that_is_printed() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios/scene.schema.json");
    if std::env::var_os("POLHODE_BLESS").is_some() {
        fs::write(&path, schema()).expect("the schema can be written");
    }
    let committed = fs::read_to_string(&path).unwrap_or_default();
    assert!(committed == schema(), "{} is out of date: POLHODE_BLESS=1 cargo test scene_schema", path.display());
}
