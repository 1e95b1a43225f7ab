//! Vectors of any scalar.

use crate::numerics::Scalar;

pub(super) type Vector<F> = [F; 3];

pub(super) fn sum<F: Scalar>(a: Vector<F>, b: Vector<F>) -> Vector<F> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(super) fn difference<F: Scalar>(a: Vector<F>, b: Vector<F>) -> Vector<F> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn scaled<F: Scalar>(factor: F, a: Vector<F>) -> Vector<F> {
    a.map(|component| factor * component)
}

/// a · b, in the order of [`Tape::dot`](crate::numerics::Tape::dot).
pub(super) fn dot<F: Scalar>(a: Vector<F>, b: Vector<F>) -> F {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross<F: Scalar>(a: Vector<F>, b: Vector<F>) -> Vector<F> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// x of A x = b, of a matrix by rows, by its cofactors.
pub(super) fn solved<F: Scalar>([a, b, c]: [Vector<F>; 3], right: Vector<F>) -> Vector<F> {
    let (first, second, third) = (cross(b, c), cross(c, a), cross(a, b));
    let determinant = dot(a, first);
    let whole = sum(sum(scaled(right[0], first), scaled(right[1], second)), scaled(right[2], third));
    whole.map(|component| component / determinant)
}

/// Σ mᵢ (aᵢ·bᵢ E − ½ (aᵢ bᵢᵀ + bᵢ aᵢᵀ)), by rows; of aᵢ = bᵢ the inertia tensor.
pub(super) fn tensor<F: Scalar>(terms: impl Iterator<Item = (F, Vector<F>, Vector<F>)>) -> [Vector<F>; 3] {
    let mut tensor = [[F::from(0.0); 3]; 3];
    for (mass, a, b) in terms {
        let along = dot(a, b);
        for (i, row) in tensor.iter_mut().enumerate() {
            for (j, element) in row.iter_mut().enumerate() {
                let both = F::from(0.5) * (a[i] * b[j] + b[i] * a[j]);
                *element = *element + mass * if i == j { along - both } else { -both };
            }
        }
    }
    tensor
}

/// The rotation matrix of a quaternion w, x, y, z of unit length, by rows.
pub(super) fn matrix<F: Scalar>([w, x, y, z]: [F; 4]) -> [Vector<F>; 3] {
    let twice = |a: F, b: F| F::from(2.0) * (a * b);
    let (xy, xz, yz) = (twice(x, y), twice(x, z), twice(y, z));
    let (wx, wy, wz) = (twice(w, x), twice(w, y), twice(w, z));
    let [ww, xx, yy, zz] = [w * w, x * x, y * y, z * z];
    [
        [ww + xx - (yy + zz), xy - wz, xz + wy],
        [xy + wz, ww + yy - (xx + zz), yz - wx],
        [xz - wy, yz + wx, ww + zz - (xx + yy)],
    ]
}

/// R a.
pub(super) fn turned<F: Scalar>(rows: [Vector<F>; 3], a: Vector<F>) -> Vector<F> {
    rows.map(|row| dot(row, a))
}

/// Rᵀ a.
pub(super) fn turned_back<F: Scalar>([x, y, z]: [Vector<F>; 3], a: Vector<F>) -> Vector<F> {
    sum(sum(scaled(a[0], x), scaled(a[1], y)), scaled(a[2], z))
}

/// The quaternion of unit length along q.
pub(super) fn unit<F: Scalar>(q: [F; 4]) -> [F; 4] {
    let length = q.iter().fold(F::from(0.0), |sum, component| sum + *component * *component).root();
    q.map(|component| component / length)
}
