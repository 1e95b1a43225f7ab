use crate::comparison::compare::matching::Matched;
use crate::scenario::{EventKind, Plan};

/// Something that happens to a body at another time on the other side, or only on one.
#[derive(Debug, Clone, PartialEq)]
pub struct EventDifference {
    /// To which body: its name on the first side.
    pub body: String,
    /// What kind of thing.
    pub kind: EventKind,
    /// Its number among those of this kind and body, from 1.
    pub number: usize,
    /// When on each side, s, of its own clock; `None` where it does not happen.
    pub times_s: [Option<f64>; 2],
    /// What, in words, on the side that has it.
    pub text: String,
}

/// The loads that begin or end and the flips of two scenes that are not at the same times; checks are no events of the motion.
pub(in crate::comparison) fn event_differences(plans: [&Plan; 2], bodies: &[Matched]) -> Vec<EventDifference> {
    let mut found = Vec::new();
    for matched in bodies {
        for kind in [EventKind::Load, EventKind::Flip] {
            let [a, b] = [0, 1].map(|side| {
                // A table does not number its bodies as its scene does, but holds them in that order.
                let is_of = |event: &&crate::scenario::Event| event.body == matched.numbers[side] && event.kind == kind;
                plans[side].events.iter().filter(is_of).collect::<Vec<_>>()
            });
            for index in 0..a.len().max(b.len()) {
                let both = [a.get(index), b.get(index)];
                let times_s = both.map(|event| event.map(|event| event.time_s));
                let text = both.into_iter().flatten().next().map(|event| event.text.clone());
                if let Some(text) = text.filter(|_| times_s[0] != times_s[1]) {
                    let body = matched.names[0].clone();
                    found.push(EventDifference { body, kind, number: index + 1, times_s, text });
                }
            }
        }
    }
    found
}
