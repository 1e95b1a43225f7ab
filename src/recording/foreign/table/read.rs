use std::path::Path;

use super::assemble::{Exactness, Numbers, Parts};
use super::columns::Columns;
use super::digits::Digits;
use super::fields::fields;
use super::guess;
use super::head::{self, Head};
use crate::recording::RecordingError;
use crate::recording::csv_file::{Lines, names_own_columns};
use crate::recording::foreign::clock::DecimalClock;
use crate::recording::foreign::{Mapping, Observation};

/// Whether a file's first line names columns as this crate does.
///
/// # Errors
/// If it cannot be read.
pub(in crate::recording::foreign) fn is_own(path: &Path) -> Result<bool, RecordingError> {
    let mut lines = Lines::open_foreign(path)?;
    Ok(lines.advance()? && names_own_columns(lines.text()))
}

/// Reads a table.
///
/// # Errors
/// If it cannot be read, does not fit the mapping, or holds what is no number, not finite, or no later time than the one
/// before.
pub(in crate::recording::foreign) fn observe(path: &Path, mapping: &Mapping) -> Result<Observation, RecordingError> {
    let mut lines = Lines::open_foreign(path)?;
    let head = head::read(&mut lines, mapping)?;
    let refused = |reason| RecordingError::Mapping { path: path.into(), reason };
    let guessed = if mapping.body.is_empty() { vec![guess::body(&head.names).map_err(refused)?] } else { Vec::new() };
    let bodies = if guessed.is_empty() { &mapping.body } else { &guessed };
    let time = mapping.time.clone().map_or_else(|| guess::time(&head.names), Ok).map_err(refused)?;
    let mut columns = Columns::new(&head.names, head.columns);
    let time_place = columns.find_time(&time).map_err(refused)?;
    let parts: Result<Vec<_>, _> = bodies.iter().map(|body| Parts::find(body, &mut columns)).collect();
    let parts = parts.map_err(refused)?;
    let mut reader = Reader::new(&head, columns.places(), time_place, mapping.time_unit.decimals());
    reader.read(&mut lines)?;
    reader.numbers.exactness = Exactness::Digits(reader.digits);
    let bodies = parts.iter().zip(bodies).map(|(parts, body)| parts.observed(body, &reader.numbers));
    let bodies: Result<Vec<_>, _> = bodies.collect();
    let mut observation = Observation {
        bodies: bodies.map_err(|reason| lines.refuse(reason))?,
        start_ns: reader.clock.map_or(0, DecimalClock::start_ns),
        time_resolution_s: reader.time_resolution(),
        remarks: Vec::new(),
    };
    if !guessed.is_empty() {
        observation
            .remarks
            .push("no mapping names the columns: they were taken as their names say, in SI units".into());
    }
    observation.claim_names().map_err(refused)?;
    Ok(observation)
}

/// Reads line after line.
struct Reader<'a> {
    head: &'a Head,
    places: &'a [usize],
    time_place: usize,
    decimals: u32,
    clock: Option<DecimalClock>,
    numbers: Numbers,
    digits: Digits,
    time_digits: Digits,
}

impl<'a> Reader<'a> {
    fn new(head: &'a Head, places: &'a [usize], time_place: usize, decimals: u32) -> Self {
        let numbers = Numbers { columns: vec![Vec::new(); places.len()], ..Numbers::default() };
        Self {
            head,
            places,
            time_place,
            decimals,
            clock: None,
            numbers,
            digits: Digits::default(),
            time_digits: Digits::default(),
        }
    }

    fn read(&mut self, lines: &mut Lines) -> Result<(), RecordingError> {
        let mut is_there = self.head.is_at_numbers || lines.advance()?;
        while is_there {
            if !head::is_remark(lines.text()) {
                self.take(lines.text()).map_err(|reason| lines.wrong(&reason))?;
            }
            is_there = lines.advance()?;
        }
        if self.numbers.times_s.is_empty() {
            return Err(lines.refuse("it has no line of numbers".into()));
        }
        Ok(())
    }

    fn take(&mut self, line: &str) -> Result<(), String> {
        let fields = fields(line.trim_start_matches('\u{feff}'), self.head.separator)?;
        if fields.len() != self.head.columns {
            return Err(format!("has {} values in {} columns", fields.len(), self.head.columns));
        }
        self.take_time(&fields[self.time_place])?;
        for (number, place) in self.places.iter().enumerate() {
            let text: &str = &fields[*place];
            let value =
                text.parse::<f64>().map_err(|_| format!("has {text:?} for a number in column {}", place + 1))?;
            if !value.is_finite() {
                return Err(format!("has {text} in column {}: not finite", place + 1));
            }
            self.digits.see(text);
            self.numbers.columns[number].push(value);
        }
        Ok(())
    }

    fn take_time(&mut self, text: &str) -> Result<(), String> {
        self.clock = self.clock.or_else(|| DecimalClock::new(self.decimals, text));
        let time =
            self.clock.and_then(|clock| clock.seconds(text)).ok_or_else(|| format!("has {text:?} for a time"))?;
        if let Some(last) = self.numbers.times_s.last().filter(|last| time <= **last) {
            return Err(format!("is at {time} s, after one at {last} s: times ascend"));
        }
        self.time_digits.see(text);
        self.numbers.times_s.push(time);
        Ok(())
    }

    /// Half a unit in the last decimal, unless equal steps show that nothing is lost behind it, or all digits are there.
    fn time_resolution(&self) -> f64 {
        let times = &self.numbers.times_s;
        let span = times.last().zip(times.first()).map_or(0.0, |(last, first)| last - first);
        let largest = times.iter().fold(0.0_f64, |largest, time| largest.max(time.abs()));
        let rounding = largest * f64::EPSILON / 2.0;
        let steps = f64::from(u32::try_from(times.len().saturating_sub(1)).unwrap_or(u32::MAX));
        let is_even = times.windows(2).all(|pair| ((pair[1] - pair[0]) * steps - span).abs() <= 1e-6 * span);
        if is_even { rounding } else { self.time_digits.resolution(largest) * largest }
    }
}
