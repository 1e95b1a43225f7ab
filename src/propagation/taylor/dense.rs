use std::ops::Range;

use super::row::Row;
use super::series::Rows;
use super::sums::Sums;

/// Samples evaluated side by side.
pub(super) const LANES: usize = 8;

/// One vector over a step: its compensated value at the start, plus a polynomial in σ without the term of order 0.
pub(super) struct Polynomials<'a> {
    /// At the start of the step.
    pub start: &'a Sums,
    /// The coefficients; that of order 0 is not used.
    pub rows: &'a Rows,
    /// The highest order, even.
    pub order: usize,
    /// What the coefficients have to be multiplied by: 1 / the series' unit for rates, 1 for the rest.
    pub factor: f64,
}

impl Polynomials<'_> {
    /// The value at one σ, for the next step to start from. Even and odd orders apart: half the chain.
    #[inline(always)]
    pub fn after(&self, sigma: f64) -> Sums {
        let (sigma, square) = (Row::splat(sigma), Row::splat(sigma * sigma));
        let (mut odd, mut even) = (Row::ZERO, Row::ZERO);
        for pair in self.rows[1..=self.order].rchunks_exact(2) {
            odd = odd * square + pair[0];
            even = even * square + pair[1];
        }
        let increments = (odd + even * sigma) * sigma;
        let mut value = *self.start;
        value.add(increments * Row::splat(self.factor));
        value
    }

    /// Writes the values at several σ into rows of columns, a column at a time: each sample by the same operations
    /// whatever stands beside it, so that a sample's bits do not depend on how the times were dealt out.
    #[inline(always)]
    pub fn write(&self, sigmas: &[f64; LANES], columns: &mut [Vec<f64>], rows: &Range<usize>) {
        for (component, column) in columns.iter_mut().enumerate() {
            let mut sums = [0.0; LANES];
            for row in self.rows[1..=self.order].iter().rev() {
                let coefficient = row.0[component];
                for (sum, sigma) in sums.iter_mut().zip(sigmas) {
                    *sum = (*sum + coefficient) * sigma;
                }
            }
            let (high, low) = (self.start.high.0[component], self.start.low.0[component]);
            for (value, sum) in column[rows.clone()].iter_mut().zip(sums) {
                *value = high + (low + sum * self.factor);
            }
        }
    }
}

/// Scales quaternions in columns to unit length.
pub(super) fn normalise([w, x, y, z]: &mut [Vec<f64>; 4], rows: Range<usize>) {
    for i in rows {
        let length = (w[i] * w[i] + x[i] * x[i] + y[i] * y[i] + z[i] * z[i]).sqrt();
        for column in [&mut *w, &mut *x, &mut *y, &mut *z] {
            column[i] /= length;
        }
    }
}
