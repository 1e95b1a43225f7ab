use std::path::{Path, PathBuf};

use thiserror::Error;

use super::{Drawing, Surroundings};

/// What a drawing can be written as.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Lines and words, sharp at any size.
    Svg,
    /// Pixels, two to one of the drawing.
    Png,
}

/// Why there is no plot.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum PlotError {
    /// A name of neither format.
    #[error("cannot draw {path}: a plot's name ends in .svg or .png", path = path.display())]
    UnknownFormat {
        /// Its name.
        path: PathBuf,
    },
    /// The sheet has no area, or more than memory should hold.
    #[error("a picture of {width} × {height} pixels cannot be made: each side is 1 to 16384")]
    Size {
        /// Pixels.
        width: f64,
        /// Pixels.
        height: f64,
    },
    /// No body is called so.
    #[error("there is no body {name:?}: {hint}")]
    UnknownBody {
        /// What was asked for.
        name: String,
        /// What comes near, or what there is.
        hint: String,
    },
    /// The columns for a panel are not there.
    #[error("{what} cannot be drawn: recorded are {recorded}")]
    NotRecorded {
        /// What was asked for.
        what: &'static str,
        /// What there is.
        recorded: String,
    },
    /// The pixels could not be packed.
    #[error("a picture cannot be packed: {0}")]
    Png(String),
}

impl Format {
    /// That a file's name asks for.
    ///
    /// # Errors
    /// If it asks for neither.
    pub fn of(path: &Path) -> Result<Self, PlotError> {
        match path.extension().and_then(|extension| extension.to_str()) {
            Some("svg") => Ok(Self::Svg),
            Some("png") => Ok(Self::Png),
            _ => Err(PlotError::UnknownFormat { path: path.into() }),
        }
    }

    /// `drawing` as the bytes of a file.
    ///
    /// # Errors
    /// If it is too large for pixels.
    pub fn bytes(self, drawing: &Drawing) -> Result<Vec<u8>, PlotError> {
        match self {
            Self::Svg => Ok(drawing.svg(Surroundings::Paper).into_bytes()),
            Self::Png => drawing.png(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::{Limit, Mark, Series, TimeChart};

    fn chart() -> Drawing {
        let wave = |index: u32| [f64::from(index) * 0.02, libm::sin(f64::from(index) * 0.1)];
        TimeChart {
            title: "ω in body axes".into(),
            unit: "rad/s".into(),
            series: vec![Series::new("x", (0..500).map(wave).collect())],
            limits: vec![Limit { label: "limit".into(), value: 0.5 }],
            marks: vec![Mark { label: "flip".into(), time_s: 3.0 }],
            ..TimeChart::default()
        }
        .draw(560.0, 240.0)
    }

    /// FNV-1a, of 64 bits.
    fn hash(bytes: &[u8]) -> u64 {
        bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
    }

    #[test]
    fn the_same_drawing_has_the_same_bytes_on_every_machine() {
        let bytes = |format: Format| format.bytes(&chart()).expect("a small sheet");
        assert_eq!(bytes(Format::Png), bytes(Format::Png));
        // Found by whatever machine wrote this line: another one that finds another picture is not the same everywhere.
        assert_eq!(
            [hash(&bytes(Format::Svg)), hash(&bytes(Format::Png))],
            [1_254_283_405_188_668_328, 10_188_645_519_569_568_991]
        );
    }

    #[test]
    fn a_picture_has_two_pixels_to_one() {
        let png = Format::Png.bytes(&chart()).expect("a small sheet");
        assert_eq!(png[..8], *b"\x89PNG\r\n\x1a\n");
        let side = |at: usize| u32::from_be_bytes([png[at], png[at + 1], png[at + 2], png[at + 3]]);
        assert_eq!((side(16), side(20)), (1120, 480));
        assert!(matches!(Drawing::new(9000.0, 10.0).png(), Err(PlotError::Size { .. })));
        assert!(matches!(Drawing::new(0.0, 10.0).png(), Err(PlotError::Size { .. })));
    }
}
