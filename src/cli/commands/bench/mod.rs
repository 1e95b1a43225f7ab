//! `polhode bench`: what each method costs for how much accuracy.

mod clock;
mod csv;
mod execute;
mod plot;
mod report;

pub use execute::execute;
