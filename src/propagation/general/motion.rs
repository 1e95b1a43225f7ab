use std::ops::Range;

use crate::dynamics::{Problem, Symbols};
use crate::numerics::{DoubleDouble, Expansion, Scalar, Tape};

/// q, ω, x, v and σ one after the other, as the inputs of [`Symbols`] after time.
pub(in crate::propagation) const COMPONENTS: usize = Symbols::INPUTS - 1;
/// Where each stands.
const ATTITUDE: Range<usize> = 0..4;
const RATES: Range<usize> = 4..7;
const POSITION: Range<usize> = 7..10;
const VELOCITY: Range<usize> = 10..13;
const INNER: Range<usize> = 13..16;

/// Sizes below this count as this: what has all but come to rest must not be followed to the last denormal digit.
const SMALLEST_SIZE: f64 = 1e-240;

/// The state at one instant, in 106 bits whatever the series are in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::propagation) struct Motion(pub [DoubleDouble; COMPONENTS]);

impl Motion {
    /// The first state's numbers taken as exact, but for the quaternion's length, which becomes 1.
    pub fn new(problem: &Problem) -> Self {
        let values = Symbols::values(0.0, &problem.initial);
        let mut motion = Self(std::array::from_fn(|component| DoubleDouble::from(values[component + 1])));
        if let Some(sphere) = problem.inner_sphere() {
            for (component, rate) in motion.0[INNER].iter_mut().zip(&sphere.initial) {
                *component = DoubleDouble::from(*rate);
            }
        }
        motion.normalise();
        motion
    }

    /// Brings q to unit length.
    pub fn normalise(&mut self) {
        let square = self.0[ATTITUDE].iter().fold(DoubleDouble::ZERO, |sum, component| sum + component.square());
        let factor = square.sqrt().recip();
        for component in &mut self.0[ATTITUDE] {
            *component = *component * factor;
        }
    }

    /// Whether every number is one.
    pub fn is_finite(&self) -> bool {
        self.0.iter().all(|value| (value.hi() + value.lo()).is_finite())
    }

    pub fn attitude(&self) -> [DoubleDouble; 4] {
        [0, 1, 2, 3].map(|i| self.0[ATTITUDE.start + i])
    }

    pub fn rates(&self) -> [DoubleDouble; 3] {
        [0, 1, 2].map(|i| self.0[RATES.start + i])
    }

    pub fn position(&self) -> [DoubleDouble; 3] {
        [0, 1, 2].map(|i| self.0[POSITION.start + i])
    }

    pub fn velocity(&self) -> [DoubleDouble; 3] {
        [0, 1, 2].map(|i| self.0[VELOCITY.start + i])
    }

    pub fn inner(&self) -> [DoubleDouble; 3] {
        [0, 1, 2].map(|i| self.0[INNER.start + i])
    }
}

/// The motion over one step, as power series in σ = (t − start) / unit.
#[derive(Debug, Clone)]
pub(super) struct Series<F> {
    pub expansion: Expansion<F>,
    pub order: usize,
    /// s, a power of two.
    pub unit: f64,
    start: Motion,
}

impl<F: Scalar> Series<F> {
    /// Of the motion from `start` at `time` on.
    pub fn new(tape: &Tape, order: usize, start: &Motion, time: DoubleDouble, unit: f64) -> Self {
        let mut series = Self { expansion: Expansion::new(tape, order), order, unit, start: *start };
        series.expand(tape, start, time, unit);
        series
    }

    /// The same of another start.
    pub fn expand(&mut self, tape: &Tape, start: &Motion, time: DoubleDouble, unit: f64) {
        (self.start, self.unit) = (*start, unit);
        let expansion = &mut self.expansion;
        expansion.set(0, 0, F::from_double(time));
        if self.order > 0 {
            expansion.set(0, 1, F::from(unit));
        }
        for (component, value) in start.0.iter().enumerate() {
            expansion.set(component + 1, 0, F::from_double(*value));
        }
        let order = self.order;
        // The last order of the inputs needs the rates of the one before.
        expansion.integrate(tape, order, |expansion, k| {
            if k < order {
                let next = F::from(unit) / F::from(exact(k + 1));
                for component in 0..COMPONENTS {
                    let rate = expansion.output(tape, component)[k];
                    expansion.set(component + 1, k + 1, rate * next);
                }
            }
        });
    }

    /// Coefficients of a component.
    pub fn of(&self, component: usize) -> &[F] {
        self.expansion.input(component + 1)
    }

    /// The state at one σ, q of unit length: the change in the series' digits, the sum in all there are.
    pub fn at(&self, sigma: F) -> Motion {
        let mut motion = self.start;
        for (component, value) in motion.0.iter_mut().enumerate() {
            let change = self.of(component)[1..].iter().rev().fold(F::from(0.0), |sum, c| (sum + *c) * sigma);
            *value += change.to_double();
        }
        motion.normalise();
        motion
    }

    /// The largest coefficient of order k among some components.
    fn largest(&self, components: Range<usize>, k: usize) -> f64 {
        components.fold(0.0, |most, component| self.of(component)[k].rounded().abs().max(most))
    }

    /// What coefficients of order k add at most, an attitude in rad and the rest relative to its size over the step.
    pub fn relative(&self, k: usize) -> f64 {
        let relative = |components: Range<usize>| {
            let size = (0..3.min(self.order)).map(|k| self.largest(components.clone(), k)).fold(0.0, f64::max);
            let last = self.largest(components, k);
            if size > 0.0 { last / size.max(SMALLEST_SIZE) } else { 0.0 }
        };
        self.largest(ATTITUDE, k)
            .max(relative(RATES))
            .max(relative(POSITION))
            .max(relative(VELOCITY))
            .max(relative(INNER))
    }

    /// Whether every coefficient is a number.
    pub fn is_finite(&self) -> bool {
        (0..COMPONENTS).all(|component| self.of(component).iter().all(|c| c.rounded().is_finite()))
    }

    /// How fast things happen at the start, 1/s.
    pub fn pace(&self) -> f64 {
        let (rates, first) = (self.largest(RATES, 0), self.largest(RATES, 1) / self.unit);
        rates.max(first.sqrt())
    }
}

/// An order as a number.
#[expect(clippy::cast_precision_loss, reason = "orders are small")]
pub(super) fn exact(order: usize) -> f64 {
    order as f64
}
