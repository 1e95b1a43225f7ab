use super::acting::{Acting, Vector};
use super::drive::Drive;
use super::state::PreciseState;
use crate::numerics::{DoubleDouble, convolution};

/// The order of the series: about that at which a step is cheapest for its length, −½ ln tolerance + 1 [JZ05] §3.
pub(super) const ORDER: usize = 36;

/// The coefficients of one component, by order.
type Coefficients = [DoubleDouble; ORDER + 1];

const NONE: Coefficients = [DoubleDouble::ZERO; ORDER + 1];

/// The motion over one step as power series in σ = (t − start) / unit.
#[derive(Debug, Clone)]
pub(super) struct Series {
    pub attitude: [Coefficients; 4],
    pub rates: [Coefficients; 3],
    pub position: [Coefficients; 3],
    pub velocity: [Coefficients; 3],
    /// R, world from principal axes, by rows: row i is the body image of world axis i.
    matrix: [[Coefficients; 3]; 3],
    /// cos and sin of the orbit's phase.
    orbit: [Coefficients; 2],
    /// Body image of the direction from the attracting centre.
    radial: [Coefficients; 3],
    /// What changes with time, if anything does.
    pub drive: Option<Drive>,
}

impl Series {
    pub fn new() -> Self {
        Self {
            attitude: [NONE; 4],
            rates: [NONE; 3],
            position: [NONE; 3],
            velocity: [NONE; 3],
            matrix: [[NONE; 3]; 3],
            orbit: [NONE; 2],
            radial: [NONE; 3],
            drive: None,
        }
    }

    /// Fills the coefficients up to `order`, of the motion that is in `state` at `time`, time in `unit` seconds, a power
    /// of two.
    pub fn expand(&mut self, state: &PreciseState, time: DoubleDouble, acting: &Acting, unit: f64, order: usize) {
        start(&mut self.attitude, &state.attitude);
        start(&mut self.rates, &state.angular_velocity);
        start(&mut self.position, &state.position);
        start(&mut self.velocity, &state.velocity);
        if let Some((_, mean_motion)) = acting.gradient {
            let (cosine, sine) = (time * mean_motion).cos_sin();
            start(&mut self.orbit, &[cosine, sine]);
        }
        self.drive = acting.drive(time, unit);
        for k in 0..order {
            let next = DoubleDouble::from(exact(k + 1)).recip().scale(unit);
            if acting.needs_matrix {
                self.turn(k);
            }
            if let Some((_, mean_motion)) = acting.gradient {
                self.look_out(k);
                let [cosine, sine] = [0, 1].map(|i| self.orbit[i][k] * mean_motion * next);
                (self.orbit[0][k + 1], self.orbit[1][k + 1]) = (-sine, cosine);
            }
            let (rates, attitude) = (self.acceleration(acting, k), self.attitude_rate(k));
            let (position, velocity) = ([0, 1, 2].map(|i| self.velocity[i][k]), self.force(acting, k));
            put(&mut self.rates, k + 1, rates, next);
            put(&mut self.attitude, k + 1, attitude, next.scale(0.5));
            put(&mut self.position, k + 1, position, next);
            put(&mut self.velocity, k + 1, velocity, next);
        }
    }

    /// Coefficient k of ω̇.
    fn acceleration(&self, acting: &Acting, k: usize) -> Vector {
        let gyroscopic = cyclic_products(&self.rates, k);
        let driven = self.drive.as_ref().map(|drive| drive.rates(&self.rates, &self.matrix, acting.needs_matrix, k));
        let tidal = acting.gradient.map(|(factors, _)| (factors, cyclic_products(&self.radial, k)));
        std::array::from_fn(|i| {
            let mut sum = acting.coupling[i] * gyroscopic[i] - acting.damping[i] * self.rates[i][k];
            if k == 0 {
                sum += acting.moment[i];
            }
            if acting.needs_matrix {
                for (couple, image) in acting.couples.iter().zip(&self.matrix) {
                    for (factor, component) in couple[i].iter().zip(image).filter(|(factor, _)| !factor.is_zero()) {
                        sum += *factor * component[k];
                    }
                }
            }
            if let Some((factors, products)) = tidal {
                sum += factors[i] * products[i];
            }
            if let Some(driven) = driven {
                sum += driven[i];
            }
            sum
        })
    }

