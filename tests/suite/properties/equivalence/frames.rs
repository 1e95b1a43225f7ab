//! The same problem in a turned world, in other body axes, and its moments told in the other of the two.

use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;

use super::case::Gap;
use super::{Case, Kind, bodies, case};
use crate::properties::cases;
#[cfg(feature = "serde")]
use crate::properties::starts::vector;
use crate::properties::starts::{attitude, decades, signed};

/// Roundings of each number that a turn of all of them may make, and of what is made of them.
pub const TURNED: f64 = 8.0;

/// When to look, s.
pub const TIMES: [f64; 4] = [0.0, 0.7, 1.9, 4.0];

/// The rows of `found` are those of `expected`, as far as roundings of `case` let them be.
pub fn assert_same(case: &Case, found: &[super::Row], expected: impl Fn(&super::Row) -> super::Row) {
    let (plain, room, size) = case.room(&TIMES);
    let expected: Vec<_> = plain.iter().map(expected).collect();
    let gap = Gap::worst(found, &expected);
    assert!(gap.is_within(TURNED, &room, &size), "{gap:?} of {:?}", gap.share(TURNED, &room, &size));
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn a_turned_world_with_all_in_it_turns_the_motion(mut case in case(), turn in attitude()) {
        // Orbits lie in one plane of the world, whoever turns it.
        case.loads.retain(|(kind, _)| !matches!(kind, Kind::Gradient { .. }));
        let found = case.turned(&turn).rows(&TIMES);
        assert_same(&case, &found, |row| row.turned(&turn));
    }

    #[test]
    fn half_a_turn_about_its_pole_leaves_an_orbit_as_it_was(mut case in case(), mean_motion in decades(-1.0, 0.0)) {
        case.loads.retain(|(kind, _)| !matches!(kind, Kind::Gradient { .. }));
        case.loads.push((Kind::Gradient { mean_motion }, [None, None]));
        let turn = UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(0.0, 0.0, 0.0, 1.0));
        let found = case.turned(&turn).rows(&TIMES);
        assert_same(&case, &found, |row| row.turned(&turn));
    }

    #[test]
    fn other_body_axes_are_another_way_to_say_the_same(mut case in case(), turn in attitude()) {
        case.loads = case.loads.into_iter().map(|(kind, span)| (kind.unlimited(), span)).collect();
        let found = case.in_axes(&turn).rows(&TIMES);
        assert_same(&case, &found, |row| row.in_axes(&turn));
    }

    /// About a principal axis that the body does not leave, a moment in the world is the moment in the body along it.
    #[test]
    fn a_moment_along_a_steady_axis_is_the_same_in_body_and_world(
        (_, turn, mut body) in bodies(), axis in 0..3_usize, spin in signed(-1.0, 0.5), push in signed(-2.0, 0.0), loses in decades(-2.0, 0.0),
    ) {
        let along: Vector3<f64> = turn * Vector3::ith_axis(axis).into_inner();
        let inertia = along.dot(&(body.tensor * along));
        body.rates = along * spin;
        body.loads = vec![(Kind::LinearDamping(loses * inertia), [None, None]), (Kind::ConstantBody(along * (push * inertia)), [None, None])];
        let mut in_world = body.clone();
        in_world.loads[1].0 = Kind::ConstantWorld(body.attitude * along * (push * inertia));
        assert_same(&body, &in_world.rows(&TIMES), |row| *row);
    }

    /// A moment fixed in the one is, by the rotation matrix, a formula in the other.
    #[cfg(feature = "serde")]
    #[test]
    fn a_moment_in_the_world_is_the_turned_moment_in_the_body(mut case in case(), moment in vector(-1.5, 0.3), is_world in any::<bool>()) {
        let unit = case.tensor.trace() / 3.0;
        let (moment, none) = (moment * unit, Vector3::zeros());
        let mut other = case.clone();
        let matrix = nalgebra::Matrix3::identity();
        let (fixed, told) = if is_world {
            let matrix = matrix * 0.0;
            (Kind::ConstantWorld(moment), Kind::FormulaBody { matrix, swing: none, beat: [1.0, 0.0], world: moment })
        } else {
            (Kind::ConstantBody(moment), Kind::FormulaWorld { matrix, swing: none, beat: [1.0, 0.0], body: moment })
        };
        case.loads.push((fixed, [None, None]));
        other.loads.push((told, [None, None]));
        assert_same(&case, &other.rows(&TIMES), |row| *row);
    }
}
