use super::row::Row;
use super::series::{ORDER_MAX, RECIPROCAL, Rows, Vectors};
use crate::numerics::Four;

/// Coefficients k and k + 1 of a product of two series. Two at a time: what is loaded serves both.
#[derive(Debug, Clone, Copy)]
pub(super) struct Two<T> {
    now: T,
    ahead: T,
}

impl<F: Four> Two<F> {
    #[inline(always)]
    pub fn none(proof: F::Proof) -> Self {
        Self { now: F::splat(proof, 0.0), ahead: F::splat(proof, 0.0) }
    }

    /// Coefficient k without what the factors of order k contribute; coefficient k + 1 without those of order k + 1.
    #[inline(always)]
    pub fn older(self, k: usize, ends: impl Fn(usize, usize) -> F) -> [F; 2] {
        [self.now, if k > 0 { self.ahead + ends(1, k) } else { self.ahead }]
    }

    /// Coefficient k with its newest factors, by `ends` of their orders.
    #[inline(always)]
    pub fn now(self, k: usize, ends: impl Fn(usize, usize) -> F) -> F {
        self.now + ends(0, k)
    }

    /// Coefficient k + 1 with its newest factors.
    #[inline(always)]
    pub fn ahead(self, k: usize, ends: impl Fn(usize, usize) -> F) -> F {
        let sum = if k > 0 { self.ahead + ends(1, k) } else { self.ahead };
        sum + ends(0, k + 1)
    }
}

/// Σ a(j) b(k − j), component by component, without the factors of order k (of both coefficients) and k + 1: what is
/// newest comes last, or every sum would have to wait for it.
#[inline(always)]
fn convolve<F: Four>(proof: F::Proof, a: &Rows, b: &Rows, k: usize) -> Two<F> {
    let mut sums = Two::none(proof);
    let k = k.min(ORDER_MAX);
    if k < 2 {
        return sums;
    }
    let mut before = b[k - 1].load::<F>(proof);
    sums.now = a[1].load::<F>(proof) * before;
    // An even number of products, by twos: four sums that do not wait for each other.
    let mut others = Two::<F>::none(proof);
    for (a, b) in a[2..k].chunks_exact(2).zip(b[1..k - 1].rchunks_exact(2)) {
        let [a, next_a] = [a[0].load::<F>(proof), a[1].load::<F>(proof)];
        let [b, next_b] = [b[1].load::<F>(proof), b[0].load::<F>(proof)];
        sums.now = sums.now + a * b;
        sums.ahead = sums.ahead + a * before;
        others.now = others.now + next_a * next_b;
        others.ahead = others.ahead + next_a * b;
        before = next_b;
    }
    Two { now: sums.now + others.now, ahead: sums.ahead + others.ahead }
}

/// (a₁a₂, a₂a₃, a₃a₁) without the newest factors: to be turned.
#[inline(always)]
pub(super) fn cyclic<F: Four>(proof: F::Proof, a: &Vectors, k: usize) -> Two<F> {
    convolve(proof, &a.rows, &a.turned, k)
}

/// What the factors of two orders contribute to the coefficient of their sum.
#[inline(always)]
pub(super) fn cyclic_ends<F: Four>(proof: F::Proof, a: &Vectors) -> impl Fn(usize, usize) -> F {
    #[inline(always)]
    move |j, k| {
        let ([first, first_turned], [last, last_turned]): ([F; 2], [F; 2]) = (a.load(proof, j), a.load(proof, k));
        let sum = first * last_turned;
        if j == k { sum } else { sum + last * first_turned }
    }
}

/// The last, first and second component of a × b without the newest factors: to be turned.
#[inline(always)]
pub(super) fn cross<F: Four>(proof: F::Proof, a: &Vectors, b: &Vectors, k: usize) -> Two<F> {
    let plus = convolve::<F>(proof, &a.rows, &b.turned, k);
    let minus = convolve::<F>(proof, &a.turned, &b.rows, k);
    Two { now: plus.now - minus.now, ahead: plus.ahead - minus.ahead }
}

/// What the factors of two orders contribute to the coefficient of their sum.
#[inline(always)]
pub(super) fn cross_ends<F: Four>(proof: F::Proof, a: &Vectors, b: &Vectors) -> impl Fn(usize, usize) -> F {
    #[inline(always)]
    move |j, k| {
        let sum = crossed::<F>(a.load(proof, j), b.load(proof, k));
        if j == k { sum } else { sum + crossed::<F>(a.load(proof, k), b.load(proof, j)) }
    }
}

#[inline(always)]
fn crossed<F: Four>(a: [F; 2], b: [F; 2]) -> F {
    a[0] * b[1] - a[1] * b[0]
}

/// Coefficients k + 1 and k + 2 of q by q' = ½ q ω, from those of ω up to k + 1.
#[inline(always)]
pub(super) fn turn<F: Four>(proof: F::Proof, q: &mut Rows, rates: &Rows, k: usize, newest: F) -> F {
    let k = k.min(ORDER_MAX - 2);
    let none = [F::splat(proof, 0.0); 3];
    let (mut now, mut ahead) = (none, none);
    let mut before = components::<F>(proof, &rates[k + 1]);
    for (q, rates) in q[..k].iter().zip(rates[1..=k].iter().rev()) {
        let (q, spread) = (q.load::<F>(proof), components::<F>(proof, rates));
        for i in 0..3 {
            now[i] = now[i] + q * spread[i];
            ahead[i] = ahead[i] + q * before[i];
        }
        before = spread;
    }
    let (by_first, by_second) = (&HAMILTON[k + 1], &HAMILTON[k + 2]);
    let next = hamilton(proof, now, by_first) + with_rates(proof, newest, &rates[0], by_first);
    let older = hamilton(proof, ahead, by_second) + with_rates(proof, newest, &rates[1], by_second);
    let after = older + with_rates(proof, next, &rates[0], by_second);
    q[k + 1] = Row(next.store());
    q[k + 2] = Row(after.store());
    after
}

/// The quaternion product ½ q (0, ω) / k from q times each component of ω.
#[inline(always)]
fn hamilton<F: Four>(proof: F::Proof, [x, y, z]: [F; 3], [by_x, by_y, by_z]: &[Row; 3]) -> F {
    x.swapped() * by_x.load(proof)
        + y.halves_swapped() * by_y.load(proof)
        + z.swapped().halves_swapped() * by_z.load(proof)
}

/// The same from q and ω: all that has to wait for q is one product and the sum.
#[inline(always)]
fn with_rates<F: Four>(proof: F::Proof, q: F, rates: &Row, by: &[Row; 3]) -> F {
    let [x, y, z] = components::<F>(proof, rates);
    let swapped = q.swapped();
    swapped * (x * by[0].load(proof))
        + (q.halves_swapped() * (y * by[1].load(proof)) + swapped.halves_swapped() * (z * by[2].load(proof)))
}

/// ½/k, with the signs of the products with each component.
const HAMILTON: [[Row; 3]; ORDER_MAX + 1] = {
    let mut table = [[Row::ZERO; 3]; ORDER_MAX + 1];
    let mut k = 1;
    while k <= ORDER_MAX {
        let half = 0.5 * RECIPROCAL[k];
        table[k] = [Row([-half, half, half, -half]), Row([-half, -half, half, half]), Row([-half, half, -half, half])];
        k += 1;
    }
    table
};

#[inline(always)]
fn components<F: Four>(proof: F::Proof, row: &Row) -> [F; 3] {
    let Row([x, y, z, _]) = *row;
    [F::splat(proof, x), F::splat(proof, y), F::splat(proof, z)]
}
