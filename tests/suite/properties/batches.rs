//! How samples are asked for is no part of the motion: in one call or in many, these or more of them.

use polhode::dynamics::Problem;
use polhode::propagation::{Dop853, FixedStep, FixedStepMethod, FreeRotation, LagrangeTop, Propagator, States, Taylor};
use proptest::prelude::*;

use super::cases;
use super::closed_forms::{pace, top};
use super::motions::speed;
use super::starts::{decades, free};
use super::stepped::loaded;
use crate::motions::run;

/// Ascending times up to `end`, with some twice, and where to cut them.
fn asked() -> impl Strategy<Value = (Vec<f64>, Vec<usize>)> {
    let times = prop::collection::vec(prop_oneof![0.0..1.0_f64, Just(0.0), Just(0.5), decades(-9.0, 0.0)], 1..60);
    (times, prop::collection::vec(0..60_usize, 0..6)).prop_map(|(mut times, mut cuts)| {
        times.sort_by(f64::total_cmp);
        for cut in &mut cuts {
            *cut = (*cut).min(times.len());
        }
        cuts.sort_unstable();
        (times, cuts)
    })
}

/// The states in one call are those in many, to the bit.
fn same<P: Propagator>(times: &[f64], cuts: &[usize], motion: impl Fn() -> P) {
    let together = run(motion(), times);
    let (mut motion, mut part, mut first) = (motion(), States::default(), 0);
    for end in cuts.iter().copied().chain([times.len()]) {
        motion.fill(&times[first..end], &mut part).expect("ascending");
        let columns = |states: &States| states.attitude.clone().into_iter().chain(states.angular_velocity.clone());
        for (part, whole) in columns(&part).zip(columns(&together)) {
            assert_eq!(part, whole[first..end], "samples {first} to {end}");
        }
        first = end;
    }
}

fn scaled(times: &[f64], end: f64) -> Vec<f64> {
    times.iter().map(|time| time * end).collect()
}

/// A method with a fixed step for it.
fn fixed(problem: &Problem, method: FixedStepMethod, steps: f64, end: f64) -> FixedStep {
    FixedStep::new(problem, method, end / steps).expect("covered")
}

proptest! {
    #![proptest_config(cases(96))]

    #[test]
    fn of_free_motions(problem in free(), (times, cuts) in asked(), turns in decades(-3.0, 9.0)) {
        let times = scaled(&times, turns / speed(&problem));
        same(&times, &cuts, || FreeRotation::new(&problem).expect("nothing acts"));
    }

    #[test]
    fn of_tops(top in top(), (times, cuts) in asked(), turns in decades(-3.0, 6.0)) {
        let times = scaled(&times, turns / pace(&top));
        same(&times, &cuts, || LagrangeTop::new(&top).expect("a top"));
    }

    #[test]
    fn of_steppers(problem in loaded(), (times, cuts) in asked(), turns in decades(-2.0, 0.5)) {
        let end = turns / speed(&problem);
        let times = scaled(&times, end);
        same(&times, &cuts, || Taylor::new(&problem, 1e-12).expect("covered"));
        same(&times, &cuts, || Dop853::new(&problem, 1e-9).expect("covered"));
        same(&times, &cuts, || fixed(&problem, FixedStepMethod::Rk4, 30.0, end));
        same(&times, &cuts, || fixed(&problem, FixedStepMethod::Gauss4, 30.0, end));
        same(&times, &cuts, || fixed(&problem, FixedStepMethod::Kicks4, 30.0, end));
    }

    #[test]
    fn samples_between_change_no_other(problem in loaded(), (times, _) in asked(), turns in decades(-2.0, 0.5)) {
        let times = scaled(&times, turns / speed(&problem));
        let few: Vec<f64> = times.iter().copied().step_by(3).collect();
        let pairs = [
            [run(Taylor::new(&problem, 1e-12).expect("covered"), &times), run(Taylor::new(&problem, 1e-12).expect("covered"), &few)],
            [run(Dop853::new(&problem, 1e-9).expect("covered"), &times), run(Dop853::new(&problem, 1e-9).expect("covered"), &few)],
        ];
        for [all, some] in pairs {
            for (all, some) in all.attitude.iter().zip(&some.attitude) {
                prop_assert_eq!(&all.iter().copied().step_by(3).collect::<Vec<_>>(), some);
            }
        }
    }
}
