use super::matching::Matched;
use super::report::{EventDifference, FactDifference, event_differences};
use super::side::Side;
use crate::recording::Heading;

/// What the sides say otherwise; where one says nothing at all there is nothing to compare.
pub(super) fn fact_differences([a, b]: &[Heading; 2], is_scene: [bool; 2]) -> Vec<FactDifference> {
    if a.provenance.is_empty() || b.provenance.is_empty() {
        return Vec::new();
    }
    // Of a scene, nothing was measured here.
    let is_told = |name: &&String| {
        let is_measured = name.starts_with("check.") || name.contains(".certificate.");
        !is_measured || is_scene == [false, false]
    };
    let names = a.provenance.iter().map(|(name, _)| name);
    let more = b.provenance.iter().map(|(name, _)| name).filter(|name| a.fact(name).is_none());
    let values = |name: &String| [a.fact(name), b.fact(name)].map(|value| value.map(str::to_owned));
    let both = names.chain(more).filter(is_told);
    let both = both.map(|name| FactDifference { name: name.clone(), values: values(name) });
    both.filter(|fact| fact.values[0] != fact.values[1]).collect()
}

/// Where two sides' scenes are known and are not the same.
pub(super) fn events(headings: &[Heading; 2], sides: [&Side; 2], bodies: &[Matched]) -> Vec<EventDifference> {
    let [a, b] = headings.each_ref().map(|heading| &heading.scene);
    // What is written down and the same happens at the same times.
    if a.is_some() && a == b {
        return Vec::new();
    }
    match sides.map(Side::plan) {
        [Some(a), Some(b)] => event_differences([a.as_ref(), b.as_ref()], bodies),
        _ => Vec::new(),
    }
}
