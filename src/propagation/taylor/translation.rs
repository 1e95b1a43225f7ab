use super::row::Row;
use super::series::{ORDER_MAX, RECIPROCAL, Rows, Series};
use super::terms::Terms;
use crate::numerics::vectorised;

/// v' = world acceleration, x' = v: polynomials of order 1 and 2.
pub(super) fn fall(terms: &Terms, series: &mut Series) {
    series.velocity[1] = terms.world_acceleration;
    series.position[1] = series.velocity[0];
    series.position[2] = Row::splat(0.5) * series.velocity[1];
}

/// v' = world acceleration + R b, x' = v, with R b = q b q* from the finished series of q.
pub(super) fn thrust(terms: &Terms, series: &mut Series, order: usize) {
    vectorised(
        #[inline(always)]
        || thrust_inline(terms, series, order.min(ORDER_MAX)),
    );
}

#[inline(always)]
fn thrust_inline(terms: &Terms, series: &mut Series, order: usize) {
    let [x, y, z] = terms.body_acceleration;
    let mut turned = series.attitude;
    for Row([w, i, j, k]) in &mut turned[..order] {
        // q (0, b), by itself a quaternion.
        (*w, *i, *j, *k) =
            (-(*i * x + *j * y + *k * z), *w * x + *j * z - *k * y, *w * y + *k * x - *i * z, *w * z + *i * y - *j * x);
    }
    let mut constant = terms.world_acceleration;
    for k in 0..order {
        let next = Row::splat(RECIPROCAL[k + 1]);
        series.velocity[k + 1] = (constant + conjugate_product(&turned, &series.attitude, k)) * next;
        series.position[k + 1] = series.velocity[k] * next;
        constant = Row::ZERO;
    }
}

/// The vector part of Σ a(j) b*(k − j).
#[inline(always)]
fn conjugate_product(a: &Rows, b: &Rows, k: usize) -> Row {
    let mut sums = [Row::ZERO; 4];
    for (a, b) in a[..=k].iter().zip(b[..=k].iter().rev()) {
        for i in 0..4 {
            sums[i] += *a * b.spread(i);
        }
    }
    let [Row(w), Row(x), Row(y), Row(z)] = sums;
    Row::from_vector([(w[1] - x[0]) + (y[3] - z[2]), (w[2] - y[0]) + (z[1] - x[3]), (w[3] - z[0]) + (x[2] - y[1])])
}
