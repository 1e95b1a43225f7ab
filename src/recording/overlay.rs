use std::path::Path;

use super::{Finished, PartFile, RecordingError, rerun_file};
use crate::body::Surface;

/// Two motions over each other, to be looked at: each body twice in one picture, how far the two are apart over time, and
/// words.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Overlay {
    /// One line: what is compared.
    pub title: String,
    /// What was found, in Markdown.
    pub words: String,
    /// The first, s.
    pub from_s: f64,
    /// The last, s.
    pub to_s: f64,
    /// What is drawn.
    pub bodies: Vec<OverlaidBody>,
    /// What is plotted, those that matter most first.
    pub differences: Vec<DifferenceCurve>,
}

/// One body of both motions.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct OverlaidBody {
    /// Its name.
    pub name: String,
    /// What it looks like: body axes, from its reference point; of what is not known, axes alone are drawn.
    pub surfaces: Vec<Surface>,
    /// Where it is in each motion.
    pub poses: Poses,
}

/// A difference over time.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct DifferenceCurve {
    /// Of which body.
    pub body: String,
    /// Of which channel.
    pub channel: String,
    /// In which unit.
    pub unit: String,
    /// How large it may be.
    pub limit: Option<f64>,
    /// Times, s, ascending, and differences.
    pub points: Vec<(f64, f64)>,
}

/// Where a body is in two motions, at the same times: every one that comes, until there are too many to draw.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Poses {
    rows: Vec<(f64, [Pose; 2])>,
    /// One is kept of so many.
    stride: u64,
    seen: u64,
}

/// Where a body is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// World from body, quaternion w, x, y, z.
    pub attitude: [f64; 4],
    /// World axes, m; `None` where it is not known.
    pub position: Option<[f64; 3]>,
}

impl Poses {
    /// Poses at most.
    const MOST: usize = 1 << 14;

    /// Goes on to the next time, s. What is not finite cannot be drawn.
    pub fn push(&mut self, time_s: f64, poses: [Pose; 2]) {
        let is_finite = |pose: &Pose| pose.attitude.iter().chain(pose.position.iter().flatten()).all(|x| x.is_finite());
        if !poses.iter().all(is_finite) {
            return;
        }
        if self.seen.is_multiple_of(self.stride.max(1)) {
            if self.rows.len() == Self::MOST {
                let mut number = 0_usize;
                self.rows.retain(|_| {
                    number += 1;
                    !number.is_multiple_of(2)
                });
                self.stride = 2 * self.stride.max(1);
            }
            self.rows.push((time_s, poses));
        }
        self.seen += 1;
    }

    /// Times, s, and poses.
    #[must_use]
    pub fn rows(&self) -> &[(f64, [Pose; 2])] {
        &self.rows
    }
}

impl Overlay {
    /// The file at `path` that an overlay can be written to: an `.rrd`.
    ///
    /// # Errors
    /// If it has another extension, and as [`PartFile::create`].
    pub fn claim(path: &Path, overwrite: bool) -> Result<PartFile, RecordingError> {
        if path.extension().is_none_or(|extension| extension != "rrd") {
            let rule = "two motions over each other are an .rrd".into();
            return Err(RecordingError::NotRepresentable { path: path.into(), rule });
        }
        PartFile::create(path, overwrite)
    }

    /// Writes it to the file that was claimed, which gets its name. The same overlay gives the same bytes.
    ///
    /// # Errors
    /// If the file cannot be written; if this build has no `.rrd`.
    pub fn record(&self, file: PartFile) -> Result<Finished, RecordingError> {
        let mut file = rerun_file::write_overlay(self, file)?;
        file.sync()?;
        let finished = Finished { path: file.path().into(), bytes: file.bytes() };
        file.publish()?;
        Ok(finished)
    }
}
