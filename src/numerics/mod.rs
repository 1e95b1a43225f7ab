//! Mathematics without bodies in it: elliptic functions, rotation maps, double-double, series.

pub mod so3;
