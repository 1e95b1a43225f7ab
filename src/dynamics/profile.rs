use nalgebra::{Matrix3, Vector3};

use super::spline::slopes;
use crate::numerics::two_sum;

/// Coefficients of 1, s, s² and s³.
pub type Cubic = [Vector3<f64>; 4];

/// A vector as a function of time: cubics between knots, constant before the first and after the last.
///
/// The cubics are the function, as exact as their f64 coefficients; what was interpolated to get them is forgotten.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// Ascending, s; at least one.
    knots: Vec<f64>,
    /// Before the first knot, then from each knot on; of the time since that knot (the first's, before it).
    pieces: Vec<Cubic>,
    /// From the first knot to each.
    integrals: Vec<Vector3<f64>>,
}

/// What lies between the points of a table.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Interpolation {
    /// Each value until the next.
    Hold,
    /// Straight lines.
    #[default]
    Linear,
    /// The cubic spline with two continuous derivatives and no knot at the last point but one of either end
    /// ("not-a-knot") `[deBoor01]`: a parabola through three points, a line through two.
    Cubic,
}

/// Constant terms of a cubic that has no others.
fn constant(value: Vector3<f64>) -> Cubic {
    [value, Vector3::zeros(), Vector3::zeros(), Vector3::zeros()]
}

/// The value of a cubic.
#[must_use]
pub fn value(cubic: &Cubic, s: f64) -> Vector3<f64> {
    cubic[0] + s * (cubic[1] + s * (cubic[2] + s * cubic[3]))
}

/// The derivative of a cubic.
#[must_use]
pub fn rate(cubic: &Cubic, s: f64) -> Vector3<f64> {
    cubic[1] + s * (2.0 * cubic[2] + s * (3.0 * cubic[3]))
}

/// The same cubic, its argument counted from `s` on.
#[must_use]
pub fn from(cubic: &Cubic, s: f64) -> Cubic {
    [value(cubic, s), rate(cubic, s), cubic[2] + s * (3.0 * cubic[3]), cubic[3]]
}

/// The integral of a cubic from 0 to `s`.
fn integral(cubic: &Cubic, s: f64) -> Vector3<f64> {
    s * (cubic[0] + s * (cubic[1] / 2.0 + s * (cubic[2] / 3.0 + s * (cubic[3] / 4.0))))
}

impl Profile {
    /// The same at all times.
    #[must_use]
    pub fn constant(value: Vector3<f64>) -> Self {
        Self { knots: vec![0.0], pieces: vec![constant(value); 2], integrals: vec![Vector3::zeros()] }
    }

    /// Through `points`, (s, value), their times ascending; `before` the first of them and `after` the last. `None` if
    /// there is no point, or their times do not ascend.
    #[must_use]
    pub fn through(
        points: &[(f64, Vector3<f64>)],
        interpolation: Interpolation,
        [before, after]: [Vector3<f64>; 2],
    ) -> Option<Self> {
        let ascends = points.windows(2).all(|pair| pair[0].0 < pair[1].0);
        points.first().filter(|_| ascends)?;
        let slopes = if interpolation == Interpolation::Cubic { slopes(points) } else { Vec::new() };
        let between = points.windows(2).enumerate().map(|(index, pair)| {
            let [(start, value), (end, next)] = [pair[0], pair[1]];
            let (length, secant) = (end - start, (next - value) / (end - start));
            match interpolation {
                Interpolation::Hold => constant(value),
                Interpolation::Linear => [value, secant, Vector3::zeros(), Vector3::zeros()],
                Interpolation::Cubic => {
                    let [here, there] = [slopes[index], slopes[index + 1]];
                    let excess = (here + there - 2.0 * secant) / length;
                    [value, here, (secant - here) / length - excess, excess / length]
                }
            }
        });
        let pieces = [constant(before)].into_iter().chain(between).chain([constant(after)]).collect();
        Some(Self::new(points.iter().map(|point| point.0).collect(), pieces))
    }

    fn new(knots: Vec<f64>, pieces: Vec<Cubic>) -> Self {
        let mut integrals = vec![Vector3::zeros(); knots.len()];
        let (mut sum, mut lost) = (Vector3::zeros(), Vector3::<f64>::zeros());
        for (index, pair) in knots.windows(2).enumerate() {
            let part = integral(&pieces[index + 1], pair[1] - pair[0]);
            for axis in 0..3 {
                let (total, error) = two_sum(sum[axis], part[axis]);
                sum[axis] = total;
                lost[axis] += error;
            }
            integrals[index + 1] = sum + lost;
        }
        Self { knots, pieces, integrals }
    }

