use super::mapping::Sense;

/// A quaternion w, x, y, z.
pub(in crate::recording) type Quaternion = [f64; 4];

/// How far a matrix may be from a rotation, entry by entry of R Rᵀ, before it is taken for none.
const LEAST_ORTHOGONAL: f64 = 1e-3;

/// Of modified Rodrigues parameters σ = e tan(φ/4), `[SJ18]` §3.6.
pub(super) fn from_mrp([x, y, z]: [f64; 3]) -> Quaternion {
    let square = x * x + y * y + z * z;
    if square == f64::INFINITY {
        // A whole turn, to 1e-154.
        return [-1.0, 0.0, 0.0, 0.0];
    }
    let scale = 1.0 / (1.0 + square);
    [(1.0 - square) * scale, 2.0 * x * scale, 2.0 * y * scale, 2.0 * z * scale]
}

/// Of three turns, rad, about axes (0 to 2) of the body, one after the other.
pub(super) fn from_euler(angles: [f64; 3], sequence: [usize; 3]) -> Quaternion {
    let turn = |place: usize| {
        let (sine, cosine) = libm::sincos(angles[place] / 2.0);
        let mut turn = [cosine, 0.0, 0.0, 0.0];
        turn[1 + sequence[place]] = sine;
        turn
    };
    product(product(turn(0), turn(1)), turn(2))
}

/// Of a rotation matrix, row by row: of the four ways that of the largest divisor. `None` if it is no rotation.
pub(in crate::recording) fn from_matrix(m: [f64; 9]) -> Option<Quaternion> {
    let is_near = |row: usize, column: usize| {
        let dot: f64 = (0..3).map(|k| m[3 * row + k] * m[3 * column + k]).sum();
        (dot - f64::from(u8::from(row == column))).abs() < LEAST_ORTHOGONAL
    };
    let determinant =
        m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
    if determinant <= 0.0 || !(0..3).all(|row| (row..3).all(|column| is_near(row, column))) {
        return None;
    }
    let trace = m[0] + m[4] + m[8];
    // Four times the squares of w, x, y, z.
    let squares = [1.0 + trace, 1.0 + 2.0 * m[0] - trace, 1.0 + 2.0 * m[4] - trace, 1.0 + 2.0 * m[8] - trace];
    let largest = (1..4).fold(0, |best, next| if squares[next] > squares[best] { next } else { best });
    let four_q = 2.0 * squares[largest].sqrt();
    let (wx, wy, wz) = (m[7] - m[5], m[2] - m[6], m[3] - m[1]);
    let (xy, xz, yz) = (m[1] + m[3], m[2] + m[6], m[5] + m[7]);
    let products = match largest {
        0 => [squares[0], wx, wy, wz],
        1 => [wx, squares[1], xy, xz],
        2 => [wy, xy, squares[2], yz],
        _ => [wz, xz, yz, squares[3]],
    };
    Some(products.map(|product| product / four_q))
}

/// As world from body.
pub(super) fn in_sense([w, x, y, z]: Quaternion, sense: Sense) -> Quaternion {
    match sense {
        Sense::WorldFromBody => [w, x, y, z],
        Sense::BodyFromWorld => [w, -x, -y, -z],
    }
}

/// Chooses the signs that continue each other, where a file has none: it told the attitude in another form.
pub(in crate::recording) fn continue_signs(columns: &mut [Vec<f64>; 4]) {
    for index in 1..columns[0].len() {
        let dot: f64 = columns.iter().map(|column| column[index] * column[index - 1]).sum();
        if dot < 0.0 {
            for column in columns.iter_mut() {
                column[index] = -column[index];
            }
        }
    }
}

/// Hamilton's product.
fn product([a, b, c, d]: Quaternion, [e, f, g, h]: Quaternion) -> Quaternion {
    [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, Quaternion as Turn, UnitQuaternion, Vector3};

    use super::*;

    fn turn([w, x, y, z]: Quaternion) -> UnitQuaternion<f64> {
        UnitQuaternion::new_unchecked(Turn::new(w, x, y, z))
    }

    /// A few roundings of numbers about 1.
    const ROUNDING: f64 = 1e-15;

    #[test]
    fn every_form_of_an_attitude_is_the_same_turn() {
        for (index, axis) in [[1.0, 2.0, 3.0], [-3.0, 0.1, 0.2], [0.1, -4.0, 0.3], [0.2, 0.1, 5.0]].iter().enumerate() {
            let axis = Vector3::from(*axis).normalize();
            for angle in [0.1, 1.0, 3.0] {
                let expected = UnitQuaternion::new(axis * angle);
                let mrp = turn(from_mrp((axis * libm::tan(angle / 4.0)).into()));
                assert!(expected.angle_to(&mrp) < 4.0 * ROUNDING, "MRP, case {index}");
                let matrix: Matrix3<f64> = expected.to_rotation_matrix().into_inner();
                let rows: [f64; 9] = std::array::from_fn(|place| matrix[(place / 3, place % 3)]);
                let from_rows = turn(from_matrix(rows).expect("a rotation"));
                assert!((expected.inverse() * from_rows).imag().norm() < 2.0 * ROUNDING, "matrix, case {index}");
            }
        }
    }

    #[test]
    fn whole_turns_are_far_off_among_mrp() {
        for far in [1e100, 1e153, 1e154, 1e200, f64::MAX] {
            assert_eq!(from_mrp([0.0, far, far])[0], -1.0, "{far:e}");
            assert!(from_mrp([0.0, far, -far]).iter().all(|part| part.is_finite()), "{far:e}");
        }
    }

    #[test]
    fn yaw_pitch_roll_turn_about_the_axes_of_the_body() {
        let about = |axis: Vector3<f64>, angle: f64| UnitQuaternion::new(axis * angle);
        let expected = about(Vector3::z(), 0.3) * about(Vector3::y(), -0.4) * about(Vector3::x(), 2.0);
        let found = turn(from_euler([0.3, -0.4, 2.0], [2, 1, 0]));
        assert!((expected.inverse() * found).imag().norm() < ROUNDING);
    }

    #[test]
    fn what_is_no_rotation_is_refused() {
        assert_eq!(from_matrix([1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0]), None, "a mirror");
        assert_eq!(from_matrix([1.1, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]), None, "a stretch");
        assert_eq!(from_matrix([f64::NAN; 9]), None);
    }

    #[test]
    fn signs_continue() {
        let mut columns = [vec![1.0, -0.9], vec![0.0, -0.1], vec![0.0, 0.0], vec![0.0, 0.0]];
        continue_signs(&mut columns);
        assert_eq!((columns[0][1], columns[1][1]), (0.9, 0.1));
    }
}
