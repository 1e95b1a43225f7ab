use super::drawing::{Point, Rectangle};

/// The parts of a curve inside `frame`; it is broken where a point is no number.
pub fn clipped(points: impl Iterator<Item = Point>, frame: &Rectangle) -> Vec<Vec<Point>> {
    let mut strokes: Vec<Vec<Point>> = Vec::new();
    let mut last: Option<Point> = None;
    for point in points {
        if !(point[0].is_finite() && point[1].is_finite()) {
            last = None;
            continue;
        }
        let Some(before) = last.replace(point) else { continue };
        let Some([start, end]) = inside(before, point, frame) else { continue };
        match strokes.last_mut() {
            Some(stroke) if stroke.last() == Some(&start) => stroke.push(end),
            _ => strokes.push(vec![start, end]),
        }
    }
    strokes
}

/// The part of a piece inside `frame`. `[LiangBarsky84]`
fn inside(from: Point, to: Point, frame: &Rectangle) -> Option<[Point; 2]> {
    let [low, high] = [[frame.left, frame.top], [frame.right(), frame.bottom()]];
    let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let way = to[axis] - from[axis];
        if way == 0.0 {
            if !(low[axis]..=high[axis]).contains(&from[axis]) {
                return None;
            }
            continue;
        }
        let [a, b] = [(low[axis] - from[axis]) / way, (high[axis] - from[axis]) / way];
        enters = enters.max(a.min(b));
        leaves = leaves.min(a.max(b));
    }
    let at = |part: f64| [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])];
    let start = if enters == 0.0 { from } else { at(enters) };
    let end = if leaves == 1.0 { to } else { at(leaves) };
    (enters <= leaves).then_some([start, end])
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Rectangle = Rectangle { left: 0.0, top: 0.0, width: 10.0, height: 10.0 };

    #[test]
    fn a_curve_ends_at_the_frame_and_comes_back() {
        let curve = [[1.0, 5.0], [5.0, 15.0], [9.0, 5.0], [9.5, 5.0]];
        let strokes = clipped(curve.into_iter(), &FRAME);
        assert_eq!(strokes, [vec![[1.0, 5.0], [3.0, 10.0]], vec![[7.0, 10.0], [9.0, 5.0], [9.5, 5.0]]]);
    }

    #[test]
    fn what_is_no_number_breaks_a_curve() {
        let curve = [[1.0, 1.0], [2.0, 2.0], [3.0, f64::NAN], [4.0, 4.0], [5.0, 4.0]];
        assert_eq!(clipped(curve.into_iter(), &FRAME).len(), 2);
        assert!(clipped([[-5.0, -1.0], [20.0, -1.0]].into_iter(), &FRAME).is_empty());
    }
}