    /// Where one cubic ends and the next begins, s.
    #[must_use]
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// The cubic that holds at `time`, s, and since when it counts, s.
    #[must_use]
    pub fn piece(&self, time: f64) -> (f64, &Cubic) {
        let passed = self.knots.partition_point(|knot| *knot <= time);
        (self.knots[passed.saturating_sub(1)], &self.pieces[passed])
    }

    /// The cubic that holds at `time`, s, of the time since then.
    #[must_use]
    pub fn piece_from(&self, time: f64) -> Cubic {
        let (knot, cubic) = self.piece(time);
        from(cubic, time - knot)
    }

    /// The value at `time`, s.
    #[must_use]
    pub fn at(&self, time: f64) -> Vector3<f64> {
        let (knot, cubic) = self.piece(time);
        value(cubic, time - knot)
    }

    /// The derivative at `time`, s; at a knot, the later one's.
    #[must_use]
    pub fn rate_at(&self, time: f64) -> Vector3<f64> {
        let (knot, cubic) = self.piece(time);
        rate(cubic, time - knot)
    }

    /// The integral from `start` to `end`, s.
    #[must_use]
    pub fn integral(&self, start: f64, end: f64) -> Vector3<f64> {
        if end > start { self.since_first(end) - self.since_first(start) } else { Vector3::zeros() }
    }

    fn since_first(&self, time: f64) -> Vector3<f64> {
        let passed = self.knots.partition_point(|knot| *knot <= time);
        let index = passed.saturating_sub(1);
        self.integrals[index] + integral(&self.pieces[passed], time - self.knots[index])
    }

    /// The largest magnitude at a knot.
    #[must_use]
    pub fn largest_at_knots(&self) -> f64 {
        self.pieces.iter().map(|piece| piece[0].norm()).fold(0.0, f64::max)
    }

    /// Whether all its coefficients are numbers.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        let coefficients = self.pieces.iter().flatten().chain(&self.integrals);
        self.knots.iter().all(|knot| knot.is_finite())
            && coefficients.into_iter().all(|vector| vector.iter().all(|value| value.is_finite()))
    }

    /// Whether it is the same at all times.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        let first = self.pieces[0];
        self.pieces.iter().all(|piece| *piece == constant(first[0]))
    }

    /// When it becomes other than zero (`true`), or zero for longer than an instant.
    pub fn switches(&self) -> impl Iterator<Item = (f64, bool)> + '_ {
        let acts = |piece: &Cubic| *piece != constant(Vector3::zeros());
        let pairs = self.knots.iter().zip(self.pieces.windows(2));
        pairs.filter(move |(_, pair)| acts(&pair[0]) != acts(&pair[1])).map(move |(knot, pair)| (*knot, acts(&pair[1])))
    }

    /// The vector times a matrix.
    #[must_use]
    pub fn transformed(&self, matrix: &Matrix3<f64>) -> Self {
        let pieces = self.pieces.iter().map(|piece| piece.map(|coefficient| matrix * coefficient)).collect();
        Self::new(self.knots.clone(), pieces)
    }

    /// The same, so many seconds earlier.
    #[must_use]
    pub fn earlier_by(&self, seconds: f64) -> Self {
        let knots = self.knots.iter().map(|knot| knot - seconds).collect();
        Self { knots, pieces: self.pieces.clone(), integrals: self.integrals.clone() }
    }

    /// A number that other profiles do not have: FNV-1a of all bits, 128 bits wide.
    #[must_use]
    pub fn fingerprint(&self) -> u128 {
        const OFFSET: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
        const PRIME: u128 = (1 << 88) + 0x13b;
        let coefficients = self.pieces.iter().flatten().flat_map(|vector| vector.iter());
        let bytes = self.knots.iter().chain(coefficients).flat_map(|number| number.to_bits().to_le_bytes());
        bytes.fold(OFFSET, |hash, byte| (hash ^ u128::from(byte)).wrapping_mul(PRIME))
    }
}
