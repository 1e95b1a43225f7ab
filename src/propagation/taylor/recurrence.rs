use std::array::from_fn;

use super::products::{Two, cross, cross_ends, cyclic, cyclic_ends, turn};
use super::row::Row;
use super::series::{ORDER_MAX, RECIPROCAL, Series};
use super::terms::Terms;
use crate::dynamics::Combined;
use crate::numerics::{Four, Kernel, in_registers};

/// Fills the series of one kind of problem up to an even order, from the coefficients of order 0.
pub(super) type Recurrence = fn(&Terms, &mut Series, usize);

/// The recurrence that does what these loads need and nothing else: chosen once for each span.
pub(super) fn recurrence_for(loads: &Combined, with_attitude: bool) -> Recurrence {
    if loads.driven.is_some() {
        return match (with_attitude, loads.couples.len(), loads.gradient.is_some()) {
            (false, ..) => rotation::<false, 0, false, true>,
            (true, 0, false) => rotation::<true, 0, false, true>,
            (true, _, false) => rotation::<true, 3, false, true>,
            (true, 0, true) => rotation::<true, 0, true, true>,
            (true, _, true) => rotation::<true, 3, true, true>,
        };
    }
    match (with_attitude, loads.couples.len(), loads.gradient.is_some()) {
        (false, ..) => rotation::<false, 0, false, false>,
        (true, 0, false) => rotation::<true, 0, false, false>,
        (true, 1, false) => rotation::<true, 1, false, false>,
        (true, 2, false) => rotation::<true, 2, false, false>,
        (true, _, false) => rotation::<true, 3, false, false>,
        (true, 0, true) => rotation::<true, 0, true, false>,
        (true, 1, true) => rotation::<true, 1, true, false>,
        (true, 2, true) => rotation::<true, 2, true, false>,
        (true, _, true) => rotation::<true, 3, true, false>,
    }
}

fn rotation<const ATTITUDE: bool, const IMAGES: usize, const GRADIENT: bool, const DRIVEN: bool>(
    terms: &Terms,
    series: &mut Series,
    order: usize,
) {
    in_registers(Rotation::<ATTITUDE, IMAGES, GRADIENT, DRIVEN> { terms, series, order: order.min(ORDER_MAX) });
}

/// The bilinear system, time in the series' unit:
/// ω' = coupling (ω₂ω₃, …) + I⁻¹ (τ + Σ A u − c ω) + gradient (r₂r₃, …), q' = ½ q ω, u' = u × ω,
/// r' = r × (ω − n p), p' = p × ω. Each product is a convolution of coefficients `[JZ05]`. What is driven adds polynomials
/// of time, times 1, u or ω.
///
/// Two orders at a time: what both have in common is summed once, and the chain from one coefficient to the next is
/// left with a turn, a product and two sums.
struct Rotation<'a, const ATTITUDE: bool, const IMAGES: usize, const GRADIENT: bool, const DRIVEN: bool> {
    terms: &'a Terms,
    series: &'a mut Series,
    order: usize,
}

impl<const ATTITUDE: bool, const IMAGES: usize, const GRADIENT: bool, const DRIVEN: bool> Kernel
    for Rotation<'_, ATTITUDE, IMAGES, GRADIENT, DRIVEN>
{
    type Output = ();

    #[inline(always)]
    fn run<F: Four>(self, proof: F::Proof) {
        let Self { terms, series, order } = self;
        let mut newest_rates = series.rates.rows[0].load::<F>(proof).turned_back();
        let mut newest_attitude = series.attitude[0].load::<F>(proof);
        let mut k = 0;
        while k < order {
            newest_rates = two::<F, IMAGES, GRADIENT, DRIVEN>(proof, terms, series, k, newest_rates);
            // The attitude comes a step behind, so as not to wait for what has just been begun.
            if ATTITUDE && k > 0 {
                let Series { attitude, rates, .. } = &mut *series;
                newest_attitude = turn::<F>(proof, attitude, &rates.rows, k - 2, newest_attitude);
            }
            k += 2;
        }
        if ATTITUDE && k > 0 {
            turn::<F>(proof, &mut series.attitude, &series.rates.rows, k - 2, newest_attitude);
        }
    }
}

