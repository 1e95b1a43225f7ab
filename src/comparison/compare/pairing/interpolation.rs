use crate::comparison::compare::measure::distance::nearest;
use crate::telemetry::Channel;

/// Samples from which a value between them is made: at most four.
pub(in crate::comparison) const NODES: usize = 4;

/// A cubic through the values at up to [`NODES`] times: what each counts at a time between them.
pub(in crate::comparison) struct Cubic {
    weights: [f64; NODES],
    count: usize,
}

impl Cubic {
    /// Lagrange's, through values at `nodes`, s, at `time_s`.
    pub fn new(nodes: &[f64], time_s: f64) -> Self {
        let count = nodes.len().min(NODES);
        let weight = |k: usize| {
            let others = (0..count).filter(|other| *other != k);
            others.map(|other| (time_s - nodes[other]) / (nodes[k] - nodes[other])).product()
        };
        let mut weights = [0.0; NODES];
        weights[..count].iter_mut().enumerate().for_each(|(k, place)| *place = weight(k));
        Self { weights, count }
    }

    /// Of values of `channel`, each a row of its components.
    pub fn value<const N: usize>(&self, channel: Channel, values: &[[f64; N]]) -> [f64; N] {
        let mut sum = [0.0; N];
        let mut before = values.first().copied().unwrap_or([f64::NAN; N]);
        for (weight, value) in self.weights[..self.count].iter().zip(values) {
            let weight = if channel == Channel::Attitude { weight * sign(&values[0], value) } else { *weight };
            let value = nearest(channel, before, *value);
            before = value;
            (0..N).for_each(|k| sum[k] += weight * value[k]);
        }
        if channel == Channel::Attitude { unit(sum) } else { sum }
    }
}

/// Hermite's cubic between two values with their derivatives, at `time_s`.
pub(in crate::comparison) fn hermite<const N: usize>(
    times_s: [f64; 2],
    values: [[f64; N]; 2],
    rates: [[f64; N]; 2],
    time_s: f64,
) -> [f64; N] {
    let step = times_s[1] - times_s[0];
    let s = (time_s - times_s[0]) / step;
    let far = s * s * (3.0 - 2.0 * s);
    let (leave, arrive) = (s * (1.0 - s) * (1.0 - s) * step, s * s * (s - 1.0) * step);
    let [from, to] = values;
    std::array::from_fn(|k| from[k] + far * (to[k] - from[k]) + leave * rates[0][k] + arrive * rates[1][k])
}

/// The same between attitudes, from ω in body axes: q̇ = q (0, ω) / 2.
pub(in crate::comparison) fn attitude(
    times_s: [f64; 2],
    q: [[f64; 4]; 2],
    omega: [[f64; 3]; 2],
    time_s: f64,
) -> [f64; 4] {
    let near = sign(&q[0], &q[1]);
    let q = [q[0], q[1].map(|part| near * part)];
    let rate = |[w, x, y, z]: [f64; 4], [p, q, r]: [f64; 3]| {
        [-x * p - y * q - z * r, w * p + y * r - z * q, w * q + z * p - x * r, w * r + x * q - y * p]
            .map(|part| 0.5 * part)
    };
    unit(hermite(times_s, q, [rate(q[0], omega[0]), rate(q[1], omega[1])], time_s))
}

/// Whether to take a quaternion or its negative, to be near another.
fn sign<const N: usize>(one: &[f64; N], other: &[f64; N]) -> f64 {
    if one.iter().zip(other).map(|(a, b)| a * b).sum::<f64>() < 0.0 { -1.0 } else { 1.0 }
}

fn unit<const N: usize>(value: [f64; N]) -> [f64; N] {
    let length = value.iter().map(|part| part * part).sum::<f64>().sqrt();
    value.map(|part| part / length)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::propagation::attitude_angle;

    #[test]
    fn cubics_are_reproduced() {
        let cubic = |t: f64| [1.0 - 2.0 * t + 3.0 * t * t - 0.7 * t * t * t];
        let slope = |t: f64| [-2.0 + 6.0 * t - 2.1 * t * t];
        let nodes = [0.1, 0.4, 0.5, 1.1];
        for time in [0.1, 0.2, 0.45, 0.5, 1.0] {
            let found = Cubic::new(&nodes, time).value(Channel::Tilt, &nodes.map(cubic));
            assert!((found[0] - cubic(time)[0]).abs() < 1e-14);
            let ends = [0.1, 1.1];
            let found = hermite(ends, ends.map(cubic), ends.map(slope), time);
            assert!((found[0] - cubic(time)[0]).abs() < 1e-14);
        }
    }

    #[test]
    fn attitudes_are_exact_to_the_fourth_order_whatever_their_signs() {
        // A turn about one axis at 2 rad/s: 0.05 rad from node to node.
        let turned = |t: f64| [libm::cos(t), 0.6 * libm::sin(t), 0.0, 0.8 * libm::sin(t)];
        let nodes = [0.0, 0.025, 0.05, 0.075];
        let mut q = nodes.map(turned);
        q[2] = q[2].map(|part| -part);
        let found = Cubic::new(&nodes, 0.04).value(Channel::Attitude, &q);
        assert!(attitude_angle(found, turned(0.04)) < 2.0 * 3.0 / 128.0 * 0.025_f64.powi(4));
        let omega = [1.2, 0.0, 1.6];
        let found = attitude([0.025, 0.05], [q[1], q[2]], [omega; 2], 0.04);
        assert!(attitude_angle(found, turned(0.04)) < 2.0 / 384.0 * 0.025_f64.powi(4));
    }
}