    /// Coefficient k of q (0, ω).
    fn attitude_rate(&self, k: usize) -> [DoubleDouble; 4] {
        let [w, x, y, z] = &self.attitude;
        let [a, b, c] = &self.rates;
        let p = |q: &Coefficients, rate: &Coefficients| convolution(&q[..=k], &rate[..=k]);
        [
            -(p(x, a) + p(y, b) + p(z, c)),
            p(w, a) + p(y, c) - p(z, b),
            p(w, b) + p(z, a) - p(x, c),
            p(w, c) + p(x, b) - p(y, a),
        ]
    }

    /// Coefficient k of v̇ = world acceleration + R b.
    fn force(&self, acting: &Acting, k: usize) -> Vector {
        let driven = self.drive.as_ref().map(|drive| drive.acceleration(&self.matrix, k));
        std::array::from_fn(|i| {
            let mut sum = if k == 0 { acting.world_acceleration[i] } else { DoubleDouble::ZERO };
            if let Some(driven) = driven {
                sum += driven[i];
            }
            for (row, along) in self.matrix[i].iter().zip(&acting.body_acceleration).filter(|(_, b)| !b.is_zero()) {
                sum += row[k] * *along;
            }
            sum
        })
    }

    /// Coefficient k of R from those of q.
    fn turn(&mut self, k: usize) {
        let q = &self.attitude;
        let p = |i: usize, j: usize| convolution(&q[i][..=k], &q[j][..=k]);
        let [ww, xx, yy, zz] = [0, 1, 2, 3].map(|i| p(i, i));
        let [wx, wy, wz, xy, xz, yz] =
            [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)].map(|(i, j)| p(i, j).scale(2.0));
        let rows = [
            [ww + xx - yy - zz, xy - wz, xz + wy],
            [xy + wz, ww - xx + yy - zz, yz - wx],
            [xz - wy, yz + wx, ww - xx - yy + zz],
        ];
        for (coefficients, row) in self.matrix.iter_mut().zip(rows) {
            put(coefficients, k, row, DoubleDouble::ONE);
        }
    }

    /// Coefficient k of Rᵀ (cos, sin, 0).
    fn look_out(&mut self, k: usize) {
        let ([x, y, _], [cosine, sine]) = (&self.matrix, &self.orbit);
        let along = |i: usize| convolution(&x[i][..=k], &cosine[..=k]) + convolution(&y[i][..=k], &sine[..=k]);
        let radial = [0, 1, 2].map(along);
        put(&mut self.radial, k, radial, DoubleDouble::ONE);
    }

    /// The state at one σ, the quaternion as it comes.
    pub fn state(&self, sigma: DoubleDouble) -> PreciseState {
        PreciseState {
            attitude: self.attitude.each_ref().map(|row| value(row, sigma)),
            angular_velocity: self.rates.each_ref().map(|row| value(row, sigma)),
            position: self.position.each_ref().map(|row| value(row, sigma)),
            velocity: self.velocity.each_ref().map(|row| value(row, sigma)),
        }
    }
}

fn value(coefficients: &Coefficients, sigma: DoubleDouble) -> DoubleDouble {
    coefficients.iter().rev().fold(DoubleDouble::ZERO, |sum, coefficient| sum * sigma + *coefficient)
}

fn start<const N: usize>(rows: &mut [Coefficients; N], values: &[DoubleDouble; N]) {
    put(rows, 0, *values, DoubleDouble::ONE);
}

fn put<const N: usize>(rows: &mut [Coefficients; N], k: usize, values: [DoubleDouble; N], factor: DoubleDouble) {
    for (row, value) in rows.iter_mut().zip(values) {
        row[k] = value * factor;
    }
}

/// Coefficient k of (a₂a₃, a₃a₁, a₁a₂).
fn cyclic_products([a, b, c]: &[Coefficients; 3], k: usize) -> Vector {
    [convolution(&b[..=k], &c[..=k]), convolution(&c[..=k], &a[..=k]), convolution(&a[..=k], &b[..=k])]
}

/// An order as a number.
#[expect(clippy::cast_precision_loss, reason = "orders are small")]
pub(super) fn exact(order: usize) -> f64 {
    order as f64
}
