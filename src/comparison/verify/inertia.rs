use nalgebra::{Matrix3, SMatrix, SVector, SymmetricEigen, Vector3};

use super::series::Series;
use crate::body::MassProperties;

/// The inertia for which R I ω is most nearly constant: what body turns like that if no torque acts.
#[derive(Debug, Clone, PartialEq)]
pub struct InertiaFit {
    /// Body axes, its trace 1: the motion tells it up to scale.
    pub tensor: Matrix3<f64>,
    /// Principal moments, ascending, the largest 1.
    pub ratios: [f64; 3],
    /// Root mean square of R I ω − L over |L|: how nearly.
    pub residual: f64,
}

/// Samples looked at.
const MOST_SAMPLES: usize = 4000;
/// How much worse the next best tensor must fit, in mean squares, for the motion to tell.
const CLEAR: f64 = 1e3;

type Gram = SMatrix<f64, 9, 9>;

impl InertiaFit {
    /// Of a series with attitudes; `None` where the motion does not tell (a spin about a fixed axis does not), or no
    /// body has what fits.
    ///
    /// I and L are the nine unknowns of R I ω − L = 0 at every sample: the eigenvector of the smallest eigenvalue.
    pub(super) fn of(series: &Series) -> Option<Self> {
        if series.attitude.is_empty() || series.len() < 8 {
            return None;
        }
        let (rate, stride) = (series.rate(), series.len().div_ceil(MOST_SAMPLES));
        let mut gram = Gram::zeros();
        let mut count = 0.0;
        for k in (0..series.len()).step_by(stride) {
            let rotation = series.attitude[k].to_rotation_matrix();
            let [x, y, z] = (series.omega[k] / rate).into();
            // I ω of xx, yy, zz, xy, xz, yz.
            let product = SMatrix::<f64, 3, 6>::from_row_slice(&[
                x, 0.0, 0.0, y, z, 0.0, //
                0.0, y, 0.0, x, 0.0, z, //
                0.0, 0.0, z, 0.0, x, y,
            ]);
            let mut rows = SMatrix::<f64, 3, 9>::zeros();
            rows.fixed_columns_mut::<6>(0).copy_from(&(rotation.matrix() * product));
            rows.fixed_columns_mut::<3>(6).copy_from(&-Matrix3::identity());
            gram += rows.transpose() * rows;
            count += 1.0;
        }
        let eigen = SymmetricEigen::new(gram / count);
        let mut order: Vec<usize> = (0..9).collect();
        order.sort_by(|i, j| eigen.eigenvalues[*i].total_cmp(&eigen.eigenvalues[*j]));
        let (least, next) = (eigen.eigenvalues[order[0]], eigen.eigenvalues[order[1]]);
        if next <= CLEAR * least.max(64.0 * f64::EPSILON) {
            return None;
        }
        Self::from_solution(&eigen.eigenvectors.column(order[0]).into_owned(), least)
    }

    fn from_solution(solution: &SVector<f64, 9>, least: f64) -> Option<Self> {
        let [xx, yy, zz, xy, xz, yz] = std::array::from_fn(|i| solution[i]);
        let trace = xx + yy + zz;
        let momentum = Vector3::new(solution[6], solution[7], solution[8]).norm();
        if trace == 0.0 || momentum == 0.0 {
            return None;
        }
        let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz) / trace;
        let properties = MassProperties::from_tensor(None, tensor).ok()?;
        let mut moments: [f64; 3] = properties.moments.vector().into();
        moments.sort_by(f64::total_cmp);
        let largest = moments[2];
        Some(Self {
            tensor,
            ratios: moments.map(|moment| moment / largest),
            // An eigenvalue is no smaller than its rounding.
            residual: least.max(f64::EPSILON).sqrt() / momentum,
        })
    }
}
