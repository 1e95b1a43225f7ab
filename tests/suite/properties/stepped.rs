//! Motions under loads, by steps: laws of momentum, and what does not depend on how it is asked.

use polhode::body::{Attitude, State};
use polhode::dynamics::{Load, Problem, Torque, Window};
use polhode::propagation::{Effort, Propagator, Taylor};
use proptest::prelude::*;

use super::cases;
use super::motions::{Apart, at, from, momentum, precise, sensitivity, speed};
use super::starts::{attitude, decades, problem, rates, vector};

/// What acts, in units of the body's own: its largest moment times its spin squared.
fn torque() -> impl Strategy<Value = Torque> {
    prop_oneof![
        vector(-6.0, 1.0).prop_map(|moment| Torque::ConstantBody { moment }),
        vector(-6.0, 1.0).prop_map(|moment| Torque::ConstantWorld { moment }),
        decades(-6.0, 0.0).prop_map(|coefficient| Torque::LinearDamping { coefficient }),
        decades(-6.0, 0.0).prop_map(|rate| Torque::MomentumBrake { rate }),
        (vector(-3.0, 0.5), vector(-3.0, 0.5)).prop_map(|(force, arm)| Torque::ForceBody { force, arm }),
        (vector(-3.0, 0.5), vector(-3.0, 0.5)).prop_map(|(force, arm)| Torque::ForceWorld { force, arm }),
        (vector(-3.0, 0.5), vector(-3.0, 0.5)).prop_map(|(dipole, field)| Torque::MagneticDipole { dipole, field }),
        decades(-3.0, 0.0).prop_map(|mean_motion| Torque::GravityGradient { mean_motion }),
    ]
}

/// In turns of the body.
fn window() -> impl Strategy<Value = Window> {
    let edge = || decades(-3.0, 1.0);
    prop_oneof![
        Just(Window::ALWAYS),
        (edge(), edge()).prop_map(|(start, length)| Window { start, end: start + length }),
        edge().prop_map(|end| Window { start: 0.0, end }),
    ]
}

/// A body of any size under one to three loads, of which at most one is a gravity gradient, that act at any time.
pub fn loaded() -> impl Strategy<Value = Problem> {
    let shape = [decades(-3.0, 0.0), decades(-3.0, 0.0), decades(-3.0, 0.0)];
    let loads = prop::collection::vec((torque(), window()), 1..4);
    (shape, decades(-9.0, 9.0), rates(), attitude(), loads).prop_map(|([a, b, c], size, rates, attitude, loads)| {
        let moments = [b + c, a + c, a + b].map(|moment| moment * size);
        let body = problem(moments, rates, attitude);
        let spin = speed(&body);
        let mut orbits = 0;
        let loads = loads.into_iter().map(|(torque, window)| {
            let moment_unit = body.moments.vector().min() * spin * spin;
            let torque = match torque {
                Torque::ConstantBody { moment } => Torque::ConstantBody { moment: moment * moment_unit },
                Torque::ConstantWorld { moment } => Torque::ConstantWorld { moment: moment * moment_unit },
                Torque::LinearDamping { coefficient } => {
                    Torque::LinearDamping { coefficient: coefficient * body.moments.vector().min() * spin }
                }
                Torque::MomentumBrake { rate } => Torque::MomentumBrake { rate: rate * spin },
                Torque::ForceBody { force, arm } => Torque::ForceBody { force: force * moment_unit, arm },
                Torque::ForceWorld { force, arm } => Torque::ForceWorld { force: force * moment_unit, arm },
                other @ (Torque::ProfileBody { .. }
                | Torque::ProfileWorld { .. }
                | Torque::ForceProfileBody { .. }
                | Torque::ForceProfileWorld { .. }
                | Torque::Rotor { .. }) => other,
                Torque::MagneticDipole { dipole, field } => {
                    Torque::MagneticDipole { dipole: dipole * moment_unit, field }
                }
                Torque::GravityGradient { mean_motion } => Torque::GravityGradient { mean_motion: mean_motion * spin },
                Torque::General(_) => unreachable!("none is drawn"),
            };
            Load { torque, window: Window { start: window.start / spin, end: window.end / spin } }
        });
        let loads: Vec<Load> = loads
            .filter(|load| {
                orbits += u32::from(matches!(load.torque, Torque::GravityGradient { .. }));
                orbits < 2 || !matches!(load.torque, Torque::GravityGradient { .. })
            })
            .collect();
        Problem { loads, ..body }
    })
}

fn taylor(problem: &Problem) -> Taylor {
    Taylor::new(problem, 1e-16).expect("covered")
}

