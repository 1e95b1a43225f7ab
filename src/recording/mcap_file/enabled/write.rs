use std::collections::BTreeMap;

use prost::Message;

use super::about;
use super::container::{Output, Topic};
use super::foxglove::SCENE_UPDATE;
use super::log::EventLog;
use super::scene::MovingScene;
use super::state::{self, StateLayout};
use super::surfaces::surfaces;
use crate::recording::picture::Picture;
use crate::recording::{PartFile, RecordingError, Sink};
use crate::scenario::{Plan, PlannedBody, nanoseconds};
use crate::telemetry::Samples;

/// An `.mcap` in the making.
#[derive(Debug)]
pub struct McapFile {
    output: Output,
    states: Vec<(StateLayout, Topic)>,
    scene: MovingScene,
    log: EventLog,
    picture: Picture,
    end_ns: i64,
}

impl McapFile {
    /// Starts with everything that is known before the first sample.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn create(plan: &Plan, picture: &Picture, file: PartFile) -> Result<Self, RecordingError> {
        let mut output = Output::create(file)?;
        output.describe(&about::metadata(plan))?;
        if let Some(text) = about::scene_text(plan) {
            output.attach(&text)?;
        }
        let schema = state::descriptor();
        let mut state = |body: &PlannedBody| -> Result<_, RecordingError> {
            let topic = format!("/body/{}/state", body.name);
            let topic = output.topic(&topic, (state::NAME, &schema), &units(body))?;
            Ok((StateLayout::new(&body.channels), topic))
        };
        let states = plan.bodies.iter().map(&mut state).collect::<Result<_, _>>()?;
        let scene = MovingScene::new(plan, picture, &mut output)?;
        let mut log = EventLog::new(plan, &mut output)?;
        let start_ns = nanoseconds(plan.grid.time(0));
        if let Some(update) = surfaces(plan, picture, start_ns) {
            let mut topic = output.topic("/scene/surfaces", SCENE_UPDATE, &BTreeMap::new())?;
            log.tell_until(start_ns, &mut output)?;
            output.send(&mut topic, start_ns, |bytes| update.encode_raw(bytes))?;
        }
        output.flush()?;
        Ok(Self { output, states, scene, log, picture: picture.clone(), end_ns: nanoseconds(plan.grid.end()) })
    }
}

impl Sink for McapFile {
    fn write(&mut self, samples: &Samples) -> Result<(), RecordingError> {
        for (index, number) in (0..samples.len()).zip(samples.first_index..) {
            let (time_s, stamp_ns) = (samples.times_s[index], samples.stamps_ns[index]);
            self.log.tell_until(stamp_ns, &mut self.output)?;
            for ((layout, topic), body) in self.states.iter_mut().zip(&samples.bodies) {
                let data = |bytes: &mut Vec<u8>| layout.encode((time_s, stamp_ns), body.columns(), index, bytes);
                self.output.send(topic, stamp_ns, data)?;
            }
            if self.picture.draws(number) {
                self.scene.draw(samples, index, &mut self.output)?;
            }
        }
        Ok(())
    }

    fn finish(mut self: Box<Self>) -> Result<PartFile, RecordingError> {
        self.log.tell_until(self.end_ns, &mut self.output)?;
        self.output.finish()
    }
}

/// Unit and frame of each field, beside the topic.
fn units(body: &PlannedBody) -> BTreeMap<String, String> {
    let rows = body.channels.iter().map(|channel| channel.row());
    rows.map(|row| (row.name.to_owned(), format!("{}, {}", row.title, row.unit))).collect()
}
