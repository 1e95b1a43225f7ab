//! A recording is, in this order: the stores' names, the layout, what never changes, then chunk after chunk of columns.
//!
//! * `/body/<name>/plots/<channel>`: every sample, every column as f64, one entity per channel. This is the truth.
//! * `/time/interval_s` (static) or `/time/time_s`: the exact times; stamps are rounded to ns. With an interval, the
//!   time of a sample is `step · interval_s`, rounded once, as [`crate::scenario::Grid::time`] says.
//! * `/world/…`: the picture, f32, at the picture's rate: `body/<name>` with its shape and axes, `vectors/<name>/…`,
//!   `trail/<name>`, `path/<name>`, `cords/<name>`, `particles/<name>`, `springs/<name>`, `axes`.
//! * `/poinsot/<name>/…`, `/body_frame/<name>/…`: Poinsot's construction of a body that turns freely, f32, at the same rate.
//! * `/scaled/…`, `/markers/…`: plots in powers of ten, and events in plots.
//! * `/about`, `/log`: words. `/scene`, `/provenance`, `/body/<name>`: where it comes from and of what, for programs, too.
//!
//! Timelines: `sim_time`, ns from the start of the run, and `step`, the number of the sample.

mod about;
mod blueprint;
mod columns;
mod cords;
mod file;
mod foreign;
mod gathered;
mod identity;
mod layout;
mod markers;
mod messages;
mod moving;
mod near_views;
mod overlay;
mod overlay_layout;
mod palette;
mod particles;
mod plain;
mod plot_views;
mod plots;
mod poinsot;
mod poinsot_views;
mod points;
mod read;
mod rolling;
mod scaled;
mod source;
mod statics;
mod stream;
mod trail;
mod unpack;
mod words;

pub use file::RerunFile;
#[cfg(feature = "live")]
pub(in crate::recording) use file::RerunStream;
pub(in crate::recording) use foreign::observe;
pub(in crate::recording) use overlay::write_overlay;
pub use read::contents;
pub(in crate::recording) use source::open;
