use super::start::{Start, square};
use crate::numerics::DoubleDouble;

/// Where the tilt turns: u′² = β (u − u₁)(u₂ − u)(u₃ − u), u the cosine of the tilt, u₁ ≤ u₂ ≤ 1 ≤ u₃.
///
/// The cubic is formed around the start, and its values at ±1 come from the start too, as squares: so every difference
/// below keeps its relative accuracy, however near two roots are to each other or to ±1.
#[derive(Debug, Clone, Copy)]
pub struct Roots {
    /// u₀ − u₁.
    pub below: DoubleDouble,
    /// u₂ − u₀.
    pub above: DoubleDouble,
    /// u₂ − u₁.
    pub lower_gap: DoubleDouble,
    /// u₃ − u₂.
    pub upper_gap: DoubleDouble,
    /// 1 − u₁.
    pub from_top_1: DoubleDouble,
    /// 1 − u₂.
    pub from_top_2: DoubleDouble,
    /// u₃ − 1.
    pub over_top: DoubleDouble,
    /// 1 + u₁.
    pub from_bottom_1: DoubleDouble,
    /// 1 + u₂.
    pub from_bottom_2: DoubleDouble,
    /// 1 + u₃.
    pub from_bottom_3: DoubleDouble,
    /// b + a.
    pub sum: DoubleDouble,
    /// b − a.
    pub difference: DoubleDouble,
}

/// The two roots of x² − S x + P, the larger first, where they are real.
fn quadratic(sum: DoubleDouble, product: DoubleDouble) -> [DoubleDouble; 2] {
    let discriminant = sum.square() - product.scale(4.0);
    let root = if discriminant.hi() > 0.0 { discriminant.sqrt() } else { DoubleDouble::ZERO };
    if sum.hi() < 0.0 {
        let lower = (sum - root).scale(0.5);
        return [product / lower, lower];
    }
    let higher = (sum + root).scale(0.5);
    [higher, if higher.is_zero() { higher } else { product / higher }]
}

/// Newton's root of x³ + c₂x² + c₁x + c₀ from a value near it.
fn polished([c0, c1, c2]: [DoubleDouble; 3], near: f64) -> DoubleDouble {
    let mut x = DoubleDouble::from(near);
    for _ in 0..12 {
        let value = ((x + c2) * x + c1) * x + c0;
        let slope = (x * 3.0 + c2.scale(2.0)) * x + c1;
        if slope.is_zero() {
            break;
        }
        let step = value / slope;
        x = x - step;
        if step.hi().abs() <= 1e-31 * x.hi().abs() {
            break;
        }
    }
    x
}

/// x₁ ≤ x₂ ≤ x₃ of the cubic, nearly, by cosines.
fn estimates([c0, c1, c2]: [DoubleDouble; 3]) -> [f64; 3] {
    let third = c2 * (DoubleDouble::ONE / 3.0.into());
    let p = (third.square() - c1 / 3.0.into()).hi().max(0.0);
    let q = ((third * c1 - c0).scale(0.5) - third * third.square()).hi();
    let root = p.sqrt();
    if root == 0.0 {
        return [-third.hi(); 3];
    }
    let angle = libm::acos((q / (p * root)).clamp(-1.0, 1.0)) / 3.0;
    let turn = std::f64::consts::TAU / 3.0;
    [turn, -turn, 0.0].map(|part| 2.0 * root * libm::cos(angle + part) - third.hi())
}

/// x₁, x₂ (from zero down and up) and x₂ − x₁: all relative to the start.
fn turning_points(cubic: [DoubleDouble; 3]) -> [DoubleDouble; 3] {
    let [c0, c1, c2] = cubic;
    let near = estimates(cubic);
    if near[2] - near[1] > near[1] - near[0] {
        let third = polished(cubic, near[2]);
        let product = -(c0 / third);
        let [above, below] = quadratic((c1 - product) / third, product);
        return [below, above, above - below];
    }
    let first = polished(cubic, near[0]);
    let [_, second] = if near[0].abs() > near[1] {
        let product = -(c0 / first);
        quadratic((c1 - product) / first, product)
    } else {
        let sum = -(c2 + first);
        quadratic(sum, c1 - first * sum)
    };
    [first, second, second - first]
}

impl Roots {
    /// `None` where the tilt stays.
    pub fn new(start: &Start) -> Option<Self> {
        let (beta, spin) = (start.strength, start.spin);
        let [a2, b2] = start.pair.map(square); // (1 ± u₀)/2
        let (speed, upright, u0) = (square(start.across), start.upright_rate(), a2 - b2);
        let cubic = [
            start.slope().square() / beta,
            ((spin * upright - u0 * speed).scale(2.0)) / beta - (a2 * b2).scale(4.0),
            u0.scale(2.0) - (speed + spin.square()) / beta,
        ];
        let [below, above, lower_gap] = turning_points(cubic);
        let is_along = a2.is_zero() || b2.is_zero();
        if lower_gap.is_zero() || (is_along && speed.is_zero()) {
            return None;
        }
        let (sum, difference) = (upright + (spin * a2).scale(2.0), upright - (spin * b2).scale(2.0));
        let from_top_1 = b2.scale(2.0) - below;
        let from_bottom_2 = a2.scale(2.0) + above;
        // 1 − u₂ and 1 − u₃ by the other two symmetric functions of the cubic in 1 − u.
        let product = difference.square() / (beta * from_top_1);
        let middle = speed - (beta * b2).scale(2.0) - spin * difference;
        let upper_sum = (product - (middle / beta).scale(2.0)) / from_top_1;
        let [from_top_2, minus_over_top] = quadratic(upper_sum, -product);
        let from_bottom_3 = DoubleDouble::from(2.0) - minus_over_top;
        Some(Self {
            below: -below,
            above,
            lower_gap,
            upper_gap: from_top_2 - minus_over_top,
            from_top_1,
            from_top_2,
            over_top: -minus_over_top,
            from_bottom_1: sum.square() / (beta * from_bottom_2 * from_bottom_3),
            from_bottom_2,
            from_bottom_3,
            sum,
            difference,
        })
    }
}
