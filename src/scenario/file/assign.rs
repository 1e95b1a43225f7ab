//! `key=value` carried out on a scene's text: whatever the file can say, it can say.

use toml_edit::{Array, ArrayOfTables, DocumentMut, InlineTable, Item, Table, Value};

const EXAMPLE: &str = "an override reads key=value, such as body.0.angular_velocity_rad_s=[0, 5, 0.01]";

/// Parts of a key at most: each is a call within the last.
const DEEPEST: usize = 20;

/// One step of a path.
#[derive(Clone, Copy)]
enum Step<'path> {
    /// Into a table.
    Field(&'path str),
    /// To an element of a list, or to the first of one that is not there yet.
    Index(usize),
    /// To a new element at the end of a list.
    Append,
}

/// `text` with `key=value` carried out; `value` is TOML, a bare word stands for a string.
pub fn assign(text: &str, assignment: &str) -> Result<String, String> {
    let (path, value) = assignment.split_once('=').ok_or(EXAMPLE)?;
    if path.matches('.').count() >= DEEPEST {
        return Err(format!("the key has more than {DEEPEST} parts: no key of a scene has"));
    }
    let steps = path.trim().split('.').map(step).collect::<Result<Vec<_>, _>>()?;
    let value = typed(value.trim())?;
    let mut document: DocumentMut = text.parse().map_err(|error: toml_edit::TomlError| error.message().to_owned())?;
    in_item(document.as_item_mut(), &steps, &mut Vec::new(), value)?;
    Ok(document.to_string())
}

fn step(word: &str) -> Result<Step<'_>, String> {
    if let Some((name, index)) = word.strip_suffix(']').and_then(|word| word.split_once('[')) {
        return Err(format!("{word:?}: elements are told by dots: {name}.{index}"));
    }
    Ok(match (word, word.parse()) {
        ("", _) => return Err(format!("a part of the key is empty: {EXAMPLE}")),
        ("+", _) => Step::Append,
        (_, Ok(index)) => Step::Index(index),
        (name, Err(_)) => Step::Field(name),
    })
}

/// The value in `word`. What begins as one must be one.
fn typed(word: &str) -> Result<Value, String> {
    match word.parse() {
        Ok(value) => Ok(value),
        Err(error) if word.starts_with(['[', '{', '"', '\'']) => {
            let error: toml_edit::TomlError = error;
            Err(format!("{word} is no TOML: {}", error.message()))
        }
        Err(_) => Ok(Value::from(word)),
    }
}

/// Sets what `path` leads to from `item`; `walked` is how it was come by.
fn in_item<'path>(
    item: &mut Item,
    path: &[Step<'path>],
    walked: &mut Vec<Step<'path>>,
    value: Value,
) -> Result<(), String> {
    let Some((step, rest)) = path.split_first() else {
        *item = Item::Value(value);
        return Ok(());
    };
    if item.is_none() {
        *item = begun(*step, rest, walked)?;
    }
    match (item, step) {
        (Item::Value(inner), _) => in_value(inner, path, walked, value),
        (Item::Table(table), Step::Field(name)) => {
            walked.push(*step);
            in_item(table.entry(name).or_insert(Item::None), rest, walked, value)
        }
        (Item::ArrayOfTables(tables), Step::Index(_) | Step::Append) => {
            let index = index(*step, tables.len(), walked)?;
            walked.push(Step::Index(index));
            if index == tables.len() {
                tables.push(Table::new());
            }
            let table = tables.get_mut(index).ok_or(EXAMPLE)?;
            in_table(table, rest, walked, value)
        }
        (Item::ArrayOfTables(tables), Step::Field(name)) => Err(which(name, tables.len(), walked)),
        (_, Step::Index(_) | Step::Append) => Err(no_list(walked)),
        (_, Step::Field(name)) => Err(no_table(name, walked)),
    }
}

fn in_table<'path>(
    table: &mut Table,
    path: &[Step<'path>],
    walked: &mut Vec<Step<'path>>,
    value: Value,
) -> Result<(), String> {
    match (path.split_first(), value) {
        (None, Value::InlineTable(value)) => {
            *table = value.into_table();
            Ok(())
        }
        (None, _) => Err(format!("{} is a table: such as {{ key = value }}", shown(walked))),
        (Some((Step::Field(name), rest)), value) => {
            walked.push(Step::Field(name));
            in_item(table.entry(name).or_insert(Item::None), rest, walked, value)
        }
        (Some(_), _) => Err(no_list(walked)),
    }
}

