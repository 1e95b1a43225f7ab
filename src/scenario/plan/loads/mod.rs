//! What acts on a body: constants with windows, functions of time from tables, pulses and rotors, and the kinds that go by
//! a tape.

mod general;
mod plan;
mod profiles;
mod springs;
mod table_file;

pub use plan::{plan, rotors};
