use super::series::{ORDER_MAX, RECIPROCAL, Row, Series, cross, cyclic_products, hamilton, products};
use super::terms::Terms;
use crate::dynamics::Combined;

/// Fills the series of one kind of problem up to an order, from the coefficients of order 0.
pub(super) type Recurrence = fn(&Terms, &mut Series, usize);

/// The recurrence that does what these loads need and nothing else: chosen once for each span.
pub(super) fn recurrence_for(loads: &Combined, with_attitude: bool) -> Recurrence {
    match (with_attitude, loads.couples.len(), loads.gradient.is_some()) {
        (false, ..) => rotation::<false, 0, false>,
        (true, 0, false) => rotation::<true, 0, false>,
        (true, 1, false) => rotation::<true, 1, false>,
        (true, 2, false) => rotation::<true, 2, false>,
        (true, _, false) => rotation::<true, 3, false>,
        (true, 0, true) => rotation::<true, 0, true>,
        (true, 1, true) => rotation::<true, 1, true>,
        (true, 2, true) => rotation::<true, 2, true>,
        (true, _, true) => rotation::<true, 3, true>,
    }
}

/// The bilinear system, time in the series' unit:
/// ω' = coupling (ω₂ω₃, …) + I⁻¹ (τ + Σ A u − c ω) + gradient (r₂r₃, …), q' = ½ q ω, u' = u × ω,
/// r' = r × (ω − n h), h' = h × ω. Each product is a convolution of coefficients `[JZ05]`.
fn rotation<const ATTITUDE: bool, const IMAGES: usize, const GRADIENT: bool>(
    terms: &Terms,
    series: &mut Series,
    order: usize,
) {
    let order = order.min(ORDER_MAX);
    for k in 0..order {
        let next = RECIPROCAL[k + 1];
        series.rates[k + 1] = scaled(rate::<IMAGES, GRADIENT>(terms, series, k), next);
        if ATTITUDE {
            series.attitude[k + 1] = scaled(hamilton(products(&series.attitude, &series.rates, k)), 0.5 * next);
        }
        for image in &mut series.images[..IMAGES] {
            image[k + 1] = scaled(cross(products(image, &series.rates, k)), next);
        }
        if GRADIENT {
            for i in 0..3 {
                series.relative[k][i] = series.rates[k][i] - terms.mean_motion * series.pole[k][i];
            }
            series.radial[k + 1] = scaled(cross(products(&series.radial, &series.relative, k)), next);
            series.pole[k + 1] = scaled(cross(products(&series.pole, &series.rates, k)), next);
        }
    }
}

/// Coefficient k of ω'.
#[inline]
fn rate<const IMAGES: usize, const GRADIENT: bool>(terms: &Terms, series: &Series, k: usize) -> Row {
    let gyroscopic = cyclic_products(&series.rates, k);
    let mut rate = [0.0; 4];
    for i in 0..3 {
        rate[i] = terms.coupling[i] * gyroscopic[i] - terms.damping[i] * series.rates[k][i];
    }
    if k == 0 {
        for i in 0..3 {
            rate[i] += terms.moment[i];
        }
    }
    for (couple, image) in terms.couples.iter().zip(&series.images[..IMAGES]) {
        let [x, y, z, _] = image[k];
        for i in 0..3 {
            rate[i] += couple[i][0] * x + couple[i][1] * y + couple[i][2] * z;
        }
    }
    if GRADIENT {
        let tidal = cyclic_products(&series.radial, k);
        for i in 0..3 {
            rate[i] += terms.gradient[i] * tidal[i];
        }
    }
    rate
}

/// v' = world acceleration, x' = v: polynomials of order 1 and 2.
pub(super) fn fall(terms: &Terms, series: &mut Series) {
    for i in 0..3 {
        series.velocity[1][i] = terms.world_acceleration[i];
        series.position[1][i] = series.velocity[0][i];
        series.position[2][i] = 0.5 * series.velocity[1][i];
    }
}

/// v' = world acceleration + R b, x' = v, with R b = q b q* from the finished series of q.
pub(super) fn thrust(terms: &Terms, series: &mut Series, order: usize) {
    let order = order.min(ORDER_MAX);
    let [x, y, z] = terms.body_acceleration;
    let mut turned = series.attitude;
    for [w, i, j, k] in &mut turned[..order] {
        // q (0, b), by itself a quaternion.
        (*w, *i, *j, *k) =
            (-(*i * x + *j * y + *k * z), *w * x + *j * z - *k * y, *w * y + *k * x - *i * z, *w * z + *i * y - *j * x);
    }
    for k in 0..order {
        let mut acceleration = conjugate_product(&turned[..=k], &series.attitude[..=k]);
        if k == 0 {
            for i in 0..3 {
                acceleration[i] += terms.world_acceleration[i];
            }
        }
        series.velocity[k + 1] = scaled(acceleration, RECIPROCAL[k + 1]);
        series.position[k + 1] = scaled(series.velocity[k], RECIPROCAL[k + 1]);
    }
}

/// The vector part of Σ a(j) b*(k − j).
fn conjugate_product(a: &[Row], b: &[Row]) -> Row {
    let mut sum = [0.0; 4];
    for ([aw, ax, ay, az], [bw, bx, by, bz]) in a.iter().zip(b.iter().rev()) {
        sum[0] += ax * bw - aw * bx + az * by - ay * bz;
        sum[1] += ay * bw - aw * by + ax * bz - az * bx;
        sum[2] += az * bw - aw * bz + ay * bx - ax * by;
    }
    sum
}

#[inline]
fn scaled(row: Row, factor: f64) -> Row {
    row.map(|value| value * factor)
}
