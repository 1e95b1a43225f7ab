use nalgebra::Vector3;

/// The slopes at `points`, (s, value), of the cubic spline with two continuous derivatives through them, not-a-knot
/// `[deBoor01]` §IV: the first two pieces are one cubic, and the last two. Of three points a parabola, of two a line.
pub(super) fn slopes(points: &[(f64, Vector3<f64>)]) -> Vec<Vector3<f64>> {
    let lengths: Vec<f64> = points.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
    let secants: Vec<Vector3<f64>> =
        points.windows(2).zip(&lengths).map(|(pair, length)| (pair[1].1 - pair[0].1) / *length).collect();
    match (lengths.as_slice(), secants.as_slice()) {
        (_, []) => vec![Vector3::zeros(); points.len()],
        (_, [only]) => vec![*only; 2],
        ([a, b], [before, after]) => {
            let curvature = (after - before) / (a + b);
            vec![before - curvature * *a, before + curvature * *a, after + curvature * *b]
        }
        _ => solve(rows(&lengths, &secants)),
    }
}

/// One equation: what is before the diagonal, on it and behind it, and the right side.
type Row = ([f64; 3], Vector3<f64>);

/// The slopes' equations: the second derivative is continuous at the inner knots, the third next to the ends.
fn rows(lengths: &[f64], secants: &[Vector3<f64>]) -> Vec<Row> {
    let end = |[near, next]: [f64; 2], [first, second]: [Vector3<f64>; 2]| {
        let both = near + next;
        (both, ((near + 2.0 * both) * next * first + near * near * second) / both)
    };
    let last = lengths.len() - 1;
    let (both, right) = end([lengths[0], lengths[1]], [secants[0], secants[1]]);
    let mut rows = vec![([0.0, lengths[1], both], right)];
    for (lengths, secants) in lengths.windows(2).zip(secants.windows(2)) {
        let [a, b] = [lengths[0], lengths[1]];
        rows.push(([b, 2.0 * (a + b), a], 3.0 * (b * secants[0] + a * secants[1])));
    }
    let (both, right) = end([lengths[last], lengths[last - 1]], [secants[last], secants[last - 1]]);
    rows.push(([both, lengths[last - 1], 0.0], right));
    rows
}

/// Elimination without exchange: after the first row, every pivot outweighs what stands beside it.
fn solve(mut rows: Vec<Row>) -> Vec<Vector3<f64>> {
    for index in 1..rows.len() {
        let ([_, pivot, behind], right) = rows[index - 1];
        let ([before, diagonal, _], own) = &mut rows[index];
        let factor = *before / pivot;
        *diagonal -= factor * behind;
        *own -= factor * right;
    }
    let mut slopes = vec![Vector3::zeros(); rows.len()];
    let mut later = Vector3::zeros();
    for (([_, pivot, behind], right), slope) in rows.iter().zip(&mut slopes).rev() {
        later = (right - *behind * later) / *pivot;
        *slope = later;
    }
    slopes
}
