//! How far a free body turns about L while ω comes round in it: 2ET/|L| − Ω, Ω the solid angle that L goes round in the body
//! `[Montgomery91]`. The law knows nothing of how attitudes are made.

use std::f64::consts::TAU;

use nalgebra::Vector3;
use polhode::dynamics::Problem;
use polhode::numerics::DoubleDouble;
use polhode::propagation::{FreeRotation, States};
use proptest::prelude::*;

use super::cases;
use super::motions::{energy, momentum};
use super::starts::free;
use crate::motions::{row, run, state};

/// A quadrature by the trapezium of a periodic function that is this finely resolved is right to rounding: near the
/// separatrix ω lingers for at most 40 of the times in which it goes over.
const POINTS: u32 = 4096;

/// A period of ω in equal parts, both ends included; `None` where ω rests or needs for ever.
fn period(problem: &Problem) -> Option<(f64, States)> {
    let reversals = FreeRotation::reversals(problem).expect("nothing acts")?;
    let period = 2.0 * reversals.interval;
    let times: Vec<f64> = (0..=POINTS).map(|part| period * (f64::from(part) / f64::from(POINTS))).collect();
    period.is_finite().then(|| (period, run(FreeRotation::new(problem).expect("nothing acts"), &times)))
}

/// Ω, by ∮ (1 − cos θ) dφ about the axis that L keeps to one side of.
fn solid_angle(problem: &Problem, states: &States, period: f64) -> f64 {
    let moments = problem.moments.vector();
    let curve: Vec<(Vector3<f64>, Vector3<f64>)> = (0..POINTS as usize)
        .map(|index| {
            let omega = Vector3::from(row(&states.angular_velocity, index));
            (moments.component_mul(&omega).normalize(), omega)
        })
        .collect();
    let keeps_side = |axis: &usize| curve.iter().all(|(along, _)| along[*axis] * curve[0].0[*axis] > 0.0);
    let axis = (0..3).find(keeps_side).expect("L goes round an axis");
    let (x, y, side) = ((axis + 1) % 3, (axis + 2) % 3, curve[0].0[axis].signum());
    let swept = curve.iter().map(|(along, omega)| {
        let rate = along.cross(omega);
        side * (along[x] * rate[y] - along[y] * rate[x]) / (1.0 + side * along[axis])
    });
    // Terms may all be alike, and then f64 rounds every sum of them the same way.
    let sum = swept.fold(DoubleDouble::ZERO, |sum, part| sum + DoubleDouble::from(part));
    sum.hi() * period / f64::from(POINTS)
}

proptest! {
    #![proptest_config(cases(96))]

    #[test]
    fn a_period_turns_by_its_energy_less_its_solid_angle(problem in free()) {
        let Some((period, states)) = period(&problem) else { return Ok(()) };
        let (start, end) = (state(&states, 0), state(&states, POINTS as usize));
        let along = momentum(&problem, &start);
        let turned = end.attitude.world_from_body() * start.attitude.world_from_body().inverse();
        let found = 2.0 * libm::atan2(turned.imag().dot(&along.normalize()), turned.w);
        let turns = 2.0 * energy(&problem, &start) * period / along.norm();
        let off = found - (turns - solid_angle(&problem, &states, period));
        let off = (off - TAU * (off / TAU).round()).abs();
        // T is rounded, and so is every ω: parts of all that the body turns by meanwhile; where L is mostly of the smaller
        // components of ω (a needle's), roundings of ω are the larger parts of it.
        let fastest = (0..=POINTS as usize)
            .map(|index| Vector3::from(row(&states.angular_velocity, index)).norm())
            .fold(0.0, f64::max);
        let lean = problem.moments.vector().max() * fastest / along.norm();
        let room = 1e-14 + 16.0 * f64::EPSILON * period * fastest * lean;
        prop_assert!(off <= room, "off by {off:e} rad, more than {room:e}");
        // ω comes round: the turn is about L alone.
        let across = turned.imag().cross(&along.normalize()).norm();
        prop_assert!(across <= room, "turned across L by {across:e}");
    }
}
