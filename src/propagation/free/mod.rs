//! Torque-free rotation in closed form: [`FreeRotation`].
//!
//! Constants and phases are worked out in double-double from inputs taken as exact; a sample costs one series in f64,
//! whatever its time. Derivation after `[CFSZ08]`, with theta functions of the squared nome for the attitude.

mod invariants;
mod polhode_rates;
mod reversals;
mod rotation;
mod separatrix;
mod symmetric;
mod tri_axial;
mod uniform;

pub use reversals::Reversals;
pub use rotation::FreeRotation;
