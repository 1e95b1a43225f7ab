//! Particles on springs, each by its own equation of motion.
//!
//! The parts: `equations` (the tape of accelerations), `motion` (where all particles are, and how far each spring is
//! stretched), `start`, `series` (over one step), `stepper` (from step to step), `fit` (the attitude of the cloud as a
//! whole), `propagator` (in f64) and `precise` (in double-double).
//!
//! A stiff spring pulls by the small difference of two lengths. Taken from positions in f64, a force would be off by
//! k ε ℓ, which is ε times the inverse of the strain of its size. So positions and velocities are carried in
//! double-double, relative to the centre of mass, and each spring's ℓ² − ℓ₀² and its rate are worked out from them in all
//! these digits at the start of a step. From there on they have series of their own, d/dt ℓ² = 2 d·ḋ, and what is rounded
//! to f64 is the stretch and not the length. A step's way at its first velocity is added in double-double too; the rest
//! of a series in f64 is of the size of the vibration. All that is recorded is so right to f64, strains too.

mod equations;
mod fit;
mod motion;
mod precise;
mod propagator;
mod series;
mod start;
mod stepper;
#[cfg(test)]
mod tests;
mod vector;

pub(super) use precise::PreciseCloud;
pub(super) use propagator::CloudTaylor;