proptest! {
    #![proptest_config(cases(96))]

    #[test]
    fn taylor_series_move_as_in_double_double(problem in loaded(), turns in decades(-2.0, 1.0)) {
        let time = turns / speed(&problem);
        if let Some(exact) = precise(&problem, time) {
            let found = Apart::of(&at(taylor(&problem), time), &exact);
            let limit = sensitivity(&problem, |start| at(taylor(start), time));
            prop_assert!(found.angle <= 8.0 * limit.angle + 4e-15, "{found:?} {limit:?}");
            prop_assert!(found.rate <= 8.0 * limit.rate + 4e-15 * exact.angular_velocity.in_body().norm(), "{found:?} {limit:?}");
        }
    }

    #[test]
    fn world_moments_add_up_while_they_act(
        mut problem in loaded(), pushes in prop::collection::vec((vector(-6.0, 1.0), window()), 1..4), turns in decades(-2.0, 1.0),
    ) {
        let spin = speed(&problem);
        let (time, unit) = (turns / spin, problem.moments.vector().min() * spin * spin);
        problem.loads = pushes
            .into_iter()
            .map(|(moment, window)| Load {
                torque: Torque::ConstantWorld { moment: moment * unit },
                window: Window { start: window.start / spin, end: window.end / spin },
            })
            .collect();
        let mut expected = momentum(&problem, &problem.initial);
        let mut scale = problem.moments.vector().max() * spin;
        for load in &problem.loads {
            let Torque::ConstantWorld { moment } = load.torque else { unreachable!("as made") };
            let acted = load.window.end.min(time) - load.window.start.max(0.0);
            expected += moment * acted.max(0.0);
            scale += moment.norm() * acted.max(0.0) * problem.moments.vector().max() / problem.moments.vector().min();
        }
        let mut motion = taylor(&problem);
        let mut states = polhode::propagation::States::default();
        motion.fill(&[time], &mut states).expect("finite");
        let Effort { steps, .. } = motion.effort();
        let found = momentum(&problem, &crate::motions::state(&states, 0));
        // Sums are compensated: a rounding of the state, and one of the moment's direction now and then.
        let room = 4e-15 * (1.0 + f64::from(u32::try_from(steps).expect("few steps")).sqrt());
        prop_assert!((found - expected).norm() <= room * scale, "{:e}", (found - expected).norm() / scale);
    }

    #[test]
    fn a_turned_world_with_its_loads_turns_the_attitude_alone(problem in loaded(), turn in attitude(), turns in decades(-2.0, 0.5)) {
        let time = turns / speed(&problem);
        let has_orbit = problem.loads.iter().any(|load| matches!(load.torque, Torque::GravityGradient { .. }));
        prop_assume!(!has_orbit);
        let start = State {
            attitude: Attitude::from_world_from_body(turn * problem.initial.attitude.world_from_body()), ..problem.initial
        };
        let mut turned = from(&problem, start);
        for load in &mut turned.loads {
            match &mut load.torque {
                Torque::ConstantWorld { moment } => *moment = turn * *moment,
                Torque::ForceWorld { force: vector, .. } | Torque::MagneticDipole { field: vector, .. } => {
                    *vector = turn * *vector;
                }
                _ => {}
            }
        }
        let (plain, found) = (at(taylor(&problem), time), at(taylor(&turned), time));
        let expected = State { attitude: Attitude::from_world_from_body(turn * plain.attitude.world_from_body()), ..plain };
        let (found, limit) = (Apart::of(&expected, &found), sensitivity(&problem, |start| at(taylor(start), time)));
        prop_assert!(found.angle <= 8.0 * limit.angle + 8e-15, "{found:?} {limit:?}");
        prop_assert!(found.rate <= 8.0 * limit.rate + 8e-15 * plain.angular_velocity.in_body().norm(), "{found:?} {limit:?}");
    }

    #[test]
    fn a_later_start_goes_on_the_same_way(problem in loaded(), first in decades(-2.0, 0.5), more in decades(-2.0, 0.5)) {
        let [first, more] = [first, more].map(|turns| turns / speed(&problem));
        let has_orbit = problem.loads.iter().any(|load| matches!(load.torque, Torque::GravityGradient { .. }));
        prop_assume!(!has_orbit);
        let mut later = from(&problem, at(taylor(&problem), first));
        later.loads.retain(|load| load.window.end > first);
        for load in &mut later.loads {
            load.window = Window { start: load.window.start - first, end: load.window.end - first };
        }
        let through = at(taylor(&problem), first + more);
        let (found, limit) =
            (Apart::of(&through, &at(taylor(&later), more)), sensitivity(&later, |start| at(taylor(start), more)));
        let spin = through.angular_velocity.in_body().norm().max(later.initial.angular_velocity.in_body().norm());
        let room = 8e-15 + f64::EPSILON * (first + more) * spin;
        prop_assert!(found.angle <= 8.0 * limit.angle + room, "{found:?} {limit:?}");
        prop_assert!(found.rate <= 8.0 * limit.rate + room * spin, "{found:?} {limit:?}");
    }
}
