//! What a schema can say of a scene beside its keys: which keys exclude or need each other.

use schemars::{Schema, SchemaGenerator, json_schema};
use serde_json::{Value, json};

use crate::scenario::{Method, Setting};
use crate::telemetry::Channel;

/// Sample times in one of two ways; each method with what it takes; one body at least, and names where there are more.
pub fn scene(schema: &mut Schema) {
    let keys =
        |takes: fn(Method) -> bool| Method::ALL.into_iter().filter(|m| takes(*m)).map(Method::key).collect::<Vec<_>>();
    let stepped = by(&keys(|method| method.setting() == Setting::Step));
    let without_tolerance = by(&keys(|method| method.setting() == Setting::Step || method == Method::ClosedForm));
    let sampling = one_of(&[json!(["sample_every_s", "duration_s"]), json!(["sample_times_s"])]);
    let steps = json!({ "if": stepped, "then": needs("step_s"), "else": { "not": needs("step_s") } });
    let tolerance = json!({ "if": without_tolerance, "then": { "not": needs("tolerance_rad") } });
    let several = json!({ "properties": { "body": { "minItems": 2 } } });
    let names = json!({ "if": several, "then": { "properties": { "body": { "items": needs("name") } } } });
    schema.insert("required".into(), json!(["body"]));
    schema.insert("allOf".into(), json!([sampling, steps, tolerance, names]));
}

/// A scene that names one of these methods.
fn by(methods: &[&str]) -> Value {
    json!({ "required": ["method"], "properties": { "method": { "enum": methods } } })
}

/// One source of inertia, and what goes with which.
pub fn body(schema: &mut Schema) {
    let typed = ["principal_moments_kg_m2", "inertia_kg_m2"].map(needs);
    let computed = [
        json!({ "required": ["particle"], "properties": { "particle": { "minItems": 1 } } }),
        json!({ "required": ["solid"], "properties": { "solid": { "minProperties": 1 } } }),
        needs("mesh"),
    ];
    schema.insert("oneOf".into(), typed.iter().chain(&computed).cloned().collect());
    schema.insert("not".into(), json!({ "required": ["angular_velocity_rad_s", "angular_momentum_n_m_s"] }));
    let with_typed = json!({ "anyOf": typed });
    let without_pivot = json!({ "not": needs("pivot") });
    let dependencies = json!({
        "mass_kg": with_typed,
        "centre_of_mass_m": with_typed,
        "velocity_m_s": without_pivot,
    });
    schema.insert("dependencies".into(), dependencies);
}

/// A mass or a density.
pub fn solid(schema: &mut Schema) {
    schema.insert("oneOf".into(), json!([needs("mass_kg"), needs("density_kg_m3")]));
}

/// A file or rows.
pub fn table(schema: &mut Schema) {
    schema.insert("oneOf".into(), json!([needs("file"), needs("rows")]));
}

/// Listed pulses or a period with a duty.
pub fn thruster(schema: &mut Schema) {
    schema.insert("oneOf".into(), choices(&[json!(["pulses_s"]), json!(["period_s", "duty"])]));
}

/// A constant momentum or scheduled ones.
pub fn rotor(schema: &mut Schema) {
    schema.insert("oneOf".into(), choices(&[json!(["momentum_n_m_s"]), json!(["times_s", "momenta_n_m_s"])]));
}

/// Three lengths, or the like.
pub fn each_positive(schema: &mut Schema) {
    if let Some(items) = schema.get_mut("items").and_then(Value::as_object_mut) {
        items.insert("exclusiveMinimum".to_owned(), json!(0));
    }
}

/// The name of a channel.
pub fn channel(_: &mut SchemaGenerator) -> Schema {
    let names = Channel::ALL.map(|channel| channel.row().name).to_vec();
    json_schema!({ "type": "string", "enum": names })
}

/// Names of channels.
pub fn channels(generator: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "array", "items": channel(generator), "minItems": 1, "uniqueItems": true })
}

/// The name of a component of some channel.
pub fn component(_: &mut SchemaGenerator) -> Schema {
    let mut names = Vec::new();
    for name in Channel::ALL.iter().flat_map(|channel| channel.row().components) {
        if !name.is_empty() && !names.contains(name) {
            names.push(*name);
        }
    }
    json_schema!({ "type": "string", "enum": names })
}

fn needs(key: &str) -> Value {
    json!({ "required": [key] })
}

fn one_of(required: &[Value]) -> Value {
    json!({ "oneOf": choices(required) })
}

fn choices(required: &[Value]) -> Value {
    required.iter().map(|keys| json!({ "required": keys })).collect()
}
