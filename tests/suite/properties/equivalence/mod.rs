//! One motion told in different ways is one motion: the same body as solids, mesh, particles, tensor and parts; its
//! problem turned in the world, told in other body axes, cut in time, begun later.
//!
//! All goes by scenes, planned and recorded as they are for anybody: what is compared are recorded columns. Two tellings
//! differ by roundings of their numbers, so how far two motions may part is measured for each: [`Case::room`].

mod case;
mod descriptions;
mod fixed_child;
mod frames;
mod kinds;
mod times;

use case::{Case, Row, bodies, case};
use kinds::{Kind, Span};
