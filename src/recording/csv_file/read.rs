use std::path::Path;

use super::header::heading;
use super::lines::Lines;
use crate::recording::RecordingError;
use crate::recording::recorded::{Opened, Source};
use crate::telemetry::{BodySamples, Samples};

/// Reads the line of column names.
///
/// # Errors
/// If it cannot be read, or does not name time and whole channels.
pub(in crate::recording) fn open(path: &Path) -> Result<Opened, RecordingError> {
    let mut lines = Lines::open(path)?;
    if !lines.advance()? {
        return Err(lines.refuse("there is no first line, which names the columns".into()));
    }
    let heading = heading(lines.text()).map_err(|reason| lines.refuse(reason))?;
    Ok((heading, Box::new(lines)))
}

impl Source for Lines {
    fn fill(&mut self, most: usize, samples: &mut Samples) -> Result<(), RecordingError> {
        while samples.len() < most && self.advance()? {
            self.add_row(samples)?;
        }
        Ok(())
    }

    fn is_whole(&self) -> bool {
        // A line that is cut off shows; a file that ends after a line does not.
        !self.is_part()
    }
}

impl Lines {
    /// Adds a line of one number for each column.
    fn add_row(&self, samples: &mut Samples) -> Result<(), RecordingError> {
        let (times, bodies) = (&mut samples.times_s, &mut samples.bodies);
        let mut columns = std::iter::once(times).chain(bodies.iter_mut().flat_map(BodySamples::columns_mut));
        let mut texts = self.text().split(',');
        for (index, column) in columns.by_ref().enumerate() {
            let Some(text) = texts.next() else {
                return Err(self.wrong(&format!("has {index} values in {} columns", self.columns())));
            };
            column.push(text.parse().map_err(|_| self.wrong(&format!("has {text:?} for a number")))?);
        }
        match texts.count() {
            0 => Ok(()),
            more => Err(self.wrong(&format!("has {} values in {} columns", self.columns() + more, self.columns()))),
        }
    }
}
