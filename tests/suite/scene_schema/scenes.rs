//! Scenes to hold against the schema, and a validator that fetches nothing.

use std::fs;
use std::path::{Path, PathBuf};

use boon::{Compiler, SchemaIndex, Schemas};
use polhode::scenario::schema;
use serde_json::Value;

/// A validator of scenes.
pub struct Validator {
    schemas: Schemas,
    index: SchemaIndex,
}

impl Validator {
    pub fn new() -> Self {
        let mut schemas = Schemas::new();
        let mut compiler = Compiler::new();
        let value = serde_json::from_str(&schema()).expect("the schema is JSON");
        compiler.add_resource("file:///scene.schema.json", value).expect("a schema");
        let index = compiler.compile("file:///scene.schema.json", &mut schemas).expect("a sound schema of draft 7");
        Self { schemas, index }
    }

    /// Why `scene` is refused.
    pub fn refusal(&self, scene: &Value) -> Option<String> {
        self.schemas.validate(scene, self.index).err().map(|error| format!("{error:#}"))
    }
}

/// Name and text of every scene of the repository that is run somewhere: those of the program, templates, examples.
pub fn sound() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let manual = fs::read_to_string(root.join("docs/scenarios.md")).expect("the manual of scenes");
    let examples = manual.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next());
    let examples = examples.enumerate().map(|(n, text)| (format!("example {n} of docs/scenarios.md"), text.to_owned()));
    let files = ["scenarios", "src/cli/templates"].into_iter().flat_map(|folder| files(&root.join(folder)));
    files.chain(examples).collect()
}

/// Name and text of every scene that breaks a rule.
pub fn bad() -> Vec<(String, String)> {
    files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad"))
}

fn files(folder: &Path) -> Vec<(String, String)> {
    let entries = fs::read_dir(folder).expect("a folder of scenes");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    paths.sort();
    let text = |path: &Path| fs::read_to_string(path).expect("a scene");
    paths.iter().map(|path| (path.file_name().unwrap_or_default().to_string_lossy().into_owned(), text(path))).collect()
}

/// A scene's text as TOML.
pub fn parsed(text: &str) -> Option<toml::Value> {
    toml::from_str::<toml::Table>(text).ok().map(toml::Value::Table)
}

/// The same as JSON. (Serde would hand numbers of any precision through as tables.)
pub fn as_json(value: &toml::Value) -> Value {
    match value {
        toml::Value::String(text) => text.as_str().into(),
        toml::Value::Integer(number) => (*number).into(),
        toml::Value::Float(number) => (*number).into(),
        toml::Value::Boolean(is_so) => (*is_so).into(),
        toml::Value::Datetime(time) => time.to_string().into(),
        toml::Value::Array(elements) => elements.iter().map(as_json).collect(),
        toml::Value::Table(table) => table.iter().map(|(key, value)| (key.clone(), as_json(value))).collect(),
    }
}

/// The way to everything in a scene, the scene itself first.
pub fn places(value: &toml::Value) -> Vec<Vec<String>> {
    let inner: Vec<(String, &toml::Value)> = match value {
        toml::Value::Table(table) => table.iter().map(|(key, value)| (key.clone(), value)).collect(),
        toml::Value::Array(elements) => elements.iter().enumerate().map(|(n, value)| (n.to_string(), value)).collect(),
        _ => Vec::new(),
    };
    let deeper = inner.into_iter().flat_map(|(step, value)| {
        places(value).into_iter().map(move |way| [step.clone()].into_iter().chain(way).collect())
    });
    [Vec::new()].into_iter().chain(deeper).collect()
}

/// What stands there.
pub fn at<'value>(value: &'value mut toml::Value, place: &[String]) -> &'value mut toml::Value {
    place.iter().fold(value, |value, step| match step.parse::<usize>() {
        Ok(index) => &mut value[index],
        Err(_) => &mut value[step.as_str()],
    })
}
