use super::States;

/// The angle between two motions at each of the same times, rad, however small; infinite where one is not finite.
pub fn attitude_distances<'a>(one: &'a States, other: &'a States) -> impl Iterator<Item = f64> + 'a {
    let at = |states: &States, index: usize| -> [f64; 4] { std::array::from_fn(|k| states.attitude[k][index]) };
    (0..one.len()).map(move |index| {
        let angle = attitude_angle(at(one, index), at(other, index));
        // NaN is as wrong as can be, where f64::max would drop it.
        if angle.is_nan() { f64::INFINITY } else { angle }
    })
}

/// The largest of [`attitude_distances`].
#[must_use]
pub fn attitude_distance(one: &States, other: &States) -> f64 {
    attitude_distances(one, other).fold(0.0, f64::max)
}

/// The angle between two attitudes w, x, y, z, rad, 0 to π, however small; q and −q are the same, and lengths do not count.
///
/// 2 atan2(|Im|, |Re|) of q̄ p, with Im from the difference p − q so that nothing large cancels.
#[must_use]
pub fn attitude_angle(q: [f64; 4], p: [f64; 4]) -> f64 {
    let dot: f64 = q.iter().zip(&p).map(|(a, b)| a * b).sum();
    let p = if dot < 0.0 { p.map(|component| -component) } else { p };
    let [w, x, y, z] = q;
    let [a, b, c, d] = std::array::from_fn(|k| p[k] - q[k]);
    let imaginary = [w * b - x * a - y * d + z * c, w * c - y * a - z * b + x * d, w * d - z * a - x * c + y * b];
    2.0 * libm::atan2(imaginary.iter().map(|part| part * part).sum::<f64>().sqrt(), dot.abs())
}

#[cfg(test)]
mod tests {
    use super::attitude_angle;

    #[test]
    fn angles_are_true_however_small_and_blind_to_sign() {
        for half in [1e-12, 1e-3, 0.7, 1.5] {
            let turned = [libm::cos(half), 0.6 * libm::sin(half), 0.0, -0.8 * libm::sin(half)];
            let found = attitude_angle([1.0, 0.0, 0.0, 0.0], turned);
            assert!((found - 2.0 * half).abs() < 1e-15 * half.max(0.5), "{found} is not twice {half}");
            assert_eq!(attitude_angle([1.0, 0.0, 0.0, 0.0], turned.map(|component| -component)), found);
        }
    }
}
