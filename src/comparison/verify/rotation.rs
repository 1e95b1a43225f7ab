use nalgebra::{UnitQuaternion, Vector3};

use super::interpolation::Stencil;
use crate::numerics::so3;

/// The rotation vector of the shorter way, rad: its length is 0 to π.
pub fn log(rotation: &UnitQuaternion<f64>) -> Vector3<f64> {
    let sign = if rotation.w < 0.0 { -1.0 } else { 1.0 };
    let imaginary = rotation.imag() * sign;
    let sine = imaginary.norm();
    if sine < 1e-9 {
        return imaginary * 2.0;
    }
    imaginary * (2.0 * libm::atan2(sine, rotation.w * sign) / sine)
}

/// By which rotation vector, body axes, a body turns between two instants at rates ω(t) in body axes, rad.
///
/// Two steps of Magnus' series of order 4 `[HLW06]` §IV.7, with ω at Gauss points from the stencil's polynomial.
pub fn turned(stencil: &Stencil, omega: &[Vector3<f64>], [from, to]: [f64; 2]) -> Vector3<f64> {
    let step = 0.5 * (to - from);
    let one = magnus(stencil, omega, from, step);
    let other = magnus(stencil, omega, from + step, step);
    log(&(so3::exp(&one) * so3::exp(&other)))
}

/// The same by one step: what it differs by tells how far two may be off.
pub fn turned_at_once(stencil: &Stencil, omega: &[Vector3<f64>], [from, to]: [f64; 2]) -> Vector3<f64> {
    log(&so3::exp(&magnus(stencil, omega, from, to - from)))
}

fn magnus(stencil: &Stencil, omega: &[Vector3<f64>], from: f64, step: f64) -> Vector3<f64> {
    const GAUSS: f64 = 0.288_675_134_594_812_9; // √3/6
    let at = |place: f64| stencil.vector(omega, from + place * step);
    let (early, late) = (at(0.5 - GAUSS), at(0.5 + GAUSS));
    0.5 * step * (early + late) + 0.5 * GAUSS * step * step * early.cross(&late)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A body that cones: R(t) = exp(a t) exp(b t), so that ω = b + exp(b t)ᵀ a in body axes.
    #[test]
    fn a_turn_at_changing_rates_is_found_from_samples_of_them() {
        let (a, b) = (Vector3::new(0.3, -0.2, 1.0), Vector3::new(0.9, 0.4, -0.1));
        let attitude = |t: f64| so3::exp(&(a * t)) * so3::exp(&(b * t));
        let rate = |t: f64| b + so3::exp(&(b * t)).inverse() * a;
        let times: Vec<f64> = (0..20).map(|k| 0.05 * f64::from(k)).collect();
        let omega: Vec<_> = times.iter().map(|t| rate(*t)).collect();
        for k in 0..19 {
            let stencil = Stencil::between(&times, k, 6);
            let found = turned(&stencil, &omega, [times[k], times[k + 1]]);
            let truth = log(&(attitude(times[k]).inverse() * attitude(times[k + 1])));
            // Rates of 1 rad/s change within a second: (0.05)⁵ of interpolation, less in the middle.
            assert!((found - truth).norm() < 2e-9, "{k}: {:e}", (found - truth).norm());
        }
    }

    #[test]
    fn logarithms_undo_exponentials_however_small() {
        for size in [1e-300, 1e-12, 1e-9, 0.3, 3.1] {
            let vector = Vector3::new(0.6, 0.0, -0.8) * size;
            assert!((log(&so3::exp(&vector)) - vector).norm() <= 4e-16 * size.max(1e-290));
        }
    }
}
