use std::collections::BTreeMap;

use prost::Message;

use super::about;
use super::container::{Output, Topic};
use super::foxglove::SCENE_UPDATE;
use super::log::EventLog;
use super::scene::MovingScene;
use super::state::{self, StateLayout, StateTimes};
use super::surfaces::surfaces;
use crate::recording::picture::Picture;
use crate::recording::{Interruption, PartFile, RecordedBody, RecordingError, Sink, Subject};
use crate::scenario::nanoseconds;
use crate::telemetry::Samples;

/// An `.mcap` in the making.
#[derive(Debug)]
pub struct McapFile {
    output: Output,
    states: Vec<(StateLayout, Topic)>,
    scene: Option<(MovingScene, Picture)>,
    log: EventLog,
    end_ns: i64,
}

impl McapFile {
    /// Starts with everything that is known before the first sample.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn create(subject: &Subject, file: PartFile) -> Result<Self, RecordingError> {
        let mut output = Output::create(file)?;
        output.describe(&about::metadata(subject))?;
        if let Some(text) = about::scene_text(subject) {
            output.attach(&text)?;
        }
        let recorded: Vec<_> = subject.heading.bodies.iter().flat_map(|body| body.channels.iter().copied()).collect();
        let schema = state::descriptor(&state::described(&recorded));
        let mut state = |body: &RecordedBody| -> Result<_, RecordingError> {
            let topic = format!("/body/{}/state", body.name);
            let topic = output.topic(&topic, (state::NAME, &schema), &units(body))?;
            Ok((StateLayout::new(&body.channels), topic))
        };
        let states = subject.heading.bodies.iter().map(&mut state).collect::<Result<_, _>>()?;
        let scene = match subject.drawing {
            Some((plan, picture)) => Some((MovingScene::new(plan, picture, &mut output)?, picture.clone())),
            None => None,
        };
        let mut log = EventLog::new(subject, &mut output)?;
        let start_ns = nanoseconds(subject.sampling.from_s);
        if let Some(update) = subject.drawing.and_then(|(plan, picture)| surfaces(plan, picture, start_ns)) {
            let mut topic = output.topic("/scene/surfaces", SCENE_UPDATE, &BTreeMap::new())?;
            log.tell_until(start_ns, &mut output)?;
            output.send(&mut topic, start_ns, |bytes| update.encode_raw(bytes))?;
        }
        output.flush()?;
        Ok(Self { output, states, scene, log, end_ns: nanoseconds(subject.sampling.to_s) })
    }
}

impl Sink for McapFile {
    fn write(&mut self, samples: &Samples) -> Result<(), RecordingError> {
        for (index, number) in (0..samples.len()).zip(samples.first_index..) {
            let (time_s, stamp_ns) = (samples.times_s[index], samples.stamps_ns[index]);
            self.log.tell_until(stamp_ns, &mut self.output)?;
            let times = StateTimes::new(time_s, stamp_ns);
            for ((layout, topic), body) in self.states.iter_mut().zip(&samples.bodies) {
                let data = |bytes: &mut Vec<u8>| layout.encode(&times, body.columns(), index, bytes);
                self.output.send(topic, stamp_ns, data)?;
            }
            if let Some((scene, picture)) = &mut self.scene
                && picture.draws(number)
            {
                scene.draw(samples, index, &mut self.output)?;
            }
        }
        self.output.flush_if_due()
    }

    fn finish(mut self: Box<Self>) -> Result<PartFile, RecordingError> {
        self.log.tell_until(self.end_ns, &mut self.output)?;
        self.output.finish()
    }

    fn interrupt(mut self: Box<Self>, end: &Interruption) -> Result<PartFile, RecordingError> {
        self.log.tell_until(nanoseconds(end.to_s), &mut self.output)?;
        self.log.tell_interruption(end, &mut self.output)?;
        self.output.describe(&about::interruption(end))?;
        self.output.finish()
    }
}

/// Unit and frame of each field, beside the topic.
fn units(body: &RecordedBody) -> BTreeMap<String, String> {
    let rows = body.channels.iter().map(|channel| channel.row());
    rows.map(|row| (row.name.to_owned(), format!("{}, {}", row.title, row.unit))).collect()
}
