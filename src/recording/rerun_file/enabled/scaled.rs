use std::io::Write;

use super::columns::scalars;
use super::plots::curves;
use super::stream::{Rows, Store, Stream};
use crate::recording::RecordingError;
use crate::recording::picture::Picture;
use crate::recording::subject::bodies;
use crate::scenario::Plan;
use crate::telemetry::{BodySamples, Channel};

/// Where `channel` is in powers of ten of its unit, for plots.
pub(super) fn entity(body: &str, channel: Channel) -> String {
    format!("/scaled/{body}/{}", channel.row().name)
}

/// One body's or point's channels whose numbers no axis shows well, in powers of ten, at the picture's rate. The truth is beside
/// them, as for every channel.
pub(super) struct Scaled {
    channels: Vec<(Channel, String, f64)>,
}

impl Scaled {
    /// Logs the curves' names and colours, of the bodies and then of their points.
    ///
    /// # Errors
    /// If they cannot be written.
    pub(super) fn begin<W: Write>(
        stream: &mut Stream<W>,
        store: Store,
        plan: &Plan,
        picture: &Picture,
    ) -> Result<Vec<Self>, RecordingError> {
        let recorded = bodies(plan, &[]);
        let mut scaled = Vec::with_capacity(recorded.len());
        for (number, body) in recorded.iter().enumerate() {
            let mut channels = Vec::new();
            for channel in body.channels.iter().copied().filter(|channel| picture.power(*channel) != 0) {
                let entity = entity(&body.name, channel);
                stream.once(store, &entity, &[], &curves(channel, number, &recorded))?;
                channels.push((channel, entity, libm::pow(10.0, f64::from(-picture.power(channel)))));
            }
            scaled.push(Self { channels });
        }
        Ok(scaled)
    }

    /// Logs the drawn samples of one batch.
    ///
    /// # Errors
    /// If they cannot be written.
    pub(super) fn write<W: Write>(
        &self,
        stream: &mut Stream<W>,
        store: Store,
        rows: Rows<'_>,
        (indices, samples): (&[usize], &BodySamples),
    ) -> Result<(), RecordingError> {
        for (channel, entity, factor) in &self.channels {
            let columns = samples.channel(*channel).unwrap_or_default();
            let drawn = |column: &Vec<f64>| indices.iter().map(|index| column[*index] * factor).collect();
            let columns: Vec<Vec<f64>> = columns.iter().map(drawn).collect();
            stream.columns(store, entity, rows, [scalars(&columns)])?;
        }
        Ok(())
    }
}