/// Coefficients k + 1 and k + 2 of all but the attitude.
#[inline(always)]
fn two<F: Four, const IMAGES: usize, const GRADIENT: bool, const DRIVEN: bool>(
    proof: F::Proof,
    terms: &Terms,
    series: &mut Series,
    k: usize,
    newest_rates: F,
) -> F {
    if GRADIENT {
        set_relative::<F>(proof, terms, series, k);
    }
    let [now, ahead] = cyclic::<F>(proof, &series.rates, k).older(k, cyclic_ends(proof, &series.rates));
    let mut images = [Two::none(proof); IMAGES];
    for (product, image) in images.iter_mut().zip(&series.images) {
        *product = cross::<F>(proof, image, &series.rates, k);
    }
    let [mut tidal, mut radial, mut pole] = [Two::none(proof); 3];
    if GRADIENT {
        tidal = cyclic(proof, &series.radial, k);
        radial = cross(proof, &series.radial, &series.relative, k);
        pole = cross(proof, &series.pole, &series.rates, k);
    }

    let next = F::splat(proof, RECIPROCAL[k + 1]);
    let tide = tidal.now(k, cyclic_ends(proof, &series.radial));
    let rest = others::<F, IMAGES, GRADIENT, DRIVEN>(proof, terms, series, k, tide);
    let next_images =
        from_fn::<_, IMAGES, _>(|i| images[i].now(k, cross_ends(proof, &series.images[i], &series.rates)));
    if GRADIENT {
        let next_radial = radial.now(k, cross_ends(proof, &series.radial, &series.relative));
        let next_pole = pole.now(k, cross_ends(proof, &series.pole, &series.rates));
        series.radial.store(k + 1, next_radial.turned() * next);
        series.pole.store(k + 1, next_pole.turned() * next);
    }
    for (image, sum) in series.images.iter_mut().zip(next_images) {
        image.store(k + 1, sum.turned() * next);
    }
    let rates = next_rates(proof, terms, series, k, [now, rest, newest_rates]);
    series.rates.store_turned_back(k + 1, rates);
    if GRADIENT {
        set_relative::<F>(proof, terms, series, k + 1);
    }

    let next = F::splat(proof, RECIPROCAL[k + 2]);
    let tide = tidal.ahead(k, cyclic_ends(proof, &series.radial));
    let rest = others::<F, IMAGES, GRADIENT, DRIVEN>(proof, terms, series, k + 1, tide);
    let next_images =
        from_fn::<_, IMAGES, _>(|i| images[i].ahead(k, cross_ends(proof, &series.images[i], &series.rates)));
    if GRADIENT {
        let next_radial = radial.ahead(k, cross_ends(proof, &series.radial, &series.relative));
        let next_pole = pole.ahead(k, cross_ends(proof, &series.pole, &series.rates));
        series.radial.store(k + 2, next_radial.turned() * next);
        series.pole.store(k + 2, next_pole.turned() * next);
    }
    for (image, sum) in series.images.iter_mut().zip(next_images) {
        image.store(k + 2, sum.turned() * next);
    }
    let rates = next_rates(proof, terms, series, k + 1, [ahead, rest, rates]);
    series.rates.store_turned_back(k + 2, rates);
    rates
}

/// Coefficient k + 1 of ω as (z, x, y), from coefficient k in the same order, the older products of ω, and the rest of
/// coefficient k of ω̇. All that has to wait for coefficient k is a turn, a product and two sums.
#[inline(always)]
fn next_rates<F: Four>(proof: F::Proof, terms: &Terms, series: &Series, k: usize, [older, rest, newest]: [F; 3]) -> F {
    let next = F::splat(proof, RECIPROCAL[k + 1]);
    let coupling = terms.coupling.load::<F>(proof).turned_back() * next;
    let damping = terms.damping.load::<F>(proof).turned_back() * next;
    let [first, first_turned]: [F; 2] = series.rates.load(proof, 0);
    let older = (older * coupling + rest.turned_back() * next) - newest * damping;
    if k == 0 {
        return older + (first * first_turned) * coupling;
    }
    older + (newest.turned_back() * (first * coupling) + newest.turned() * (first_turned * coupling))
}

/// Coefficient k of ω relative to the orbit.
#[inline(always)]
fn set_relative<F: Four>(proof: F::Proof, terms: &Terms, series: &mut Series, k: usize) {
    let orbit = F::splat(proof, terms.mean_motion) * series.pole.rows[k].load(proof);
    series.relative.store(k, series.rates.rows[k].load::<F>(proof) - orbit);
}

/// Coefficient k of ω̇ but for the gyroscopic part and the damping.
#[inline(always)]
fn others<F: Four, const IMAGES: usize, const GRADIENT: bool, const DRIVEN: bool>(
    proof: F::Proof,
    terms: &Terms,
    series: &Series,
    k: usize,
    tidal: F,
) -> F {
    let constant = if k == 0 { &terms.moment } else { &Row::ZERO };
    let mut sum = constant.load::<F>(proof);
    for (columns, image) in terms.couples.iter().zip(&series.images[..IMAGES]) {
        for (column, component) in columns.iter().zip(image.rows[k].0) {
            sum = sum + column.load::<F>(proof) * F::splat(proof, component);
        }
    }
    if GRADIENT {
        sum = sum + terms.gradient.load::<F>(proof) * tidal.turned();
    }
    if DRIVEN && let Some(drive) = &series.drive {
        sum = sum + drive.rates(proof, series, k);
    }
    sum
}
