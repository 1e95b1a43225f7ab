//! Everything that is wrong with a scene's keys and types, not only the first of it.

use std::ops::Range;

use serde::Deserialize;
use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue, Deserializer, Error};

use super::words::{MISSING, reworded};
use crate::scenario::Scenario;
use crate::scenario::faults::{Faults, MOST_FAULTS};

/// What is wrong with a key.
pub struct Fault {
    /// Path of the key; empty where the text is no TOML.
    pub key: String,
    /// What was met, and the rule.
    pub message: String,
    /// Bytes of the text that it is about.
    pub span: Option<Range<usize>>,
}

/// Where a fault is. The first of an array of tables stands where the array does: what lacks a key is the table.
struct Place {
    span: Range<usize>,
    is_table: bool,
}

impl Place {
    fn of(error: &Error) -> Option<Self> {
        Some(Self { span: error.span()?, is_table: error.message().starts_with(MISSING) })
    }

    fn is_at(&self, value: &Spanned<DeValue<'_>>) -> bool {
        value.span() == self.span && (value.get_ref().is_table() || !self.is_table)
    }
}

/// The scene in `text`, or its faults, in the order in which they are met.
pub fn scene(text: &str) -> Result<Scenario, Faults<Fault>> {
    let (whole, broken) = DeTable::parse_recoverable(text);
    let syntax = broken.iter().take(MOST_FAULTS).map(|error| fault("", error)).collect();
    if let Some(faults) = Faults::of(syntax) {
        return Err(faults);
    }
    let read = |table: &Spanned<DeTable<'_>>| Scenario::deserialize(Deserializer::from(table.clone()));
    let met = |error: &Error| {
        let key = Place::of(error).and_then(|place| path_in_table(whole.get_ref(), &place));
        fault(&key.unwrap_or_default(), error)
    };
    let mut rest = whole.clone();
    let mut error = match read(&rest) {
        Ok(scenario) => return Ok(scenario),
        Err(error) => error,
    };
    let mut faults = Faults::from(met(&error));
    // Without what is wrong, the next fault shows.
    while faults.others.len() + 1 < MOST_FAULTS
        && Place::of(&error).is_some_and(|place| remove_from_table(rest.get_mut(), &place))
    {
        error = match read(&rest) {
            Ok(_) => break,
            Err(error) => error,
        };
        faults.others.push(met(&error));
    }
    Err(faults)
}

fn fault(key: &str, error: &Error) -> Fault {
    let (key, message) = reworded(key, error.message());
    Fault { key, message, span: error.span() }
}

/// The path of the key or value that stands there.
fn path_in_table(table: &DeTable<'_>, place: &Place) -> Option<String> {
    table.iter().find_map(|(key, value)| {
        let name = key.get_ref();
        if key.span() == place.span || place.is_at(value) {
            return Some(name.to_string());
        }
        Some(format!("{name}{}", path_in_value(value, place)?))
    })
}

/// The rest of the path.
fn path_in_value(value: &Spanned<DeValue<'_>>, place: &Place) -> Option<String> {
    match value.get_ref() {
        DeValue::Table(table) => Some(format!(".{}", path_in_table(table, place)?)),
        DeValue::Array(array) => array.iter().enumerate().find_map(|(index, element)| {
            if place.is_at(element) {
                return Some(format!("[{index}]"));
            }
            Some(format!("[{index}]{}", path_in_value(element, place)?))
        }),
        _ => None,
    }
}

/// Takes away what stands there; whether there was something.
fn remove_from_table(table: &mut DeTable<'_>, place: &Place) -> bool {
    let found = table.iter().find(|(key, value)| key.span() == place.span || place.is_at(value));
    if let Some(key) = found.map(|(key, _)| key.clone()) {
        return table.remove(&key).is_some();
    }
    table.iter_mut().any(|(_, value)| remove_from_value(value.get_mut(), place))
}

fn remove_from_value(value: &mut DeValue<'_>, place: &Place) -> bool {
    match value {
        DeValue::Table(table) => remove_from_table(table, place),
        DeValue::Array(array) => remove_from_array(array, place),
        _ => false,
    }
}

fn remove_from_array<'text>(array: &mut DeArray<'text>, place: &Place) -> bool {
    // Of numbers: one less would be a fault of its own. Only tables are independent of each other.
    let is_table = |element: &Spanned<DeValue<'text>>| place.is_at(element) && element.get_ref().is_table();
    if let Some(index) = array.iter().position(is_table) {
        let all = std::mem::replace(array, DeArray::new()).into_iter().enumerate();
        all.filter(|(at, _)| *at != index).for_each(|(_, element)| array.push(element));
        return true;
    }
    array.iter_mut().any(|element| remove_from_value(element.get_mut(), place))
}
