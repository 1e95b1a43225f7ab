//! Coefficient k of each operation, from those of its operands up to k and its own below k `[GW08]`, `[JZ05]` §2.

use super::{Node, Scalar};

/// The coefficients of all results, a row each.
#[derive(Debug, Clone)]
pub(super) struct Rows<F> {
    width: usize,
    values: Vec<F>,
}

impl<F: Scalar> Rows<F> {
    pub fn new(count: usize, order: usize) -> Self {
        Self { width: order + 1, values: vec![F::from(0.0); count * (order + 1)] }
    }

    pub fn of(&self, node: Node) -> &[F] {
        &self.values[node.0 * self.width..][..self.width]
    }

    pub fn set(&mut self, node: Node, k: usize, value: F) {
        self.values[node.0 * self.width + k] = value;
    }

    /// Of a b.
    pub fn product(&self, a: Node, b: Node, k: usize) -> F {
        F::convolution(&self.of(a)[..=k], &self.of(b)[..=k])
    }

    /// Of a / b: q b = a.
    pub fn quotient(&self, own: Node, a: Node, b: Node, k: usize) -> F {
        let (own, a, b) = (self.of(own), self.of(a), self.of(b));
        // Σ q(j) b(k − j), j < k.
        let known = F::convolution(&own[..k], &b[1..=k]);
        (a[k] - known) / b[0]
    }

    /// Of √a: s² = a. The root of what is zero stays zero.
    pub fn root(&self, own: Node, a: Node, k: usize) -> F {
        let (own, a) = (self.of(own), self.of(a));
        if k == 0 {
            return a[0].root();
        }
        let zero = F::from(0.0);
        if own[0] == zero && a[..=k].iter().all(|coefficient| *coefficient == zero) {
            return zero;
        }
        let known = F::convolution(&own[1..k], &own[1..k]);
        (a[k] - known) / (own[0] + own[0])
    }

    /// Of eᵃ: y′ = y a′.
    pub fn exponential(&self, own: Node, a: Node, k: usize) -> F {
        if k == 0 { self.of(a)[0].exponential() } else { self.turned(a, own, k) }
    }

    /// Of ln a: a y′ = a′.
    pub fn logarithm(&self, own: Node, a: Node, k: usize) -> F {
        let row = self.of(a);
        if k == 0 {
            return row[0].logarithm();
        }
        (row[k] - self.turned_before(own, a, k)) / row[0]
    }

    /// Of arctan a: (1 + a²) y′ = a′.
    pub fn arctangent(&self, own: Node, a: Node, slope: Node, k: usize) -> F {
        let row = self.of(a);
        if k == 0 {
            return row[0].arctangent();
        }
        (row[k] - self.turned_before(own, slope, k)) / self.of(slope)[0]
    }

    /// Of sin a, y′ = a′ cos a, the cosine being in the next row.
    pub fn sine(&self, own: Node, a: Node, k: usize) -> F {
        if k == 0 { self.of(a)[0].sine_cosine().0 } else { self.turned(a, Node(own.0 + 1), k) }
    }

    /// Of cos a, y′ = −a′ sin a, the sine being in the row before.
    pub fn cosine(&self, own: Node, a: Node, k: usize) -> F {
        if k == 0 { self.of(a)[0].sine_cosine().1 } else { -self.turned(a, Node(own.0 - 1), k) }
    }

    /// 1/k Σ j a(j) b(k − j), j = 1 … k: coefficient k of ∫ a′ b.
    fn turned(&self, a: Node, b: Node, k: usize) -> F {
        self.weighted(a, b, k, k + 1)
    }

    /// The same without j = k.
    fn turned_before(&self, a: Node, b: Node, k: usize) -> F {
        self.weighted(a, b, k, k)
    }

    fn weighted(&self, a: Node, b: Node, k: usize, end: usize) -> F {
        let (a, b) = (self.of(a), self.of(b));
        let sum = (1..end).fold(F::from(0.0), |sum, j| sum + F::from(exact(j)) * (a[j] * b[k - j]));
        sum / F::from(exact(k))
    }
}

/// An order as a number.
#[expect(clippy::cast_precision_loss, reason = "orders are small")]
pub(super) fn exact(order: usize) -> f64 {
    order as f64
}
