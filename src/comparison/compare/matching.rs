use super::CompareError;
use super::comparison::Comparison;
use super::report::Difference;
use crate::recording::Heading;
use crate::telemetry::Channel;

/// A body that both sides have.
#[derive(Debug)]
pub(super) struct Matched {
    /// Its number on each side.
    pub numbers: [usize; 2],
    /// Its name on each side.
    pub names: [String; 2],
    /// What is compared of it.
    pub channels: Vec<Channel>,
}

/// Which bodies and channels are compared, and which one side lacks.
pub(super) struct Matching {
    pub bodies: Vec<Matched>,
    pub differences: Vec<Difference>,
}

/// Finds for each body of the first side that of the second. A scene has whatever channels the other side has.
pub(super) fn matched(
    comparison: &Comparison,
    headings: &[Heading; 2],
    sides: &[String; 2],
    is_scene: [bool; 2],
) -> Result<Matching, CompareError> {
    let numbers = numbers(comparison, headings, sides)?;
    let mut matching = Matching { bodies: Vec::new(), differences: Vec::new() };
    for side in 0..2 {
        for (number, body) in headings[side].bodies.iter().enumerate() {
            if !numbers.iter().any(|pair| pair[side] == number) {
                matching.differences.push(Difference::Body { side, name: body.name.clone() });
            }
        }
    }
    for pair in numbers {
        let bodies = [&headings[0].bodies[pair[0]], &headings[1].bodies[pair[1]]];
        let is_asked = |channel: &Channel| comparison.channels.is_empty() || comparison.channels.contains(channel);
        let asked = bodies.map(|body| body.channels.iter().copied().filter(is_asked).collect::<Vec<_>>());
        let [a, b] = &asked;
        let channels = match is_scene {
            [_, true] => a.clone(),
            [true, false] => b.clone(),
            [false, false] => a.iter().copied().filter(|channel| b.contains(channel)).collect(),
        };
        if is_scene == [false, false] {
            for side in 0..2 {
                let lone = asked[side].iter().filter(|channel| !channels.contains(channel));
                let body = &bodies[side].name;
                let difference =
                    |channel: &Channel| Difference::Channel { side, body: body.clone(), channel: *channel };
                matching.differences.extend(lone.map(difference));
            }
        }
        matching.bodies.push(Matched { numbers: pair, names: bodies.map(|body| body.name.clone()), channels });
    }
    if matching.bodies.iter().all(|body| body.channels.is_empty()) {
        let [a, b] = sides.clone();
        return Err(CompareError::NothingInCommon { a, b });
    }
    Ok(matching)
}

/// Numbers of the bodies that are compared, on each side.
fn numbers(
    comparison: &Comparison,
    headings: &[Heading; 2],
    sides: &[String; 2],
) -> Result<Vec<[usize; 2]>, CompareError> {
    let number = |side: usize, name: &str| {
        let mut bodies = headings[side].bodies.iter();
        bodies.position(|body| body.name == name).ok_or_else(|| unknown(&headings[side], &sides[side], name))
    };
    let [a, b] = headings.each_ref().map(|heading| &heading.bodies);
    // One body is the one that is meant, whatever it is called: a `.csv` does not tell.
    if comparison.names.is_empty() && a.len() == 1 && b.len() == 1 {
        return Ok(vec![[0, 0]]);
    }
    let named = comparison.names.iter().map(|(a, b)| Ok([number(0, a)?, number(1, b)?]));
    let mut numbers = named.collect::<Result<Vec<_>, CompareError>>()?;
    for (index, body) in a.iter().enumerate() {
        let same = b.iter().position(|other| other.name == body.name);
        let is_free = |other: usize| numbers.iter().all(|pair| pair[0] != index && pair[1] != other);
        numbers.extend(same.filter(|other| is_free(*other)).map(|other| [index, other]));
    }
    numbers.sort_unstable();
    Ok(numbers)
}

fn unknown(heading: &Heading, side: &str, name: &str) -> CompareError {
    let names = || heading.bodies.iter().map(|body| body.name.as_str());
    let hint = match crate::scenario::nearest(name, names()) {
        Some(near) => format!(": did you mean {near:?}?"),
        None => format!(": it has {}", names().collect::<Vec<_>>().join(", ")),
    };
    CompareError::UnknownBody { side: side.to_owned(), name: name.to_owned(), hint }
}
