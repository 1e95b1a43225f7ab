//! The same problem cut in time: loads in two windows where they were in one, and begun again from a state on the way.

use std::path::Path;

use nalgebra::{UnitQuaternion, Vector3};
use polhode::propagation::States;
use proptest::prelude::*;

use super::case::planned;
use super::frames::{TIMES, assert_same};
use super::kinds::{begun, later};
use super::{Case, Kind, Span, case};
use crate::properties::cases;

/// A span in several, end to end.
fn cut(&[start, end]: &Span, cuts: &[f64]) -> Vec<Span> {
    let mut cuts: Vec<f64> =
        cuts.iter().copied().filter(|cut| *cut > start.unwrap_or(0.0) && end.is_none_or(|end| *cut < end)).collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();
    let starts = [start].into_iter().chain(cuts.iter().copied().map(Some));
    let ends = cuts.iter().copied().map(Some).chain([end]);
    starts.zip(ends).map(|(start, end)| [start, end]).collect()
}

/// The same case, its loads acting in as many windows as `cuts` make.
fn in_windows(case: &Case, cuts: &[f64]) -> Case {
    let loads = case.loads.iter().flat_map(|(kind, span)| {
        let spans = if kind.has_span() { cut(span, cuts) } else { vec![*span] };
        spans.into_iter().map(|span| (kind.clone(), span))
    });
    Case { loads: loads.collect(), ..case.clone() }
}

/// The same motion, told from `from` on, s; `None` where a controller would then go the other way round.
fn begun_at(case: &Case, from: f64) -> Option<(Case, UnitQuaternion<f64>)> {
    let row = case.rows(&[from])[0];
    let mut loads = Vec::new();
    let mut turn = UnitQuaternion::identity();
    for (kind, span) in &case.loads {
        let Some(span) = later(span, from) else { continue };
        let mut kind = kind.later(from);
        match &mut kind {
            Kind::Gradient { mean_motion } => turn = begun(*mean_motion, from),
            Kind::Sphere { relative, .. } => *relative = relative_rate(case, from),
            Kind::Feedback { target, .. } => {
                let way = |attitude: &UnitQuaternion<f64>| (target.inverse() * attitude).w < 0.0;
                if way(&case.attitude) != way(&row.attitude) {
                    return None;
                }
            }
            _ => {}
        }
        loads.push((kind, span));
    }
    let start = Case {
        attitude: UnitQuaternion::new_normalize(row.attitude.into_inner()),
        rates: row.rates,
        position: row.position,
        velocity: row.velocity,
        loads,
        ..case.clone()
    };
    Some((start.turned(&turn), turn))
}

/// Of a sphere inside, body axes, rad/s.
fn relative_rate(case: &Case, time: f64) -> Vector3<f64> {
    let body = planned(case.spec(), Path::new(""));
    let mut states = States::default();
    body.propagator().expect("covered").fill(&[time], &mut states).expect("a finite motion");
    body.properties.body_from_principal * Vector3::from(states.inner.each_ref().map(|column| column[0]))
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn windows_end_to_end_are_one_window(case in case(), cuts in prop::collection::vec(0.0..4.5_f64, 1..4)) {
        assert_same(&case, &in_windows(&case, &cuts).rows(&TIMES), |row| *row);
    }

    #[test]
    fn a_motion_begun_again_on_the_way_goes_on(case in case(), from in 0.05..3.0_f64) {
        let begun = begun_at(&case, from);
        prop_assume!(begun.is_some());
        let Some((later, turn)) = begun else { unreachable!("assumed") };
        let on = TIMES.map(|time| time + from);
        let through: Vec<_> = case.rows(&on).iter().map(|row| row.turned(&turn)).collect();
        assert_same(&later, &through, |row| *row);
    }
}
