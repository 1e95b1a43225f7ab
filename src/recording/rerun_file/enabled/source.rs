use std::path::Path;

use re_chunk::{Chunk, TimelineName};
use re_log_types::{LogMsg, StoreKind};
use re_sdk_types::archetypes::{Scalars, TextDocument};

use super::columns::{SIM_TIME, STEP};
use super::messages::{End, Messages};
use super::plots::{INTERVAL, TIME, channel_of};
use super::{unpack, words};
use crate::recording::recorded::{Opened, Source};
use crate::recording::subject::certificate;
use crate::recording::{Heading, RecordedBody, RecordingError};
use crate::scenario::nanoseconds;
use crate::telemetry::{Channel, Samples};

/// The samples of an `.rrd`, from its start.
struct RrdSource {
    messages: Messages,
    intake: Intake,
}

/// What the chunks bring: the heading, then batch after batch, one chunk for each channel in turn.
#[derive(Default)]
struct Intake {
    heading: Heading,
    /// Number of the body, and channel, in the order of the file.
    channels: Vec<(usize, Channel)>,
    interval_s: Option<f64>,
    samples: Samples,
    next_step: i64,
    /// Whose chunk comes next.
    next: usize,
    has_begun: bool,
}

/// Reads up to the first sample: everything that comes before it is the heading.
///
/// # Errors
/// If it cannot be read, is damaged, or no recording of this crate.
pub(in crate::recording) fn open(path: &Path) -> Result<Opened, RecordingError> {
    let mut source = RrdSource { messages: Messages::open(path)?, intake: Intake::default() };
    while !source.intake.has_begun && source.advance()? {}
    if source.intake.heading.bodies.is_empty() {
        let reason = "it has no /body/<name>: no recording of this program, or none of its start";
        return Err(source.messages.damaged(reason));
    }
    Ok((source.intake.heading.clone(), Box::new(source)))
}

impl RrdSource {
    /// Takes the next message in; false at the end.
    fn advance(&mut self) -> Result<bool, RecordingError> {
        let Some(message) = self.messages.next() else { return Ok(false) };
        let taken = match message? {
            LogMsg::ArrowMsg(store, batch) if store.kind() == StoreKind::Recording => {
                unpack::chunk(&batch).and_then(|chunk| self.intake.take(&chunk))
            }
            _ => Ok(()),
        };
        taken.map_err(|reason| self.messages.damaged(reason))?;
        Ok(true)
    }
}

impl Source for RrdSource {
    fn fill(&mut self, _most: usize, samples: &mut Samples) -> Result<(), RecordingError> {
        while !self.intake.has_batch() {
            if self.advance()? {
                continue;
            }
            if self.messages.end() == End::Whole && !self.intake.samples.is_empty() {
                return Err(self.messages.damaged("the last batch lacks a channel"));
            }
            return Ok(());
        }
        self.intake.hand_over(samples).map_err(|reason| self.messages.damaged(reason))
    }

    fn is_whole(&self) -> bool {
        self.messages.end() == End::Whole
    }
}

impl Intake {
    fn take(&mut self, chunk: &Chunk) -> Result<(), String> {
        let entity = chunk.entity_path().to_string();
        if chunk.is_static() {
            return self.take_constant(&entity, chunk);
        }
        if entity == TIME {
            return self.take_times(chunk);
        }
        let Some((body, channel)) = channel_of(&entity) else { return Ok(()) };
        let Some(expected) = self.channels.get(self.next).copied() else {
            return Err(format!("{entity}: a channel out of turn"));
        };
        if channel != expected.1 || self.heading.bodies[expected.0].name != body {
            return Err(format!("{entity}: a channel out of turn: each batch has every channel, in the same order"));
        }
        self.take_channel(chunk, expected).map_err(|reason| format!("{entity}: {reason}"))
    }

    fn take_constant(&mut self, entity: &str, chunk: &Chunk) -> Result<(), String> {
        if entity == INTERVAL {
            let numbers = numbers(chunk, 1)?;
            self.interval_s = numbers.first().copied();
        } else if entity == words::SCENE {
            self.heading.scene = text(chunk)?;
        } else if entity == words::PROVENANCE {
            self.heading.provenance = text(chunk)?.map(|lines| words::facts(&lines)).unwrap_or_default();
        } else if entity == words::COLUMNS {
            for (body, channels) in words::bodies(&text(chunk)?.unwrap_or_default())? {
                self.announce_body(body)?;
                channels.into_iter().try_for_each(|channel| self.announce(body, channel))?;
            }
        } else if let Some(body) = words::body_of(entity) {
            self.announce_body(body)?;
        } else if let Some((body, channel)) = channel_of(entity) {
            self.announce(body, channel)?;
        }
        Ok(())
    }

    /// Before the first sample each body is named, and right after it come its channels.
    fn announce_body(&mut self, name: &str) -> Result<(), String> {
        if self.has_begun {
            return Err(format!("the body {name} begins after the first sample"));
        }
        if self.heading.bodies.len() == Heading::MOST_BODIES {
            return Err(format!("more than {} bodies", Heading::MOST_BODIES));
        }
        if self.heading.bodies.iter().any(|body| body.name == name) {
            return Err(format!("two bodies are called {name}"));
        }
        let certificate = certificate(&self.heading.provenance, name);
        self.heading.bodies.push(RecordedBody { name: name.into(), certificate, ..RecordedBody::default() });
        Ok(())
    }

