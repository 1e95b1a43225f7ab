use serde_json::{Map, Value, json};

use super::unit::unit;

/// Makes a derived schema one of TOML: there is no null, and no `double` or `uint16`; keys have units, and a default that
/// is told in words (``left out: `1` ``) is one that programs can read.
pub fn finish(value: &mut Value) {
    match value {
        Value::Object(schema) => {
            without_null(schema);
            // A key may be called so, too: that is no text.
            if schema.get("format").is_some_and(Value::is_string) {
                schema.remove("format");
            }
            if let Some(Value::Object(properties)) = schema.get_mut("properties") {
                for (name, property) in properties {
                    annotate(name, property);
                }
            }
            for part in schema.values_mut() {
                finish(part);
            }
            apart(schema);
        }
        Value::Array(parts) => parts.iter_mut().for_each(finish),
        _ => {}
    }
}

/// What may be left out is left out, and never null.
fn without_null(schema: &mut Map<String, Value>) {
    if let Some(Value::Array(types)) = schema.get_mut("type") {
        types.retain(|name| name != "null");
        if let [only] = types.as_slice() {
            let only = only.clone();
            schema.insert("type".to_owned(), only);
        }
    }
    if let Some(Value::Array(names)) = schema.get_mut("enum") {
        names.retain(|name| !name.is_null());
    }
    if let Some(Value::Array(choices)) = schema.get_mut("anyOf") {
        choices.retain(|choice| choice.get("type") != Some(&json!("null")));
        if let [Value::Object(only)] = choices.as_mut_slice() {
            let only = std::mem::take(only);
            schema.remove("anyOf");
            schema.extend(only);
        }
    }
}

/// Unit and default of a key.
fn annotate(name: &str, property: &mut Value) {
    let Some(property) = property.as_object_mut() else { return };
    if let Some(unit) = unit(name) {
        property.insert("x-unit".to_owned(), unit.into());
    }
    let default = property.get("description").and_then(Value::as_str).and_then(default_in_words);
    if let Some(default) = default {
        property.insert("default".to_owned(), default);
    }
}

/// The value in ``…; left out: `value`.``
fn default_in_words(description: &str) -> Option<Value> {
    let (_, told) = description.rsplit_once("left out: `")?;
    let word = told.strip_suffix("`.")?;
    Some(serde_json::from_str(word).unwrap_or_else(|_| word.into()))
}

/// Draft 7 ignores what stands beside a reference.
fn apart(schema: &mut Map<String, Value>) {
    if schema.len() > 1
        && let Some(reference) = schema.remove("$ref")
    {
        schema.insert("allOf".to_owned(), json!([{ "$ref": reference }]));
    }
}
