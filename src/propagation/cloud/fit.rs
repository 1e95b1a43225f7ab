use super::motion::{Motion, Springs};
use super::vector::{Vector, cross, dot, matrix, scaled, solved, sum, tensor, turned_back, unit};
use crate::numerics::{DoubleDouble, Scalar};

/// Corrections at most: each squares the error of the one before.
const MOST_CORRECTIONS: usize = 40;

/// The attitude of the cloud as a whole, world from principal axes: the rotation that brings its places nearest to where
/// its particles are, Σ mᵢ |rᵢ − R pᵢ|² being least, by Newton's method from a rotation near it. The quaternion's sign is
/// that of the one given. `None` where the particles are so far from any rotation of their places that there is no nearest.
///
/// With yᵢ = Rᵀ rᵢ the turn δ that is left, in the body, solves Σ mᵢ (yᵢ·pᵢ E − (yᵢ pᵢᵀ + pᵢ yᵢᵀ)/2) δ = Σ mᵢ pᵢ × yᵢ. The matrix
/// is the inertia tensor where yᵢ = pᵢ. `enough` is the turn, rad, whose square no longer counts in the scalar's digits.
pub(super) fn fit<F: Scalar>(springs: &Springs, motion: &Motion, near: [F; 4], enough: f64) -> Option<[F; 4]> {
    let mut attitude = near;
    let (half, enough) = (F::from(0.5), F::from(enough * enough));
    for _ in 0..MOST_CORRECTIONS {
        let rows = matrix(attitude);
        let terms = || {
            let each = springs.cloud.masses().iter().zip(springs.cloud.places()).zip(&motion.positions);
            each.map(|((mass, place), position)| {
                let place = <[f64; 3]>::from(*place).map(F::from);
                (F::from(*mass), place, turned_back(rows, Motion::rounded::<F>(*position)))
            })
        };
        let zero = [F::from(0.0); 3];
        let left = terms().fold(zero, |left, (mass, place, seen)| sum(left, scaled(mass, cross(place, seen))));
        let turn = solved(tensor(terms()), left);
        let [w, x, y, z] = attitude;
        let [i, j, k] = scaled(half, turn);
        attitude = unit([
            w - (x * i + y * j + z * k),
            x + (w * i + y * k - z * j),
            y + (w * j + z * i - x * k),
            z + (w * k + x * j - y * i),
        ]);
        let size = dot(turn, turn);
        if size <= enough {
            return Some(attitude);
        }
        if !size.rounded().is_finite() {
            return None;
        }
    }
    None
}

/// L = Σ mᵢ rᵢ × vᵢ about the centre of mass, world axes, N m s.
pub(super) fn momentum<F: Scalar>(springs: &Springs, motion: &Motion) -> Vector<F> {
    let each = springs.cloud.masses().iter().zip(&motion.positions).zip(&motion.velocities);
    each.fold([F::from(0.0); 3], |whole, ((mass, position), velocity)| {
        let moment = cross(Motion::rounded::<F>(*position), Motion::rounded::<F>(*velocity));
        sum(whole, scaled(F::from(*mass), moment))
    })
}

/// How fast that attitude turns, principal axes, rad/s.
///
/// Σ mᵢ pᵢ × yᵢ stays zero, and ẏᵢ is Rᵀ vᵢ − ω × yᵢ: the matrix of [`fit`], which has no antisymmetric part there, times ω is
/// Σ mᵢ pᵢ × Rᵀ vᵢ.
pub(super) fn rates<F: Scalar>(springs: &Springs, motion: &Motion, attitude: [F; 4]) -> Vector<F> {
    let rows = matrix(attitude);
    let each = || {
        let particles = springs.cloud.masses().iter().zip(springs.cloud.places());
        particles.zip(motion.positions.iter().zip(&motion.velocities)).map(|((mass, place), (position, velocity))| {
            let place = <[f64; 3]>::from(*place).map(F::from);
            let seen = |vector: &Vector<DoubleDouble>| turned_back(rows, Motion::rounded::<F>(*vector));
            (F::from(*mass), place, seen(position), seen(velocity))
        })
    };
    let zero = [F::from(0.0); 3];
    let turning = each().fold(zero, |whole, (mass, place, _, moves)| sum(whole, scaled(mass, cross(place, moves))));
    solved(tensor(each().map(|(mass, place, seen, _)| (mass, place, seen))), turning)
}
