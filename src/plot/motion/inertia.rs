use nalgebra::{Matrix3, Matrix6, SMatrix, UnitQuaternion, Vector3, Vector6};

use crate::body::MassProperties;

/// Principal moments and axes that pairs of ω and L tell, by least squares: L = I ω in body axes.
#[derive(Debug, Clone, Default)]
pub struct InertiaFit {
    squares: Matrix6<f64>,
    products: Vector6<f64>,
    momentum: f64,
    /// Of ω, so that squares are about 1.
    unit: Option<f64>,
}

/// Smallest part of the largest eigenvalue that still tells an element of the tensor.
const TOLD: f64 = 1e-9;
/// L may be so far from I ω, relative.
const FITS: f64 = 1e-9;

impl InertiaFit {
    /// Another pair, in body axes.
    pub fn push(&mut self, omega: &Vector3<f64>, momentum: &Vector3<f64>) {
        let is_sound = omega.iter().chain(momentum.iter()).all(|part| part.is_finite()) && omega.norm() > 0.0;
        if !is_sound {
            return;
        }
        let unit = *self.unit.get_or_insert(omega.norm());
        let [x, y, z] = (omega / unit).into();
        // Elements xx, yy, zz, xy, xz, yz.
        let rows = SMatrix::<f64, 3, 6>::from_row_slice(&[
            x, 0.0, 0.0, y, z, 0.0, //
            0.0, y, 0.0, x, 0.0, z, //
            0.0, 0.0, z, 0.0, x, y,
        ]);
        self.squares += rows.transpose() * rows;
        self.products += rows.transpose() * (momentum / unit);
        self.momentum += (momentum / unit).norm_squared();
    }

    /// Moments and axes; `None` where the pairs do not tell them all, or tell none.
    #[must_use]
    pub fn properties(&self) -> Option<MassProperties> {
        let eigenvalues = self.squares.symmetric_eigenvalues();
        if eigenvalues.min() <= TOLD * eigenvalues.max() || eigenvalues.max() <= 0.0 {
            return None;
        }
        let elements = self.squares.cholesky()?.solve(&self.products);
        let left = self.momentum - 2.0 * elements.dot(&self.products) + elements.dot(&(self.squares * elements));
        // Squares of a relative error of 1e-9 are below what rounding leaves of their difference.
        if left > (FITS + 1e-14 / TOLD) * self.momentum {
            return None;
        }
        let [xx, yy, zz, xy, xz, yz] = elements.into();
        let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        // Elements beside the diagonal that are rounding would turn the axes.
        let is_diagonal = [xy, xz, yz].iter().all(|element| element.abs() < 1e-6 * (xx + yy + zz));
        if is_diagonal {
            let properties = MassProperties::from_principal(None, [xx, yy, zz]).ok()?;
            return Some(MassProperties { body_from_principal: UnitQuaternion::identity(), ..properties });
        }
        MassProperties::from_tensor(None, tensor).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_in_all_directions_tell_the_tensor() {
        let tensor = Matrix3::new(2.0, 0.1, 0.0, 0.1, 3.0, -0.2, 0.0, -0.2, 4.0);
        let mut fit = InertiaFit::default();
        for index in 0..50 {
            let angle = 0.2 * f64::from(index);
            let omega = 40.0 * Vector3::new(libm::sin(angle), libm::cos(1.3 * angle), 0.4 + libm::sin(2.0 * angle));
            fit.push(&omega, &(tensor * omega));
        }
        let found = fit.properties().expect("all is told").tensor();
        assert!((found - tensor).norm() < 1e-12 * tensor.norm(), "{found}");
    }

    #[test]
    fn a_steady_spin_does_not_tell_it() {
        let mut fit = InertiaFit::default();
        for _ in 0..10 {
            fit.push(&Vector3::z(), &(3.0 * Vector3::z()));
        }
        assert!(fit.properties().is_none());
        assert!(InertiaFit::default().properties().is_none());
    }

    #[test]
    fn what_is_not_proportional_is_no_inertia() {
        let mut fit = InertiaFit::default();
        for index in 0..50 {
            let angle = 0.2 * f64::from(index);
            let omega = Vector3::new(libm::sin(angle), libm::cos(1.3 * angle), 0.4 + libm::sin(2.0 * angle));
            fit.push(&omega, &(omega.component_mul(&omega)));
        }
        assert!(fit.properties().is_none());
    }
}
