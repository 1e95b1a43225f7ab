/// For each `(error, cost)` whether none other is at least as good in both and better in one.
///
/// Errors at or below `floor` are not told apart. What is not finite is on no front.
#[must_use]
pub fn pareto_front(points: &[(f64, f64)], floor: f64) -> Vec<bool> {
    let seen = |(error, cost): (f64, f64)| (error.max(floor), cost);
    let beats = |a: (f64, f64), b: (f64, f64)| a.0 <= b.0 && a.1 <= b.1 && (a.0 < b.0 || a.1 < b.1);
    let is_on_it = |point: &(f64, f64)| {
        let is_finite = point.0.is_finite() && point.1.is_finite();
        is_finite && !points.iter().any(|other| beats(seen(*other), seen(*point)))
    };
    points.iter().map(is_on_it).collect()
}

#[cfg(test)]
mod tests {
    use super::pareto_front;

    #[test]
    fn keeps_what_nothing_beats() {
        let points = [(1e-3, 1.0), (1e-6, 2.0), (1e-6, 3.0), (1e-4, 2.5), (1e-9, 9.0), (f64::INFINITY, 0.1)];
        assert_eq!(pareto_front(&points, 0.0), [true, true, false, false, true, false]);
    }

    #[test]
    fn does_not_tell_errors_below_the_floor_apart() {
        assert_eq!(pareto_front(&[(1e-13, 1.0), (1e-15, 2.0)], 1e-12), [true, false]);
        assert_eq!(pareto_front(&[(1e-13, 1.0), (1e-15, 1.0)], 1e-12), [true, true]);
    }
}
