use std::path::PathBuf;

use thiserror::Error;

use crate::scenario::{Refused, nearest};
use crate::telemetry::Channel;

/// A tolerance that is none.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ToleranceError {
    /// Negative, endless, or no number.
    #[error("a tolerance of {value:?}: it is a number from 0 on")]
    Number {
        /// The value met.
        value: f64,
    },
    /// Not of the form that a tolerance has.
    #[error(
        "{text:?} is no tolerance: they read NAME=ABSOLUTE, NAME=ABSOLUTE,RELATIVE, NAME=exact or NAME=shown, such as \
         attitude=1e-9 or angular_velocity=1e-12,1e-9"
    )]
    Form {
        /// As given.
        text: String,
    },
    /// A name that no channel has.
    #[error("{name:?} is no channel; {hint}")]
    UnknownChannel {
        /// As given.
        name: String,
        /// `did you mean …?`, or which there are.
        hint: String,
    },
    /// A file of tolerances that cannot be read.
    #[error("cannot read the tolerances {path}: {source}", path = path.display())]
    Io {
        /// Which file.
        path: PathBuf,
        /// Why not.
        source: std::io::Error,
    },
    /// A file of tolerances that the rules refuse.
    #[error("{0}")]
    Refused(Box<Refused>),
}

impl ToleranceError {
    /// That `name` is none of the names that `name_of` gives channels.
    pub(in crate::comparison) fn unknown(name: &str, name_of: impl Fn(Channel) -> String) -> Self {
        let names = Channel::ALL.map(name_of);
        let hint = match nearest(name, names.iter().map(String::as_str)) {
            Some(near) => format!("did you mean {near:?}?"),
            None => format!("known are {}", names.join(", ")),
        };
        Self::UnknownChannel { name: name.to_owned(), hint }
    }
}
