use std::io::Write;

use re_sdk_types::archetypes::SeriesPoints;
use re_sdk_types::components::MarkerShape;

use super::columns::{scalars, sim_time};
use super::palette;
use super::stream::{Rows, Store, Stream};
use crate::recording::RecordingError;
use crate::scenario::{Event, EventKind, Plan, nanoseconds};

/// Kinds of events that are marked in the plot of ω, on its line at zero: name, shape.
const KINDS: [(EventKind, &str, MarkerShape); 2] =
    [(EventKind::Flip, "flip", MarkerShape::Diamond), (EventKind::Load, "on / off", MarkerShape::Up)];

/// Where the markers of a body are.
pub(super) fn entities(body: &str) -> String {
    format!("/markers/{body}")
}

/// Logs a marker for each flip and each edge of a load.
///
/// # Errors
/// If they cannot be written.
pub(super) fn write<W: Write>(stream: &mut Stream<W>, store: Store, plan: &Plan) -> Result<(), RecordingError> {
    for (number, body) in plan.bodies.iter().enumerate() {
        for (kind, name, shape) in KINDS {
            let is_marked = |event: &&Event| event.body == number && event.kind == kind;
            let mut stamps: Vec<_> =
                plan.events.iter().filter(is_marked).map(|event| nanoseconds(event.time_s)).collect();
            stamps.dedup();
            if stamps.is_empty() {
                continue;
            }
            let entity = format!("{}/{}", entities(&body.name), if kind == EventKind::Flip { "flip" } else { "load" });
            let style = SeriesPoints::new()
                .with_names([name])
                .with_colors([palette::opaque(palette::NAMES)])
                .with_markers([shape])
                .with_marker_sizes([5.0_f32]);
            stream.once(store, &entity, &[], &style)?;
            let zeros = vec![0.0; stamps.len()];
            let rows = Rows { count: stamps.len(), times: &[sim_time(stamps)] };
            stream.columns(store, &entity, rows, [scalars(&[zeros])])?;
        }
    }
    Ok(())
}
