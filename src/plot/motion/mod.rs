//! The motion of bodies as panels: channels against time, polhode, herpolhode, the path of an axis.

mod body;
mod envelope;
mod gather;
mod globe;
mod group;
mod herpolhode;
mod inertia;
mod polhode;
mod trail;
mod wanted;

pub use envelope::Envelope;
pub use gather::{Motion, Request};
pub use globe::{Ellipsoid, View};
pub use wanted::Wanted;
