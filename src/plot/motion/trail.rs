use std::collections::HashSet;

use nalgebra::Vector3;

/// A curve in space in flat memory: what goes again where it went before is not kept again.
#[derive(Debug, Clone)]
pub struct Trail {
    strokes: Vec<Vec<Vector3<f64>>>,
    /// Cells of space that it has been in.
    been: HashSet<[i32; 3]>,
    last: Option<Vector3<f64>>,
    count: usize,
    /// Cells to a unit of length.
    cells: f64,
    first: Option<Vector3<f64>>,
    /// When it could keep no more.
    full_at_s: Option<f64>,
}

impl Trail {
    /// Points at most.
    const MOST: usize = 30_000;

    /// Of a curve that is about `size` large.
    pub fn new(size: f64) -> Self {
        Self {
            strokes: Vec::new(),
            been: HashSet::new(),
            last: None,
            count: 0,
            cells: 640.0 / size,
            first: None,
            full_at_s: None,
        }
    }

    /// The next point. What is no number breaks the curve.
    pub fn push(&mut self, time_s: f64, point: Vector3<f64>) {
        if !point.iter().all(|part| part.is_finite()) {
            self.last = None;
            return;
        }
        self.first.get_or_insert(point);
        if self.full_at_s.is_some() {
            return;
        }
        if self.count >= Self::MOST {
            self.full_at_s = Some(time_s);
            return;
        }
        let cell = self.cell(&point);
        let Some(last) = self.last else {
            self.been.insert(cell);
            self.last = Some(point);
            return;
        };
        if self.cell(&last) == cell {
            return;
        }
        if self.goes_where_it_was_not(&last, &point) {
            match self.strokes.last_mut() {
                Some(stroke) if stroke.last() == Some(&last) => stroke.push(point),
                _ => self.strokes.push(vec![last, point]),
            }
            self.count += 1;
        }
        self.last = Some(point);
    }

    /// Whether a piece goes through any cell for the first time.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1 … 4096")]
    fn goes_where_it_was_not(&mut self, from: &Vector3<f64>, to: &Vector3<f64>) -> bool {
        let steps = ((to - from).norm() * self.cells).ceil().clamp(1.0, 4096.0) as u32;
        let mut is_new = false;
        for step in 1..=steps {
            let cell = self.cell(&(from + (to - from) * (f64::from(step) / f64::from(steps))));
            is_new |= self.been.insert(cell);
        }
        is_new
    }

    /// Its pieces.
    pub fn strokes(&self) -> &[Vec<Vector3<f64>>] {
        &self.strokes
    }

    /// Where it began.
    pub fn first(&self) -> Option<Vector3<f64>> {
        self.first
    }

    /// Until when it was drawn, if not to its end, s.
    pub fn full_at_s(&self) -> Option<f64> {
        self.full_at_s
    }

    #[expect(clippy::cast_possible_truncation, reason = "it saturates: a cell that is too far is one cell")]
    fn cell(&self, point: &Vector3<f64>) -> [i32; 3] {
        [point.x, point.y, point.z].map(|part| (part * self.cells).floor() as i32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circle(angle: f64) -> Vector3<f64> {
        let (sin, cos) = libm::sincos(angle);
        Vector3::new(cos, sin, 0.0)
    }

    #[test]
    fn a_circle_is_kept_once_however_often_it_is_gone() {
        let mut trail = Trail::new(1.0);
        for index in 0..200_000 {
            trail.push(0.0, circle(1e-3 * f64::from(index)));
        }
        let points: usize = trail.strokes().iter().map(Vec::len).sum();
        assert!(points < 12_000, "{points}");
        assert_eq!(trail.full_at_s(), None);
        let length: f64 =
            trail.strokes().iter().flat_map(|stroke| stroke.windows(2)).map(|pair| (pair[1] - pair[0]).norm()).sum();
        assert!(length > std::f64::consts::TAU * 0.99, "{length}");
        // Far from sample to sample, too.
        let mut trail = Trail::new(1.0);
        for index in 0..200_000 {
            trail.push(0.0, circle(0.0501 * f64::from(index)));
        }
        let points: usize = trail.strokes().iter().map(Vec::len).sum();
        assert!(points < 12_000 && trail.full_at_s().is_none(), "{points}");
    }

    #[test]
    fn what_is_full_says_when() {
        let mut trail = Trail::new(1.0);
        for index in 0..50_000 {
            trail.push(f64::from(index), Vector3::new(0.1 * f64::from(index), 0.0, 0.0));
        }
        assert_eq!(trail.full_at_s(), Some(30_001.0));
    }
}
