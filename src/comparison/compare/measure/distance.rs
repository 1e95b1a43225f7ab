use std::f64::consts::TAU;

use crate::propagation::attitude_angle;
use crate::telemetry::Channel;

/// Width of a quaternion.
const QUATERNION: usize = 4;

/// How far apart two values of one kind are, and how large they are.
pub(in crate::comparison) struct Distance {
    pub between: f64,
    pub size: f64,
}

/// Of numbers with all bits the same it is 0, whatever they are; where one is not finite, it is infinite.
pub(in crate::comparison) fn distance<const N: usize>(a: [f64; N], b: [f64; N]) -> Distance {
    if N == QUATERNION {
        let quaternion = |value: [f64; N]| std::array::from_fn(|k| value[k]);
        return Distance { between: finite(attitude_angle(quaternion(a), quaternion(b))), size: 1.0 };
    }
    let between = length(std::array::from_fn::<f64, N, _>(|k| a[k] - b[k]));
    Distance { between: finite(between), size: length(a).max(length(b)) }
}

/// `b`, whole turns from where it is and as near `a` as can be, if `channel` is angles that come round.
pub(in crate::comparison) fn nearest<const N: usize>(channel: Channel, a: [f64; N], b: [f64; N]) -> [f64; N] {
    if !channel.comes_round() {
        return b;
    }
    // A difference of less than half a turn is left alone, to its last bit.
    std::array::from_fn(|k| b[k] + TAU * ((a[k] - b[k]) / TAU).round())
}

/// The size of values of which one side is as good as the other.
pub(in crate::comparison) fn size<const N: usize>(a: [f64; N]) -> f64 {
    if N == QUATERNION { 1.0 } else { length(a) }
}

/// The component that contributes most to a distance; none of an attitude, whose angle is not in a component, nor of what
/// has only one.
pub(in crate::comparison) fn component<const N: usize>(a: [f64; N], b: [f64; N]) -> Option<usize> {
    if N == QUATERNION || N == 1 {
        return None;
    }
    let between: [f64; N] = std::array::from_fn(|k| finite((a[k] - b[k]).abs()));
    (0..N).max_by(|one, other| between[*one].total_cmp(&between[*other]))
}

fn length<const N: usize>(value: [f64; N]) -> f64 {
    if N == 1 {
        return value[0].abs();
    }
    let plain = value.iter().map(|part| part * part).sum::<f64>();
    // Squares of what is very small or large are none.
    if (1e-200..1e200).contains(&plain) {
        plain.sqrt()
    } else {
        value.iter().fold(0.0, |length, part| libm::hypot(length, *part))
    }
}

/// NaN is as far away as can be.
fn finite(distance: f64) -> f64 {
    if distance.is_nan() { f64::INFINITY } else { distance }
}
