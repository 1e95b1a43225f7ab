//! `.mcap` files of other programs: transforms, poses, rates and moments in Foxglove's schemas (protobuf and JSON) and in
//! those of ROS 2 (CDR).

mod cdr;
mod foxglove;
mod json;
mod kinds;
mod read;
mod ros;

pub(in crate::recording) use read::observe;
