use super::nutation::{Form, Nutation};
use super::start::{Start, conjugate, product, square};
use crate::numerics::{DoubleDouble, Phase};
use crate::propagation::exact::{ExactQuaternion, Motion, QuaternionMap, Rates};

/// A nutation, turned evenly about the vertical and about the axis, in the world and the axes it was asked for.
#[derive(Debug, Clone, Copy)]
pub struct TopMotion<N> {
    nutation: N,
    /// By which A and B are turned.
    phases: [Phase; 2],
    zeta: f64,
    slope_rate: f64,
    /// Sum of the rates of both phases, rad/s.
    rate_sum: f64,
    /// ω₁′ + iω₂′ at the start over that of the model.
    rates_turn: [f64; 2],
    /// ω₃′, rad/s.
    along: f64,
    axes: [usize; 3],
    signs: [f64; 3],
    attitude_map: QuaternionMap<4>,
}

/// Complex product.
#[inline(always)]
fn times([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a * c - b * d, a * d + b * c]
}

#[inline(always)]
fn scaled(factor: f64, [a, b]: [f64; 2]) -> [f64; 2] {
    [factor * a, factor * b]
}

/// x* y.
#[inline(always)]
fn conjugate_times([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a * c + b * d, a * d - b * c]
}

/// The turn from a model's complex number and its rate to the start's. Both turn alike; where one of them is near 0, and
/// its direction lost, the other decides.
fn turn_between(start: [[DoubleDouble; 2]; 2], model: [[f64; 2]; 2], per_second: f64) -> [DoubleDouble; 2] {
    let [value, rate] = [0, 1].map(|k| product(start[k], conjugate(model[k].map(DoubleDouble::from))));
    let square_rate = per_second * per_second;
    let turn = [0, 1].map(|k| value[k] * square_rate + rate[k]);
    let size = square(turn).sqrt();
    if size.is_zero() {
        return [DoubleDouble::ONE, DoubleDouble::ZERO];
    }
    turn.map(|part| part / size)
}

/// What a sample is made of: A and B, and the slopes that ω needs, all turned.
struct Model {
    pair: [[f64; 2]; 2],
    slopes: [[f64; 2]; 2],
}

impl Model {
    /// A′ and B′ of the model at unit length, but for a positive factor, if A and B turn besides at these rates.
    fn rates(&self, even: [f64; 2]) -> [[f64; 2]; 2] {
        let with_turn = |k: usize| {
            let ([re, im], [slope_re, slope_im]) = (self.pair[k], self.slopes[k]);
            [slope_re - even[k] * im, slope_im + even[k] * re]
        };
        let rates = [with_turn(0), with_turn(1)];
        let inner =
            |x: [[f64; 2]; 2]| self.pair.iter().flatten().zip(x.iter().flatten()).map(|(a, b)| a * b).sum::<f64>();
        let growth = inner(rates) / inner(self.pair);
        [0, 1].map(|k| [0, 1].map(|i| rates[k][i] - growth * self.pair[k][i]))
    }
}

impl<N: Nutation> TopMotion<N> {
    pub fn new(start: &Start, form: Form<N>) -> Self {
        let destinations = start.frame.destinations();
        let mut this = Self {
            nutation: form.nutation,
            phases: form
                .rates
                .map(|rate| Phase { start: DoubleDouble::ZERO, rate: rate * DoubleDouble::TURNS_PER_RADIAN }),
            zeta: form.zeta.hi(),
            slope_rate: form.slope_rate.hi(),
            rate_sum: (form.rates[0] + form.rates[1]).hi(),
            rates_turn: [1.0, 0.0],
            along: start.along.hi(),
            axes: destinations.map(|(axis, _)| axis),
            signs: destinations.map(|(_, sign)| sign),
            attitude_map: QuaternionMap::ZERO,
        };
        let (model, rates) = (this.model(0.0), start.pair_rates());
        let even = form.rates.map(DoubleDouble::hi);
        let model_rates = model.rates(even);
        let turn = [0, 1].map(|k| {
            let per_second = this.slope_rate + even[k].abs();
            turn_between([start.pair[k], rates[k]], [model.pair[k], model_rates[k]], per_second)
        });
        this.rates_turn = product(conjugate(turn[0]), turn[1]).map(DoubleDouble::hi);
        // With P = "primed from principal" the attitude is world from upright, times q, times P: of any length, times P,
        // times q in principal axes.
        let primed_from_principal = start.frame.principal_from_primed().conjugate();
        let world_from_principal = start.world_from_upright.times(primed_from_principal);
        let [one, i, j, k] = start.frame.times_units(world_from_principal);
        // a + b times the complex number `turn`.
        let turned =
            |ExactQuaternion(a): ExactQuaternion, ExactQuaternion(b): ExactQuaternion, turn: [DoubleDouble; 2]| {
                ExactQuaternion([0, 1, 2, 3].map(|row| a[row] * turn[0] + b[row] * turn[1]))
            };
        let images = [
            turned(one, k, turn[0]),
            turned(i, j, turn[1]),
            turned(j, i, conjugate(turn[1])),
            turned(k, one, conjugate(turn[0])),
        ];
        this.attitude_map = QuaternionMap::new(images);
        this
    }

    #[inline(always)]
    fn model(&self, time: f64) -> Model {
        let pair = self.nutation.at(time);
        let (first_sin, first_cos) = self.phases[0].at(time).plus(pair.turns[0]).sin_cos();
        let (second_sin, second_cos) = self.phases[1].at(time).plus(pair.turns[1]).sin_cos();
        let (first, second) = ([first_cos, first_sin], [second_cos, second_sin]);
        Model {
            pair: [times(first, pair.first), times(second, scaled(self.zeta, pair.second))],
            slopes: [
                times(first, scaled(self.slope_rate, pair.first_slope)),
                times(second, scaled(self.slope_rate * self.zeta, pair.second_slope)),
            ],
        }
    }

    /// ω₁ + iω₂ = 2 (A* B′ − B A′*)/(|A|² + |B|²).
    #[inline(always)]
    fn rates_of(&self, Model { pair: [a, b], slopes: [a_slope, b_slope] }: &Model) -> [f64; 3] {
        let over_size = 2.0 / ((a[0] * a[0] + a[1] * a[1]) + (b[0] * b[0] + b[1] * b[1]));
        let ([re, im], [b_re, b_im]) = (conjugate_times(*a, *b), conjugate_times(*a, *b_slope));
        let [a_re, a_im] = conjugate_times(*a_slope, *b);
        let across = [b_re - a_re - self.rate_sum * im, b_im - a_im + self.rate_sum * re];
        let [w1, w2] = times(self.rates_turn, scaled(over_size, across));
        [self.signs[0] * w1, self.signs[1] * w2, self.signs[2] * self.along]
    }
}

impl<N: Nutation> Rates for TopMotion<N> {
    fn axes(&self) -> [usize; 3] {
        self.axes
    }

    #[inline(always)]
    fn rates(&self, time: f64) -> [f64; 3] {
        self.rates_of(&self.model(time))
    }
}

impl<N: Nutation> Motion for TopMotion<N> {
    #[inline(always)]
    fn rates_and_attitude(&self, time: f64) -> ([f64; 3], [f64; 4]) {
        let model = self.model(time);
        let [[w, z], [x, y]] = model.pair;
        (self.rates_of(&model), self.attitude_map.unit([w, x, y, z]))
    }
}
