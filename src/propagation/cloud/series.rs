use super::equations::{Places, equations};
use super::motion::{Motion, Springs};
use super::vector::dot;
use crate::numerics::{DoubleDouble, Expansion, Scalar, Tape};

/// The motion of all particles over one step, as power series in σ = (t − start) / unit.
#[derive(Debug, Clone)]
pub(super) struct Series<F> {
    tape: Tape,
    places: Places,
    expansion: Expansion<F>,
    pub order: usize,
    /// s, a power of two.
    unit: f64,
    start: Motion,
}

impl<F: Scalar> Series<F> {
    /// Room for series up to `order`; at `start` for ever until they are worked out.
    pub fn new(springs: &Springs, order: usize, start: Motion) -> Self {
        let tape = equations(&springs.cloud, &springs.rest_squares());
        let expansion = Expansion::new(&tape, order);
        Self { places: Places::of(&springs.cloud), tape, expansion, order, unit: 1.0, start }
    }

    /// Works out the series from `start` on.
    pub fn expand(&mut self, springs: &Springs, start: Motion, unit: f64) {
        let (places, order) = (self.places, self.order);
        let expansion = &mut self.expansion;
        for particle in 0..places.particles {
            for axis in 0..3 {
                expansion.set(Places::position(particle) + axis, 0, F::from_double(start.positions[particle][axis]));
                expansion.set(places.velocity(particle) + axis, 0, F::from_double(start.velocities[particle][axis]));
            }
        }
        for (spring, stretch) in springs.stretches(&start).enumerate() {
            let [first, second] = springs.pairs[spring];
            let apart = |of: &[[DoubleDouble; 3]]| {
                let (from, to) = (Motion::rounded::<F>(of[first]), Motion::rounded::<F>(of[second]));
                [0, 1, 2].map(|axis| to[axis] - from[axis])
            };
            let rounded = dot(apart(&start.positions), apart(&start.velocities));
            expansion.set(places.stretch(spring), 0, F::from_double(stretch.square));
            expansion.set(places.lack(spring), 0, F::from_double(stretch.half_rate - rounded.to_double()));
        }
        let count = 3 * places.particles;
        expansion.integrate(&self.tape, order, |expansion, k| {
            if k == order {
                return;
            }
            let next = F::from(unit) / F::from(exact(k + 1));
            for component in 0..count {
                let velocity = expansion.input(count + component)[k];
                expansion.set(component, k + 1, velocity * next);
                let acceleration = expansion.output(&self.tape, component)[k];
                expansion.set(count + component, k + 1, acceleration * next);
            }
            for spring in 0..places.springs {
                let rate = expansion.output(&self.tape, count + spring)[k];
                expansion.set(places.stretch(spring), k + 1, rate * next);
            }
        });
        (self.start, self.unit) = (start, unit);
    }

    /// The motion so long after the start, s: what the first velocity makes in all digits there are.
    pub fn after(&self, passed: DoubleDouble) -> Motion {
        let sigma = F::from_double(passed.scale(1.0 / self.unit));
        let rest = |input: usize, from: usize| {
            let row = &self.expansion.input(input)[from..];
            let change = row.iter().rev().fold(F::from(0.0), |sum, coefficient| (sum + *coefficient) * sigma);
            change.to_double()
        };
        let sigma_exact = passed.scale(1.0 / self.unit);
        let mut motion = self.start.clone();
        for particle in 0..self.places.particles {
            for axis in 0..3 {
                let (at, speed) = (Places::position(particle) + axis, self.places.velocity(particle) + axis);
                let way = motion.velocities[particle][axis] * passed;
                // σ² (x₂ + x₃ σ + …): one factor of σ is left to be put in.
                motion.positions[particle][axis] += way + rest(at, 2) * sigma_exact;
                motion.velocities[particle][axis] += rest(speed, 1);
            }
        }
        motion
    }

    /// The σ at which the last two coefficients still add no more than the tolerance to a spring's stretch and its rate,
    /// of the largest of all, or to a position; infinity where they vanish.
    pub fn reach(&self, tolerance: f64) -> f64 {
        let largest = |inputs: std::ops::Range<usize>, k: usize| {
            inputs.fold(0.0, |most: f64, input| most.max(self.expansion.input(input)[k].rounded().abs()))
        };
        let positions = 0..3 * self.places.particles;
        let stretches = self.places.stretch(0)..self.places.lack(0);
        let first_of = |inputs: &std::ops::Range<usize>| (0..3).map(|k| largest(inputs.clone(), k)).fold(0.0, f64::max);
        let relative = |value: f64, size: f64| if size > 0.0 { value / size } else { 0.0 };
        let (size, stretch) = (first_of(&positions), first_of(&stretches));
        let ratio = |k: usize| {
            let of_stretch = exact(k) * relative(largest(stretches.clone(), k), stretch);
            let last = relative(largest(positions.clone(), k), size).max(of_stretch);
            if last > 0.0 { libm::pow(tolerance / last, 1.0 / exact(k)) } else { f64::INFINITY }
        };
        self.unit * ratio(self.order - 1).min(ratio(self.order))
    }
}

/// An order as a number.
#[expect(clippy::cast_precision_loss, reason = "orders are small")]
fn exact(order: usize) -> f64 {
    order as f64
}
