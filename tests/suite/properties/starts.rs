//! Random bodies and starts, on logarithmic scales: most of what goes wrong does so where something is small.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use polhode::body::{AngularVelocity, Attitude, PrincipalMoments, State};
use polhode::dynamics::Problem;
use proptest::prelude::*;

/// 10 to a power between two.
pub fn decades(from: f64, to: f64) -> impl Strategy<Value = f64> + Clone {
    (from..to).prop_map(|power| libm::pow(10.0, power))
}

/// Of either sign.
pub fn signed(from: f64, to: f64) -> impl Strategy<Value = f64> + Clone {
    (decades(from, to), any::<bool>()).prop_map(|(size, is_negative)| if is_negative { -size } else { size })
}

/// Moments of any body, in kg m², in any order: spread, flat, needles, nearly round, and next to equal by bits.
pub fn moments() -> impl Strategy<Value = [f64; 3]> {
    let spread = [decades(-12.0, 0.0), decades(-12.0, 0.0), decades(-12.0, 0.0)];
    let spread = spread.prop_map(|[a, b, c]| [b + c, a + c, a + b]);
    let flat = decades(-12.0, 0.0).prop_map(|a| [a, 1.0, a + 1.0]);
    let round = [signed(-16.0, -1.0), signed(-16.0, -1.0), signed(-16.0, -1.0)].prop_map(|d| d.map(|d| 1.0 + d));
    let even = (decades(-12.0, 0.25), any::<bool>()).prop_map(|(a, _)| [1.0, 1.0, a]);
    let shape = prop_oneof![4 => spread, 1 => flat, 1 => round, 2 => even];
    (shape, decades(-12.0, 12.0), 0..3_usize, prop_oneof![4 => Just(0_i32), 1 => -2..3_i32])
        .prop_map(|(shape, size, first, bits)| {
            let mut moments = [0, 1, 2].map(|axis| size * shape[(axis + first) % 3]);
            moments[0] = stepped(moments[0], bits);
            moments
        })
        .prop_filter("moments of a body", |moments| PrincipalMoments::new(*moments).is_ok())
}

/// The f64 so many places on.
pub fn stepped(value: f64, places: i32) -> f64 {
    f64::from_bits(value.to_bits().wrapping_add_signed(i64::from(places)))
}

/// Rates of any direction, the largest 1e-9 to 1e9 rad/s: many near an axis or a plane of two, or on it.
pub fn rates() -> impl Strategy<Value = [f64; 3]> {
    let part =
        || prop_oneof![4 => signed(-3.0, 0.0), 2 => signed(-20.0, 0.0), 1 => Just(0.0), 1 => signed(-130.0, -20.0)];
    ([part(), part(), part()], decades(-9.0, 9.0))
        .prop_filter("turns", |(parts, _)| parts.iter().any(|part| *part != 0.0))
        .prop_map(|(parts, size)| {
            let largest = parts.iter().fold(0.0, |most: f64, part| part.abs().max(most));
            parts.map(|part| part / largest * size)
        })
}

/// Of any direction.
pub fn attitude() -> impl Strategy<Value = UnitQuaternion<f64>> {
    let part = || -1.0..1.0_f64;
    [part(), part(), part(), part()]
        .prop_map(|[w, x, y, z]| Quaternion::new(w, x, y, z))
        .prop_filter("a direction", |q| q.norm() > 0.1)
        .prop_map(UnitQuaternion::new_normalize)
}

/// A vector of any direction, its size on a logarithmic scale.
pub fn vector(from: f64, to: f64) -> impl Strategy<Value = Vector3<f64>> {
    (attitude(), decades(from, to)).prop_map(|(turn, size)| turn * Vector3::new(size, 0.0, 0.0))
}

/// A body on which nothing acts.
pub fn free() -> impl Strategy<Value = Problem> {
    prop_oneof![3 => (moments(), rates(), attitude()).boxed(), 1 => near_separatrix().boxed()]
        .prop_map(|(moments, rates, attitude)| problem(moments, rates, attitude))
}

/// Starts as near to the separatrix as rounding goes, or a little off.
fn near_separatrix() -> impl Strategy<Value = ([f64; 3], [f64; 3], UnitQuaternion<f64>)> {
    let offset = prop_oneof![1 => Just(0.0), 3 => signed(-16.0, -3.0)];
    let moments = moments().prop_filter("three moments", |[a, b, c]| a != b && b != c && c != a);
    (moments, rates(), attitude(), offset).prop_map(|(moments, mut rates, attitude, offset)| {
        let mut axes = [0, 1, 2];
        axes.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
        let [low, middle, high] = axes;
        let share = |axis: usize| moments[axis] * (moments[axis] - moments[middle]).abs();
        rates[low] = rates[high] * (share(high) / share(low)).sqrt() * (1.0 + offset);
        if !(1e-9..=1e12).contains(&rates[low].abs().max(rates[middle].abs()).max(rates[high].abs())) {
            rates = [1.0; 3];
        }
        (moments, rates, attitude)
    })
}

/// As a problem.
pub fn problem(moments: [f64; 3], rates: [f64; 3], attitude: UnitQuaternion<f64>) -> Problem {
    Problem {
        moments: PrincipalMoments::new(moments).expect("moments of a body"),
        mass: Some(1.0),
        initial: State {
            attitude: Attitude::from_world_from_body(attitude),
            angular_velocity: AngularVelocity::new(rates).expect("finite rates"),
            position: Vector3::zeros(),
            velocity: Vector3::zeros(),
        },
        loads: Vec::new(),
        gravity: Vector3::zeros(),
        wants_attitude: true,
        wants_translation: false,
    }
}
