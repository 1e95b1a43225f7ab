//! `.rrd` files of other programs: the transforms of entities, on a timeline of times.

mod read;
mod timeline;
mod transform;

pub(in crate::recording) use read::observe;
