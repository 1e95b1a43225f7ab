//! What was found, in numbers, words and pictures.

mod events;
mod found;
mod overlay;
mod verdict;

pub use events::EventDifference;
pub(in crate::comparison) use events::event_differences;
pub use found::{BodyReport, ChannelReport, Coverage, Difference, FactDifference, Finding, Report, SideReport};
pub use overlay::Shapes;
