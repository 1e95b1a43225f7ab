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
    let mut turned = series.attitude;
    for q in &mut turned[..order] {
        *q = times_vector(*q, terms.body_acceleration);
    }
    let mut constant = terms.world_acceleration;
    for k in 0..order {
        let next = Row::splat(RECIPROCAL[k + 1]);
        series.velocity[k + 1] = (constant + conjugate_product(&turned, &series.attitude, k)) * next;
        series.position[k + 1] = series.velocity[k] * next;
        constant = Row::ZERO;
    }
}

/// v' = world acceleration + R b, x' = v, where both change with time.
pub(super) fn driven(terms: &Terms, series: &mut Series, order: usize) {
    let Some(drive) = series.drive.take() else { return };
    let order = order.min(ORDER_MAX);
    let mut body = drive.body_acceleration;
    for (sum, constant) in body[0].iter_mut().zip(terms.body_acceleration) {
        *sum += constant;
    }
    let mut turned = [Row::ZERO; ORDER_MAX + 1];
    for (k, sum) in turned[..order].iter_mut().enumerate() {
        for (b, q) in body.iter().zip(series.attitude[..=k].iter().rev()) {
            *sum += times_vector(*q, *b);
        }
    }
    for k in 0..order {
        let next = Row::splat(RECIPROCAL[k + 1]);
        let mut acceleration = conjugate_product(&turned, &series.attitude, k);
        acceleration += drive.world_acceleration.get(k).copied().unwrap_or(Row::ZERO);
        acceleration += if k == 0 { terms.world_acceleration } else { Row::ZERO };
        series.velocity[k + 1] = acceleration * next;
        series.position[k + 1] = series.velocity[k] * next;
    }
    series.drive = Some(drive);
}

/// q (0, b), by itself a quaternion.
#[inline(always)]
fn times_vector(Row([w, i, j, k]): Row, [x, y, z]: [f64; 3]) -> Row {
    Row([-(i * x + j * y + k * z), w * x + j * z - k * y, w * y + k * x - i * z, w * z + i * y - j * x])
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
