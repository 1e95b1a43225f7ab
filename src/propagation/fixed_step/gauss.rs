use super::Scheme;
use crate::numerics::two_sum;
use crate::propagation::PropagationError;
use crate::propagation::equations::{Equations, Values};

/// Gauss collocation on (ω, q, x, v), its stages by fixed-point iteration, `[HLW06]` §II.1.3 and §VIII.6.
///
/// Every quadratic invariant is kept: |q|, and of a free body |L| and the energy. What rounding takes off the sums is
/// carried on to the next step, so that it does not drift.
pub(super) struct Gauss {
    tableau: &'static Collocation,
    /// What the values have lost to rounding so far.
    lost: Values,
}

/// Nodes, stages and weights.
pub(super) struct Collocation {
    nodes: &'static [f64],
    stages: &'static [&'static [f64]],
    weights: &'static [f64],
}

/// Order 4: `[HLW06]` Table II.1.1.
pub(super) const GAUSS_2_STAGES: Collocation = Collocation {
    nodes: &[0.211_324_865_405_187_1, 0.788_675_134_594_812_9],
    stages: &[&[0.25, -0.038_675_134_594_812_88], &[0.538_675_134_594_812_9, 0.25]],
    weights: &[0.5, 0.5],
};

/// Order 6: `[HLW06]` Table II.1.1.
pub(super) const GAUSS_3_STAGES: Collocation = Collocation {
    nodes: &[0.112_701_665_379_258_31, 0.5, 0.887_298_334_620_741_7],
    stages: &[
        &[0.138_888_888_888_888_9, -0.035_976_667_524_938_9, 0.009_789_444_015_308_325],
        &[0.300_263_194_980_864_57, 0.222_222_222_222_222_2, -0.022_485_417_203_086_815],
        &[0.267_988_333_762_469_44, 0.480_421_111_969_383_36, 0.138_888_888_888_888_9],
    ],
    weights: &[0.277_777_777_777_777_8, 0.444_444_444_444_444_4, 0.277_777_777_777_777_8],
};

impl Gauss {
    /// The iteration gains about a factor h |ω| each time.
    const MOST_ITERATIONS: usize = 100;
    /// A change of this size, relative to the derivatives, that shrinks no more is rounding.
    const ROUNDING: f64 = 1e-12;

    pub fn new(tableau: &'static Collocation) -> Self {
        Self { tableau, lost: Values::default() }
    }

    /// The derivatives at the stages.
    fn stages(&self, equations: &mut Equations, time: f64, step: f64, values: &Values) -> Option<Vec<Values>> {
        let first = equations.derivative(time, values);
        let mut derivatives = vec![first; self.tableau.nodes.len()];
        let mut last_change = f64::INFINITY;
        for _ in 0..Self::MOST_ITERATIONS {
            let (mut change, mut size) = (0.0_f64, 0.0_f64);
            // Each stage from the newest derivatives of the others.
            for (stage, (node, weights)) in self.tableau.nodes.iter().zip(self.tableau.stages).enumerate() {
                let sum = weighted(weights, &derivatives);
                let moved = std::array::from_fn(|i| values[i] + (step * sum[i] + self.lost[i]));
                let derivative = equations.derivative(time + node * step, &moved);
                if derivative.iter().any(|value| !value.is_finite()) {
                    return None;
                }
                for (old, new) in derivatives[stage].iter().zip(&derivative) {
                    change = change.max((old - new).abs());
                    size = size.max(new.abs());
                }
                derivatives[stage] = derivative;
            }
            // Iterated until rounding is all that changes: a tolerance would make energy drift [HLW06] §VIII.6.2.
            if change == 0.0 || (change >= last_change && change <= Self::ROUNDING * size) {
                return Some(derivatives);
            }
            last_change = change;
        }
        None
    }
}

impl Scheme for Gauss {
    fn step(
        &mut self,
        equations: &mut Equations,
        time: f64,
        step: f64,
        values: &Values,
    ) -> Result<Values, PropagationError> {
        let stages =
            self.stages(equations, time, step, values).ok_or(PropagationError::NoConvergence { time, step })?;
        let sum = weighted(self.tableau.weights, &stages);
        let mut end = Values::default();
        for i in 0..end.len() {
            (end[i], self.lost[i]) = two_sum(values[i], step * sum[i] + self.lost[i]);
        }
        Ok(end)
    }
}

/// Σ weight · derivative.
fn weighted(weights: &[f64], derivatives: &[Values]) -> Values {
    std::array::from_fn(|i| weights.iter().zip(derivatives).map(|(weight, derivative)| weight * derivative[i]).sum())
}