    /// Before the first sample each channel gets its names and colours, which tells what there will be.
    fn announce(&mut self, name: &str, channel: Channel) -> Result<(), String> {
        if self.has_begun {
            return Err(format!("{} of {name} begins after the first sample", channel.row().name));
        }
        let bodies = &mut self.heading.bodies;
        if bodies.last().is_none_or(|last| last.name != name) {
            return Err(format!("{} of {name} does not follow that body", channel.row().name));
        }
        let number = bodies.len() - 1;
        if bodies[number].channels.contains(&channel) {
            return Err(format!("{} of {name} is there twice", channel.row().name));
        }
        bodies[number].channels.push(channel);
        self.channels.push((number, channel));
        Ok(())
    }

    fn begin(&mut self) {
        if !self.has_begun {
            self.samples = self.heading.samples();
            self.has_begun = true;
        }
    }

    fn take_times(&mut self, chunk: &Chunk) -> Result<(), String> {
        self.begin();
        if self.next > 0 || !self.samples.times_s.is_empty() || self.interval_s.is_some() {
            return Err("times out of turn".into());
        }
        self.samples.times_s = numbers(chunk, 1)?;
        Ok(())
    }

    fn take_channel(&mut self, chunk: &Chunk, (body, channel): (usize, Channel)) -> Result<(), String> {
        self.begin();
        if self.next == 0 {
            self.samples.stamps_ns = times(chunk, SIM_TIME)?.to_vec();
            self.begin_batch()?;
        }
        let (steps, count) = (times(chunk, STEP)?, self.count());
        let is_in_step = steps.iter().copied().eq(self.next_step..self.next_step + count);
        if !is_in_step || *times(chunk, SIM_TIME)? != *self.samples.stamps_ns {
            return Err("its rows are not the samples of this batch, in order".into());
        }
        let numbers = numbers(chunk, channel.width())?;
        if numbers.len() != channel.width() * self.samples.len() {
            return Err(format!("not every row has {} numbers", channel.width()));
        }
        let columns = self.samples.bodies[body].channel_mut(channel).unwrap_or_default();
        for (component, column) in columns.iter_mut().enumerate() {
            column.extend(numbers.iter().skip(component).step_by(channel.width()));
        }
        self.next += 1;
        Ok(())
    }

    /// The exact times of a batch whose stamps are there.
    fn begin_batch(&mut self) -> Result<(), String> {
        if let Some(interval) = self.interval_s {
            let steps = self.next_step..self.next_step + (self.samples.stamps_ns.len() as u64).cast_signed();
            self.samples.times_s.clear();
            self.samples.times_s.extend(steps.map(|step| exact(step) * interval));
        }
        let stamps = self.samples.times_s.iter().map(|time| nanoseconds(*time));
        if !stamps.eq(self.samples.stamps_ns.iter().copied()) {
            return Err("its stamps are not those of the exact times".into());
        }
        Ok(())
    }

    fn count(&self) -> i64 {
        (self.samples.len() as u64).cast_signed()
    }

    fn has_batch(&self) -> bool {
        self.has_begun && self.next == self.channels.len()
    }

    /// Moves the batch to the empty buffers of `samples`.
    fn hand_over(&mut self, samples: &mut Samples) -> Result<(), String> {
        if self.samples.is_empty() {
            return Err("a batch without samples".into());
        }
        self.next_step += self.count();
        std::mem::swap(&mut self.samples.times_s, &mut samples.times_s);
        std::mem::swap(&mut self.samples.bodies, &mut samples.bodies);
        self.samples.clear();
        self.next = 0;
        Ok(())
    }
}

/// The numbers of every row, one after the other; each row has `width`.
fn numbers(chunk: &Chunk, width: usize) -> Result<Vec<f64>, String> {
    unpack::guarded(|| {
        let mut numbers = Vec::with_capacity(width * chunk.num_rows());
        for row in chunk.iter_slices::<f64>(Scalars::descriptor_scalars().component) {
            if row.len() != width {
                return Err(format!("a row of {} numbers, not {width}", row.len()));
            }
            numbers.extend_from_slice(row);
        }
        Ok(numbers)
    })
}

fn text(chunk: &Chunk) -> Result<Option<String>, String> {
    unpack::guarded(|| {
        let mut rows = chunk.iter_slices::<String>(TextDocument::descriptor_text().component);
        Ok(rows.next().and_then(|row| row.first().map(ToString::to_string)))
    })
}

fn times<'a>(chunk: &'a Chunk, timeline: &str) -> Result<&'a [i64], String> {
    let found = chunk.timelines().iter().find(|(name, _)| TimelineName::as_str(name) == timeline);
    found.map(|(_, column)| column.times_raw()).ok_or_else(|| format!("not on the timeline {timeline}"))
}

/// The number of a sample as f64: exact, as the plan admits no more than 2⁵³ samples.
#[expect(clippy::cast_precision_loss, reason = "below 2⁵³")]
fn exact(step: i64) -> f64 {
    step as f64
}
