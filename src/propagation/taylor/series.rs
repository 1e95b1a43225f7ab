/// The highest order of the series.
pub(super) const ORDER_MAX: usize = 24;

/// One Taylor coefficient of a vector or quaternion; three-vectors leave the last place 0, for whole registers.
pub(super) type Row = [f64; 4];
/// The coefficients of one vector, by order.
pub(super) type Rows = [Row; ORDER_MAX + 1];

const NO_ROWS: Rows = [[0.0; 4]; ORDER_MAX + 1];

/// 1/k. At k = 1 and 2, where rounding would count, they are exact.
pub(super) const RECIPROCAL: [f64; ORDER_MAX + 1] = {
    let mut table = [0.0; ORDER_MAX + 1];
    let mut k = 1;
    let mut divisor = 1.0;
    while k <= ORDER_MAX {
        table[k] = 1.0 / divisor;
        divisor += 1.0;
        k += 1;
    }
    table
};

/// The motion over one step as power series in σ = (t − start) / unit.
///
/// The unit is a power of two near the step itself: the coefficients then neither overflow nor underflow, however fast
/// or slow the body, and no bit depends on it.
#[derive(Debug, Clone)]
pub(super) struct Series {
    /// World from principal axes: w, x, y, z.
    pub attitude: Rows,
    /// ω · unit, principal axes.
    pub rates: Rows,
    /// Body images Rᵀ w of the couples' world vectors.
    pub images: [Rows; 3],
    /// Body image of the direction from the attracting centre.
    pub radial: Rows,
    /// Body image of the orbit's pole.
    pub pole: Rows,
    /// (ω − n pole) · unit: the rates relative to the orbit.
    pub relative: Rows,
    /// Of the reference point, world axes, m.
    pub position: Rows,
    /// v · unit, world axes, m.
    pub velocity: Rows,
}

impl Series {
    pub fn new() -> Self {
        Self {
            attitude: NO_ROWS,
            rates: NO_ROWS,
            images: [NO_ROWS; 3],
            radial: NO_ROWS,
            pole: NO_ROWS,
            relative: NO_ROWS,
            position: NO_ROWS,
            velocity: NO_ROWS,
        }
    }
}

/// Coefficient k of the products of a with each of three components of b: the three sums Σ a(j) b(k − j).
#[inline]
pub(super) fn products(a: &Rows, b: &Rows, k: usize) -> [Row; 3] {
    let mut sums = [[0.0; 4]; 3];
    for (a, b) in a[..=k].iter().zip(b[..=k].iter().rev()) {
        for (sum, b) in sums.iter_mut().zip(b) {
            for (sum, a) in sum.iter_mut().zip(a) {
                *sum += a * b;
            }
        }
    }
    sums
}

/// a × b from [`products`].
#[inline]
pub(super) fn cross([x, y, z]: [Row; 3]) -> Row {
    [z[1] - y[2], x[2] - z[0], y[0] - x[1], 0.0]
}

/// The quaternion product a (0, b) from [`products`].
#[inline]
pub(super) fn hamilton([x, y, z]: [Row; 3]) -> Row {
    [-(x[1] + y[2] + z[3]), x[0] - y[3] + z[2], x[3] + y[0] - z[1], y[1] - x[2] + z[0]]
}

/// Coefficient k of (a₂a₃, a₃a₁, a₁a₂).
#[inline]
pub(super) fn cyclic_products(a: &Rows, k: usize) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for (a, b) in a[..=k].iter().zip(a[..=k].iter().rev()) {
        sums[0] += a[1] * b[2];
        sums[1] += a[2] * b[0];
        sums[2] += a[0] * b[1];
    }
    sums
}
