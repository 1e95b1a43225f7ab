use std::f64::consts::{PI, TAU};

use nalgebra::UnitQuaternion;

/// About which body axes three turns in a row make an attitude: R = `R_a(first)` `R_b(second)` `R_c(third)`, a turn after
/// the first being about an axis that the turns before it have carried along (intrinsic turns).
///
/// First and third are from −π to π, wrapped and not counted on: functions of the attitude alone. Where third axis and
/// first are the same, the second is from 0 to π, else from −π/2 to π/2. At the ends of its range the other two turn about
/// one line (gimbal lock): there only their sum or difference is known, the third is given as 0 and the first takes it
/// all. Near the ends, first and third may change fast and their sum or difference does not; the attitude that the three
/// make together is right to rounding everywhere. After `[BV22]`, from the quaternion without trigonometric functions of
/// other angles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EulerSequence {
    /// The classical angles of astronomy and of tops: precession, nutation, spin.
    Zxz,
    /// The same with y for the line of nodes.
    Zyz,
    /// Yaw, pitch, roll of aircraft and spacecraft.
    Zyx,
    /// The reverse order.
    Xyz,
}

impl EulerSequence {
    /// First, second and third angle, rad, of an attitude (world from body).
    #[must_use]
    pub fn angles(self, attitude: &UnitQuaternion<f64>) -> [f64; 3] {
        let ([a, b, c], parity) = self.axes();
        let v = [attitude.i, attitude.j, attitude.k];
        let w = attitude.w;
        if self.is_proper() {
            // With first = σ + δ and third = σ − δ, the quaternion is cos(second/2) (cos σ, sin σ) in w and a, and
            // sin(second/2) (cos δ, sin δ) in b and the axis left over.
            let (half_sum, half_difference) = ([w, v[a]], [v[b], parity * v[c]]);
            let second = 2.0 * libm::atan2(length(half_difference), length(half_sum));
            let [first, third] = outer(half_sum, half_difference, 0.0);
            return [first, second, third];
        }
        // A quarter turn about b makes the third axis the first, and the sequence one of the others.
        let (half_sum, half_difference) =
            ([w + parity * v[b], v[a] + v[c]], [v[b] - parity * w, parity * (v[c] - v[a])]);
        let both = length(half_sum) + length(half_difference);
        // The difference of the lengths, of squares taken apart: nothing is lost of a small second angle.
        let second = 2.0 * libm::atan2(4.0 * (w * v[b] + parity * v[a] * v[c]) / both, both);
        let [first, third] = outer(half_sum, half_difference, if parity > 0.0 { PI } else { 0.0 });
        [first, second, third]
    }

    /// Numbers of first, second and third axis (for proper angles: the axis left over), and whether these are in cyclic
    /// order (1) or not (−1).
    const fn axes(self) -> ([usize; 3], f64) {
        match self {
            Self::Zxz => ([2, 0, 1], 1.0),
            Self::Zyz | Self::Zyx => ([2, 1, 0], -1.0),
            Self::Xyz => ([0, 1, 2], 1.0),
        }
    }

    /// Whether first and third axis are the same.
    const fn is_proper(self) -> bool {
        matches!(self, Self::Zxz | Self::Zyz)
    }
}

/// First and third angle, of cosine and sine (in any unit) of half their sum and half their difference; `flip` is taken off
/// the first and added to the third.
fn outer(half_sum: [f64; 2], half_difference: [f64; 2], flip: f64) -> [f64; 2] {
    let angle = |[cosine, sine]: [f64; 2]| libm::atan2(sine, cosine);
    if half_difference == [0.0, 0.0] {
        return [wrapped(2.0 * angle(half_sum)), 0.0];
    }
    if half_sum == [0.0, 0.0] {
        return [wrapped(2.0 * angle(half_difference)), 0.0];
    }
    let (sum, difference) = (angle(half_sum), angle(half_difference));
    [wrapped(sum + difference - flip), wrapped(sum - difference + flip)]
}

fn length([one, other]: [f64; 2]) -> f64 {
    libm::hypot(one, other)
}

/// An angle from −3π to 3π, from −π to π.
fn wrapped(angle: f64) -> f64 {
    if angle > PI {
        angle - TAU
    } else if angle < -PI {
        angle + TAU
    } else {
        angle
    }
}
