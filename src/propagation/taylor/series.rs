use super::drive::Drive;
use super::row::Row;
use crate::numerics::Four;

/// The highest order of the series.
pub(super) const ORDER_MAX: usize = 24;

/// The coefficients of one vector, by order.
pub(super) type Rows = [Row; ORDER_MAX + 1];

const NO_ROWS: Rows = [Row::ZERO; ORDER_MAX + 1];

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
    pub rates: Vectors,
    /// Body images Rᵀ w of the couples' world vectors.
    pub images: [Vectors; 3],
    /// Body image of the direction from the attracting centre.
    pub radial: Vectors,
    /// Body image of the orbit's pole.
    pub pole: Vectors,
    /// (ω − n pole) · unit: the rates relative to the orbit.
    pub relative: Vectors,
    /// Of the reference point, world axes, m.
    pub position: Rows,
    /// v · unit, world axes, m.
    pub velocity: Rows,
    /// What changes with time, if anything does.
    pub drive: Option<Box<Drive>>,
}

/// Coefficients (x, y, z) with their copies (y, z, x), which products of vectors need.
#[derive(Debug, Clone)]
pub(super) struct Vectors {
    pub rows: Rows,
    pub turned: Rows,
}

impl Vectors {
    const NONE: Self = Self { rows: NO_ROWS, turned: NO_ROWS };

    #[inline(always)]
    pub fn set(&mut self, k: usize, row: Row) {
        self.rows[k] = row;
        self.turned[k] = row.turned();
    }

    /// Coefficient k and its copy.
    #[inline(always)]
    pub fn load<F: Four>(&self, proof: F::Proof, k: usize) -> [F; 2] {
        [self.rows[k].load(proof), self.turned[k].load(proof)]
    }

    #[inline(always)]
    pub fn store<F: Four>(&mut self, k: usize, row: F) {
        self.rows[k] = Row(row.store());
        self.turned[k] = Row(row.turned().store());
    }

    /// Coefficient k from (z, x, y): each copy takes one turn.
    #[inline(always)]
    pub fn store_turned_back<F: Four>(&mut self, k: usize, row: F) {
        self.rows[k] = Row(row.turned().store());
        self.turned[k] = Row(row.turned_back().store());
    }
}

impl Series {
    pub fn new() -> Self {
        Self {
            attitude: NO_ROWS,
            rates: Vectors::NONE,
            images: [Vectors::NONE; 3],
            radial: Vectors::NONE,
            pole: Vectors::NONE,
            relative: Vectors::NONE,
            position: NO_ROWS,
            velocity: NO_ROWS,
            drive: None,
        }
    }
}
