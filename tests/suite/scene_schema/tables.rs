//! The tables of a scene, as the schema has them.

use std::collections::BTreeSet;

use polhode::scenario::{Scenario, schema};
use serde_json::Value;

/// One table of the file, or each of an array of them.
#[derive(Debug, Clone)]
pub struct Table {
    /// `body.torque.constant_body`; empty for the scene itself.
    pub path: String,
    /// For each part of the path, whether it is an array of tables.
    is_list: Vec<bool>,
    /// In the order in which the parser knows them.
    pub keys: Vec<Key>,
}

/// One key of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Key {
    pub name: String,
    /// With what it refers to filled in.
    pub schema: Value,
    /// Whether it must be there.
    pub is_needed: bool,
}

impl Key {
    pub fn description(&self) -> &str {
        self.schema["description"].as_str().unwrap_or_default()
    }

    /// The schema of the table or tables that it holds, if it does.
    pub fn table(&self) -> Option<(&Value, bool)> {
        let is_list = self.schema["type"] == "array";
        let inner = if is_list { &self.schema["items"] } else { &self.schema };
        inner["properties"].is_object().then_some((inner, is_list))
    }
}

impl Table {
    /// All of them: the scene, then what is in it.
    pub fn all() -> Vec<Self> {
        let root: Value = serde_json::from_str(&schema()).expect("the schema is JSON");
        let mut found = Vec::new();
        collect(&root, &resolved(&root, &root), &mut Vec::new(), &mut found);
        found
    }

    /// Whether its keys are kinds: arrays of tables, all of them.
    pub fn is_of_kinds(&self) -> bool {
        self.keys.iter().all(|key| matches!(key.table(), Some((_, true))))
    }

    /// The keys that the parser says there are, in its order.
    pub fn keys_of_parser(&self) -> Vec<String> {
        let parts: Vec<_> = self.path.split('.').filter(|part| !part.is_empty()).collect();
        let mut text = String::new();
        for (depth, is_list) in self.is_list.iter().enumerate() {
            let path = parts[..=depth].join(".");
            let (open, close) = if *is_list { ("[[", "]]\n") } else { ("[", "]\n") };
            text.extend([open, path.as_str(), close]);
        }
        // So far from every key that none is suggested.
        let error = Scenario::parse(&(text + "zzzzzzzzzzzz = 1\n"), "probe.toml", &[]).expect_err("no such key");
        let message = error.to_string();
        let (_, told) = message.split_once("no such key; here are ").expect("what there is");
        told.lines().next().unwrap_or_default().split('`').skip(1).step_by(2).map(str::to_owned).collect()
    }
}

fn collect(root: &Value, schema: &Value, path: &mut Vec<(String, bool)>, found: &mut Vec<Table>) {
    let needed: BTreeSet<&str> =
        schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    let properties = schema["properties"].as_object().expect("a table has keys");
    let keys = properties.iter().map(|(name, schema)| Key {
        name: name.clone(),
        schema: resolved(root, schema),
        is_needed: needed.contains(name.as_str()),
    });
    let mut table = Table {
        path: path.iter().map(|(part, _)| part.as_str()).collect::<Vec<_>>().join("."),
        is_list: path.iter().map(|(_, is_list)| *is_list).collect(),
        keys: keys.collect(),
    };
    let order = table.keys_of_parser();
    table.keys.sort_by_key(|key| order.iter().position(|name| *name == key.name));
    found.push(table.clone());
    for key in &table.keys {
        if let Some((inner, is_list)) = key.table() {
            path.push((key.name.clone(), is_list));
            collect(root, inner, path, found);
            path.pop();
        }
    }
}

/// `schema` with references filled in, of its items too; words of its own come before those of what it refers to.
fn resolved(root: &Value, schema: &Value) -> Value {
    let mut schema = schema.clone();
    let reference = schema["$ref"].as_str().or_else(|| schema["allOf"][0]["$ref"].as_str()).map(str::to_owned);
    if let Some(reference) = reference {
        let target = root.pointer(reference.trim_start_matches('#')).expect("what a reference points to");
        let mut filled = resolved(root, target);
        if let (Some(filled), Value::Object(own)) = (filled.as_object_mut(), schema) {
            filled.extend(own);
        }
        schema = filled;
    }
    if schema["items"].is_object() {
        schema["items"] = resolved(root, &schema["items"]);
    }
    schema
}
