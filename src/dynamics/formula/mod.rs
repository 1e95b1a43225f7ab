//! A load as text: a formula of time and motion, read into a tree and laid out as operations on a tape.
//!
//! What a formula can name, and the functions it can call, is what [`Variable`] and [`Function`] list and nothing else: a
//! formula computes, and that is all it does. Its length, depth and number of operations are bounded.

mod expression;
mod names;
mod read;

pub use expression::{Expression, FormulaError, Known, Operator};
pub use names::{Function, Variable};
