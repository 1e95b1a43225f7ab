//! `.csv`: one line a sample, for spreadsheets and scripts.
//!
//! The first line names the columns: `time_s`, then each channel's, with unit (`angular_velocity_x_rad_s`); with several
//! bodies each name starts with the body's (`upper.attitude_w`). Numbers are the shortest decimals that read back to
//! the very same f64. What is not a column (scene, method, events) a `.csv` does not hold.

mod header;
mod lines;
mod read;
mod write;

pub(super) use header::names_own_columns;
pub(super) use lines::Lines;
pub(super) use read::open;
pub use write::CsvFile;
