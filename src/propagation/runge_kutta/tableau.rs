use crate::propagation::equations::{Equations, Values};

/// An explicit Runge–Kutta method as data `[HNW93]` §II.1.
pub(super) struct Tableau<const STAGES: usize> {
    /// c: where in the step each stage lies.
    pub nodes: [f64; STAGES],
    /// a: each stage from those before it.
    pub stages: [&'static [f64]; STAGES],
    /// b: the step from the stages.
    pub weights: [f64; STAGES],
}

/// "The" Runge–Kutta method of order 4: Kutta 1901, `[HNW93]` Table II.1.2.
pub(super) const CLASSIC_4: Tableau<4> = Tableau {
    nodes: [0.0, 0.5, 0.5, 1.0],
    stages: [&[], &[0.5], &[0.0, 0.5], &[0.0, 0.0, 1.0]],
    weights: [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0],
};

impl<const STAGES: usize> Tableau<STAGES> {
    /// The derivatives at the stages of a step; `first` is that at its beginning.
    pub fn derivatives(
        &self,
        equations: &mut Equations,
        time: f64,
        step: f64,
        values: &Values,
        first: Values,
    ) -> [Values; STAGES] {
        let mut derivatives = [first; STAGES];
        for stage in 1..STAGES {
            let moved = combine(values, step, self.stages[stage], &derivatives);
            derivatives[stage] = equations.derivative(time + self.nodes[stage] * step, &moved);
        }
        derivatives
    }
}

/// values + step Σ weight · derivative.
pub(super) fn combine(values: &Values, step: f64, weights: &[f64], derivatives: &[Values]) -> Values {
    let sum = weighted(weights, derivatives);
    std::array::from_fn(|i| values[i] + step * sum[i])
}

/// Σ weight · derivative.
pub(super) fn weighted(weights: &[f64], derivatives: &[Values]) -> Values {
    let mut sum = [0.0; _];
    for (weight, derivative) in weights.iter().zip(derivatives).filter(|(weight, _)| **weight != 0.0) {
        for (sum, derivative) in sum.iter_mut().zip(derivative) {
            *sum += weight * derivative;
        }
    }
    sum
}
