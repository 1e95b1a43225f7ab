//! Principal axes of a symmetric tensor: cyclic Jacobi, then the choice of axes nearest to the given ones.

use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

/// Moments closer than this, relative to the largest, are one moment: the diagonalisation cannot tell them apart.
const SAME_MOMENT: f64 = 4.0 * f64::EPSILON;

/// Half an angle, rad, that turns no vector by more than its rounding: what assembling a body leaves of an exact zero.
const NO_TURN: f64 = f64::EPSILON;

/// Three or four sweeps do; the rest is for tensors that are not positive, which are refused later.
const MOST_SWEEPS: usize = 32;

/// The principal moments of a symmetric finite `tensor`, and the right-handed rotation `body_from_principal`.
///
/// Jacobi's method keeps small moments of graded tensors to their own last digits where QR would keep them to those of
/// the largest (`[DV92]`). A tensor diagonal to rounding gives the identity exactly and keeps the order of its axes;
/// otherwise axes are ordered, signed and (in a plane of equal moments) turned so that the rotation is smallest.
pub(super) fn principal_axes(tensor: &Matrix3<f64>) -> (Vector3<f64>, UnitQuaternion<f64>) {
    let largest = tensor.amax();
    if largest <= 0.0 {
        return (Vector3::zeros(), UnitQuaternion::identity());
    }
    // A power of two near 1/largest, so that products of elements neither overflow nor vanish. Exact.
    let exponent = libm::ilogb(largest).clamp(-1000, 1000);
    let mut scaled = tensor.map(|element| libm::scalbn(element, -exponent));
    let mut axes = Matrix3::identity();
    for _ in 0..MOST_SWEEPS {
        // Every rotation must run: no short circuit.
        let turned = [(0, 1), (0, 2), (1, 2)].map(|(p, q)| rotate_to_zero(&mut scaled, &mut axes, p, q));
        if turned == [false; 3] {
            break;
        }
    }
    if axes == Matrix3::identity() {
        return (tensor.diagonal(), UnitQuaternion::identity());
    }
    let (mut moments, mut axes) = nearest_order(&scaled.diagonal(), &axes);
    merge_equal_moments(&mut moments, &mut axes);
    let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
    let moments = moments.map(|moment| libm::scalbn(moment, exponent));
    if rotation.imag().norm() <= NO_TURN {
        return (moments, UnitQuaternion::identity());
    }
    // The conversion leaves a rounding error in the length.
    (moments, UnitQuaternion::new_normalize(rotation.into_inner()))
}

/// One Jacobi rotation in the plane of axes `p` and `q`; false if their product of inertia is rounding already.
fn rotate_to_zero(tensor: &mut Matrix3<f64>, axes: &mut Matrix3<f64>, p: usize, q: usize) -> bool {
    let product = tensor[(p, q)];
    // Relative to both diagonal elements, not to the largest of all: this is what keeps small moments accurate.
    if product.abs() <= 0.5 * f64::EPSILON * (tensor[(p, p)].abs() * tensor[(q, q)].abs()).sqrt() {
        tensor[(p, q)] = 0.0;
        tensor[(q, p)] = 0.0;
        return false;
    }
    let cotangent_of_double = (tensor[(q, q)] - tensor[(p, p)]) / (2.0 * product);
    let tangent =
        1.0_f64.copysign(cotangent_of_double) / (cotangent_of_double.abs() + libm::hypot(1.0, cotangent_of_double));
    let cosine = 1.0 / libm::hypot(1.0, tangent);
    let sine = tangent * cosine;
    tensor[(p, p)] -= tangent * product;
    tensor[(q, q)] += tangent * product;
    tensor[(p, q)] = 0.0;
    tensor[(q, p)] = 0.0;
    let r = 3 - p - q;
    let (along_p, along_q) = (tensor[(r, p)], tensor[(r, q)]);
    tensor[(r, p)] = cosine * along_p - sine * along_q;
    tensor[(r, q)] = sine * along_p + cosine * along_q;
    tensor[(p, r)] = tensor[(r, p)];
    tensor[(q, r)] = tensor[(r, q)];
    let (axis_p, axis_q) = (axes.column(p).into_owned(), axes.column(q).into_owned());
    axes.set_column(p, &(axis_p * cosine - axis_q * sine));
    axes.set_column(q, &(axis_p * sine + axis_q * cosine));
    true
}

/// Of the 24 right-handed orders and signs of the axes, the one with the largest trace: the smallest rotation.
fn nearest_order(moments: &Vector3<f64>, axes: &Matrix3<f64>) -> (Vector3<f64>, Matrix3<f64>) {
    const ORDERS: [([usize; 3], f64); 6] =
        [([0, 1, 2], 1.0), ([1, 2, 0], 1.0), ([2, 0, 1], 1.0), ([0, 2, 1], -1.0), ([1, 0, 2], -1.0), ([2, 1, 0], -1.0)];
    const SIGNS: [[f64; 2]; 4] = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
    let mut best = (f64::NEG_INFINITY, *moments, *axes);
    for (order, parity) in ORDERS {
        for [first, second] in SIGNS {
            let signs = [first, second, parity * first * second];
            let trace: f64 = (0..3).map(|axis| signs[axis] * axes[(axis, order[axis])]).sum();
            if trace > best.0 {
                let columns = [0, 1, 2].map(|axis| axes.column(order[axis]) * signs[axis]);
                best = (trace, Vector3::from(order.map(|axis| moments[axis])), Matrix3::from_columns(&columns));
            }
        }
    }
    (best.1, best.2)
}

/// Makes moments that agree to rounding equal, and turns their axes within their plane towards the body axes.
fn merge_equal_moments(moments: &mut Vector3<f64>, axes: &mut Matrix3<f64>) {
    let room = SAME_MOMENT * moments.amax();
    if moments.max() - moments.min() <= room {
        *moments = Vector3::repeat(moments.mean());
        *axes = Matrix3::identity();
        return;
    }
    for (p, q) in [(0, 1), (1, 2), (0, 2)] {
        if (moments[p] - moments[q]).abs() > room {
            continue;
        }
        let mean = 0.5 * (moments[p] + moments[q]);
        moments[p] = mean;
        moments[q] = mean;
        // The turn (c, s) that makes axes[pp] + axes[qq] largest.
        let along = axes[(p, p)] + axes[(q, q)];
        let across = axes[(p, q)] - axes[(q, p)];
        let length = libm::hypot(along, across);
        if length > 0.0 {
            let (cosine, sine) = (along / length, across / length);
            let (axis_p, axis_q) = (axes.column(p).into_owned(), axes.column(q).into_owned());
            axes.set_column(p, &(axis_p * cosine + axis_q * sine));
            axes.set_column(q, &(axis_q * cosine - axis_p * sine));
        }
        return;
    }
}
