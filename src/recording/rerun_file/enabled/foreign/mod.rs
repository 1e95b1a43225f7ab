//! `.rrd` files of other programs: the transforms of entities, on a timeline of times; or numbers by a mapping.

mod read;
mod scalars;
mod timeline;
mod transform;

pub(in crate::recording) use read::observe;
