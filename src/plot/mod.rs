//! Plots and pages, without a viewer.
//!
//! A [`Drawing`] holds lines, areas and words in pixels; [`Drawing::svg`] and [`Drawing::png`] give the same picture, with
//! the same bytes on every machine. [`Axes`] carry values to places, a [`TimeChart`] draws series against time, [`grid`]
//! sets panels side by side. A [`Motion`] takes samples as they are read and draws what is to be seen in them;
//! [`differences`] draws what a comparison has found.

mod axes;
mod chart;
mod clip;
mod differences;
mod drawing;
mod font;
mod format;
mod legend;
mod motion;
mod page;
mod panels;
mod png;
mod scale;
mod simplify;
mod svg;
mod words;

pub use axes::Axes;
pub use chart::{Limit, Mark, Series, TimeChart};
pub use differences::differences;
pub use drawing::{Anchor, Dash, Drawing, Fill, Ink, Line, Point, Rectangle, Shape};
pub use font::text_width;
pub use format::{Format, PlotError};
pub use legend::{Entry, Sign, legend};
pub use motion::{Ellipsoid, Envelope, Motion, Request, View, Wanted};
pub use page::Page;
pub use panels::grid;
pub use scale::{Scale, figure, power_of_ten};
pub use svg::Surroundings;
pub use words::{exactness, grouped, plain_time, words};
