use std::ops::Range;

use crate::study::{Point, WorkPrecision};

/// Decimal logarithms of what a panel shows.
pub struct Scale {
    /// Of errors, rad.
    pub errors: Range<f64>,
    /// Of costs, s.
    pub costs: Range<f64>,
    /// Of the least error drawn: what the reference resolves.
    pub floor: f64,
}

impl Scale {
    /// Whole decades around all points.
    pub fn of(study: &WorkPrecision) -> Self {
        let floor = study.reference.doubt_rad.max(1e-16).log10();
        let costs = || study.points.iter().map(|point| point.cost.median_s.log10());
        let lowest = costs().fold(f64::INFINITY, f64::min).min(-5.0);
        let highest = costs().fold(f64::NEG_INFINITY, f64::max).max(lowest + 1.0);
        Self { errors: floor.floor()..0.0, costs: (lowest - 0.3).floor()..(highest + 0.2).ceil(), floor }
    }

    /// Where a point is drawn: an error that the reference does not resolve, at what it resolves.
    pub fn place(&self, point: &Point) -> (f64, f64) {
        (point.error_rad.log10().max(self.floor), point.cost.median_s.log10())
    }
}

/// 10 to a whole power, as people write it; nothing between.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "as axes call it")]
pub fn power_of_ten(exponent: &f64) -> String {
    if (exponent - exponent.round()).abs() > 1e-6 {
        return String::new();
    }
    let digit = |letter: char| match letter {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        _ => '⁹',
    };
    format!("10{}", format!("{:.0}", exponent + 0.0).chars().map(digit).collect::<String>())
}
