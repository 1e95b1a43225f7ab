use super::{Channel, Mounting};

/// A point of a body that is recorded beside it, under a name of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// The body's name, a slash, and its own.
    pub name: String,
    /// What is recorded of it, in the order of [`Channel::ALL`].
    pub channels: Vec<Channel>,
    /// What it is.
    pub kind: PointKind,
}

/// What can be recorded beside a body.
#[derive(Debug, Clone, PartialEq)]
pub enum PointKind {
    /// A probe or an IMU, fixed in the body.
    Mounted(Mounting),
}

impl Point {
    /// Its own name, without that of the body.
    #[must_use]
    pub fn own_name(&self) -> &str {
        self.name.split_once('/').map_or(&self.name, |(_, own)| own)
    }

    /// Whether what is recorded of it depends on the attitude: all but rates do.
    #[must_use]
    pub fn needs_attitude(&self) -> bool {
        self.channels.iter().any(|channel| *channel != Channel::Gyroscope)
    }
}
