use super::drawing::Point;

/// The corners of `points` that a curve needs so that no point is farther than `tolerance` from it. `[DouglasPeucker73]`
pub fn simplified(points: &[Point], tolerance: f64) -> Vec<Point> {
    if points.len() < 3 {
        return points.to_vec();
    }
    let mut is_kept = vec![false; points.len()];
    is_kept[0] = true;
    is_kept[points.len() - 1] = true;
    // In blocks, so that long curves cost no more than their length.
    let ends: Vec<usize> = (0..points.len() - 1).step_by(BLOCK).chain([points.len() - 1]).collect();
    let mut open: Vec<(usize, usize)> = ends.windows(2).map(|pair| (pair[0], pair[1])).collect();
    for end in ends {
        is_kept[end] = true;
    }
    while let Some((first, last)) = open.pop() {
        let farthest = (first + 1..last)
            .map(|index| (index, distance(points[index], points[first], points[last])))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((index, _)) = farthest.filter(|(_, distance)| *distance > tolerance) {
            is_kept[index] = true;
            open.extend([(first, index), (index, last)]);
        }
    }
    points.iter().zip(is_kept).filter(|(_, is_kept)| *is_kept).map(|(point, _)| *point).collect()
}

const BLOCK: usize = 512;

/// Of a point from the piece between two others.
fn distance(point: Point, from: Point, to: Point) -> f64 {
    let [way_x, way_y] = [to[0] - from[0], to[1] - from[1]];
    let [x, y] = [point[0] - from[0], point[1] - from[1]];
    let length = way_x * way_x + way_y * way_y;
    let part = if length > 0.0 { ((x * way_x + y * way_y) / length).clamp(0.0, 1.0) } else { 0.0 };
    libm::hypot(x - part * way_x, y - part * way_y)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_needs_its_ends_and_a_spike_its_tip() {
        let mut points: Vec<Point> = (0..500).map(|index| [f64::from(index), 0.0]).collect();
        assert_eq!(simplified(&points, 0.05).len(), 2);
        points[250][1] = 3.0;
        let kept = simplified(&points, 0.05);
        assert!(kept.contains(&[250.0, 3.0]) && kept.contains(&[249.0, 0.0]) && kept.contains(&[251.0, 0.0]));
        assert_eq!(kept.len(), 5);
    }
}
