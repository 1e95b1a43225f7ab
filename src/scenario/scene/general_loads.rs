#[cfg(feature = "serde")]
use serde::Deserialize;

use super::Frame;
use super::loads::windowed;

windowed! {
    /// A moment by formulae of time and motion.
    TorqueFormulaSpec {
        /// x, y and z, N m, each as text.
        moment_n_m: [String; 3],
        /// The axes of the components.
        frame: Frame,
    }
}
windowed! {
    /// A force by formulae of time and motion.
    ForceFormulaSpec {
        /// x, y and z, N, each as text.
        force_n: [String; 3],
        /// The axes of the components.
        frame: Frame,
        /// Where it acts, in body axes, from the body's origin, m.
        point_m: [f64; 3],
    }
}
