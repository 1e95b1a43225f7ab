//! Rotation maps.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

/// The rotation by |φ| rad about φ: exp(φ*), as a quaternion that turns the same way.
///
/// Right to rounding for any length of φ, zero included.
#[must_use]
pub fn exp(rotation_vector: &Vector3<f64>) -> UnitQuaternion<f64> {
    let half = 0.5 * rotation_vector.norm();
    // sin(h)/h by its first terms where h² is lost against 1: no 0/0.
    let scale = if half < 1e-8 { 0.5 } else { 0.5 * libm::sin(half) / half };
    UnitQuaternion::new_unchecked(Quaternion::from_parts(libm::cos(half), rotation_vector * scale))
}

/// ω*, the matrix with ω* r = ω × r for every r; a rotation that turns at ω (world axes) has Ṙ = ω* R.
#[must_use]
pub fn cross_product_matrix(omega: &Vector3<f64>) -> Matrix3<f64> {
    let [x, y, z] = (*omega).into();
    Matrix3::new(0.0, -z, y, z, 0.0, -x, -y, x, 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn multiplies_as_the_cross_product_to_the_last_bit() {
        let (omega, r) = (Vector3::new(0.3, -1.7, 2.9), Vector3::new(-5.1, 0.01, 7.7));
        assert_eq!(cross_product_matrix(&omega) * r, omega.cross(&r));
        assert_eq!(cross_product_matrix(&omega).transpose(), -cross_product_matrix(&omega));
    }
}