fn in_value<'path>(
    inner: &mut Value,
    path: &[Step<'path>],
    walked: &mut Vec<Step<'path>>,
    value: Value,
) -> Result<(), String> {
    let Some((step, rest)) = path.split_first() else {
        *inner = value;
        return Ok(());
    };
    match (inner, step) {
        (Value::InlineTable(table), Step::Field(name)) => {
            walked.push(*step);
            if !table.contains_key(name) {
                table.insert(*name, inline(rest, walked)?);
            }
            in_value(table.get_mut(name).ok_or(EXAMPLE)?, rest, walked, value)
        }
        (Value::Array(array), Step::Index(_) | Step::Append) => {
            let index = index(*step, array.len(), walked)?;
            walked.push(Step::Index(index));
            if index == array.len() {
                array.push(inline(rest, walked)?);
            }
            in_value(array.get_mut(index).ok_or(EXAMPLE)?, rest, walked, value)
        }
        (Value::Array(array), Step::Field(name)) => Err(which(name, array.len(), walked)),
        (_, Step::Index(_) | Step::Append) => Err(no_list(walked)),
        (_, Step::Field(name)) => Err(no_table(name, walked)),
    }
}

/// What a path goes on into, where nothing is yet.
fn begun(step: Step<'_>, rest: &[Step<'_>], walked: &[Step<'_>]) -> Result<Item, String> {
    Ok(match step {
        Step::Field(_) => Item::Table(Table::new()),
        Step::Index(1..) => return Err(no_element(step, 0, walked)),
        _ if matches!(rest.first(), Some(Step::Field(_))) => Item::ArrayOfTables(ArrayOfTables::new()),
        _ => Item::Value(Value::Array(Array::new())),
    })
}

/// The same within a value; where the path ends it is overwritten.
fn inline(rest: &[Step<'_>], walked: &[Step<'_>]) -> Result<Value, String> {
    Ok(match rest.first() {
        Some(Step::Index(1..)) => return Err(no_element(rest[0], 0, walked)),
        Some(Step::Index(_) | Step::Append) => Value::Array(Array::new()),
        Some(Step::Field(_)) | None => Value::InlineTable(InlineTable::new()),
    })
}

/// Which element is meant of a list of `count`; `count` for a new one.
fn index(step: Step<'_>, count: usize, walked: &[Step<'_>]) -> Result<usize, String> {
    match step {
        Step::Append => Ok(count),
        Step::Index(index) if index < count || (index == 0 && count == 0) => Ok(index),
        _ => Err(no_element(step, count, walked)),
    }
}

fn no_element(step: Step<'_>, count: usize, walked: &[Step<'_>]) -> String {
    let list = shown(walked);
    let there = match count {
        0 => format!("{list} is empty: {list}.0 begins it"),
        1 => format!("{list} has one element, {list}.0; {list}.+ adds one"),
        _ => format!("{list} has {list}.0 to {list}.{}; {list}.+ adds one", count - 1),
    };
    format!("there is no {}: {there}", shown(&[walked, &[step]].concat()))
}

fn which(name: &str, count: usize, walked: &[Step<'_>]) -> String {
    let list = shown(walked);
    let numbers = if count > 1 { format!(" (0 to {})", count - 1) } else { String::new() };
    format!("{list} is a list: {list}.0.{name}, by the element's number{numbers}")
}

fn no_list(walked: &[Step<'_>]) -> String {
    format!("{} is no list, and has no elements", shown(walked))
}

fn no_table(name: &str, walked: &[Step<'_>]) -> String {
    format!("{} is no table, and has no {name:?}", shown(walked))
}

fn shown(path: &[Step<'_>]) -> String {
    let words = path.iter().map(|step| match step {
        Step::Field(name) => (*name).to_owned(),
        Step::Index(index) => index.to_string(),
        Step::Append => "+".to_owned(),
    });
    if path.is_empty() { "the scene".to_owned() } else { words.collect::<Vec<_>>().join(".") }
}
