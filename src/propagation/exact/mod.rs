//! What the closed forms share: columns of samples, axes named anew, quaternions in double-double.

mod columns;
mod frame;
mod quaternion;

pub use columns::{Motion, Rates, fill_columns, fill_rates};
pub use frame::Frame;
pub use quaternion::{ExactQuaternion, QuaternionMap};
