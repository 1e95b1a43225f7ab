use super::columns::{sim_time, timelines};
use super::moving::Moving;
use super::plots::Plots;
use super::stream::{Rows, Store, Stream};
use super::{about, identity, layout, statics};
use crate::recording::picture::Picture;
use crate::recording::{PartFile, RecordingError, Sink};
use crate::scenario::{Plan, nanoseconds};
use crate::telemetry::Samples;

/// An `.rrd` being written: layout and constants at once, columns batch by batch, the footer at the end.
pub struct RerunFile {
    stream: Stream<PartFile>,
    store: Store,
    plots: Plots,
    moving: Moving,
}

impl RerunFile {
    /// Writes what comes before the first sample.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn create(plan: &Plan, picture: &Picture, file: PartFile) -> Result<Self, RecordingError> {
        let path = file.path().to_path_buf();
        let mut stream = Stream::begin(file, path)?;
        let recording = identity::recording(plan).map_err(|reason| stream.refused(reason))?;
        let blueprint = identity::blueprint(plan).map_err(|reason| stream.refused(reason))?;
        let store = stream.open(recording)?;
        let blueprint = stream.open(blueprint)?;
        layout::write(&mut stream, blueprint, plan, picture)?;
        stream.activate(blueprint)?;

        stream.once(store, "/about", &[], &about::document(plan, picture))?;
        for body in &plan.bodies {
            if let Some(certificate) = about::certificate(body) {
                stream.once(store, &format!("/certificate/{}", body.name), &[], &certificate)?;
            }
        }
        statics::write(&mut stream, store, plan, picture)?;
        let plots = Plots::begin(&mut stream, store, plan)?;
        write_events(&mut stream, store, plan)?;
        Ok(Self { stream, store, plots, moving: Moving::new(plan, picture) })
    }
}

impl Sink for RerunFile {
    fn write(&mut self, samples: &Samples) -> Result<(), RecordingError> {
        if samples.is_empty() {
            return Ok(());
        }
        let steps = (samples.first_index..).take(samples.len()).map(u64::cast_signed).collect();
        let times = timelines(samples.stamps_ns.clone(), steps);
        let rows = Rows { count: samples.len(), times: &times };
        self.plots.write(&mut self.stream, self.store, rows, samples)?;
        self.moving.write(&mut self.stream, self.store, samples)
    }

    fn finish(self: Box<Self>) -> Result<PartFile, RecordingError> {
        self.stream.end()
    }
}

/// Logs what happens to the bodies, in one chunk.
fn write_events<W: std::io::Write>(stream: &mut Stream<W>, store: Store, plan: &Plan) -> Result<(), RecordingError> {
    if plan.events.is_empty() {
        return Ok(());
    }
    let times = [sim_time(plan.events.iter().map(|event| nanoseconds(event.time_s)).collect())];
    let columns = about::events(plan).columns_of_unit_batches().map_err(|error| stream.refused(error))?;
    stream.columns(store, "/log", Rows { count: plan.events.len(), times: &times }, columns)
}
