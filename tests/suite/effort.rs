//! What runs cost, exactly: a change of cost is seen in review.

use nalgebra::Vector3;
use polhode::dynamics::{Problem, Torque, Window};
use polhode::propagation::{
    AxialTorque, BrakedRotation, Coverage, Dop853, Effort, FixedStep, FixedStepMethod, FreeRotation, LagrangeTop,
    Propagator, States, Taylor,
};

use crate::motions::{MOMENTS, RATES, every_torque, grid, problem};

/// Evaluations, steps and rejections of ten seconds with twenty samples.
fn effort(mut propagator: impl Propagator) -> [u64; 3] {
    propagator.fill(&grid(10.0, 20), &mut States::default()).expect("a finite motion");
    let Effort { evaluations, steps, rejections, .. } = propagator.effort();
    [evaluations, steps, rejections]
}

fn under(name: &str) -> Problem {
    let torques: Vec<Torque> =
        every_torque().into_iter().filter(|(kind, _)| *kind == name).map(|(_, torque)| torque).collect();
    problem(MOMENTS, RATES, &torques)
}

fn pulsed() -> Problem {
    let mut problem = under("constant body");
    problem.loads[0].window = Window { start: 2.3, end: 4.1 };
    problem
}

/// One evaluation a sample, and no step: in ten seconds or in thirty years, in one batch or in many.
#[test]
fn closed_forms_cost_their_samples() {
    let axial = problem(MOMENTS, [0.0, 0.0, 1.5], &[Torque::ConstantBody { moment: Vector3::new(0.0, 0.0, -0.4) }]);
    let weight = Torque::ForceWorld { force: Vector3::new(0.0, 0.0, -4.0), arm: Vector3::z() };
    let top = problem([2.0, 2.0, 1.0], RATES, &[weight]);
    let fresh = || -> [Box<dyn Propagator>; 4] {
        [
            Box::new(FreeRotation::new(&under("none")).expect("covered")),
            Box::new(BrakedRotation::new(&under("momentum brake")).expect("covered")),
            Box::new(AxialTorque::new(&axial).expect("covered")),
            Box::new(LagrangeTop::new(&top).expect("covered")),
        ]
    };
    for end in [10.0, 1e9] {
        for (mut at_once, mut in_batches) in fresh().into_iter().zip(fresh()) {
            let (times, mut states) = (grid(end, 20), States::default());
            assert_eq!(at_once.effort(), Effort::default(), "setting up evaluates nothing");
            at_once.fill(&times, &mut states).expect("a finite motion");
            times.chunks(8).for_each(|times| in_batches.fill(times, &mut states).expect("a finite motion"));
            for effort in [at_once.effort(), in_batches.effort()] {
                assert_eq!(effort, Effort { evaluations: 21, ..Effort::default() });
            }
        }
    }
}

#[test]
fn taylor_steps() {
    let steps = |problem: &Problem, tolerance: f64| {
        let [evaluations, steps, rejections] = effort(Taylor::new(problem, tolerance).expect("covered"));
        assert_eq!([evaluations, rejections], [steps, 0]);
        steps
    };
    let found = ["none", "constant body", "constant world", "linear damping", "force world", "gravity gradient"]
        .map(|name| (name, steps(&under(name), 1e-16), steps(&under(name), 1e-9)));
    let expected = [
        ("none", 18, 12),
        ("constant body", 21, 15),
        ("constant world", 17, 12),
        ("linear damping", 13, 9),
        ("force world", 22, 15),
        ("gravity gradient", 35, 24),
    ];
    assert_eq!(found, expected);
    assert_eq!(steps(&pulsed(), 1e-16), 18);
}

#[test]
fn rk4_evaluations_steps_rejections() {
    let of =
        |problem: &Problem, step: f64| effort(FixedStep::new(problem, FixedStepMethod::Rk4, step).expect("covered"));
    // 10 s in steps of 10 ms, four evaluations each.
    assert_eq!(of(&under("force world"), 0.01), [4000, 1000, 0]);
    // Half a second about each edge is cut in two, 0.3 + 0.2 and 0.1 + 0.4, still whole numbers of steps.
    assert_eq!(of(&pulsed(), 0.01), [4000, 1000, 0]);
    // No longer than asked for: half a second in steps of 0.3 is two.
    assert_eq!(of(&under("none"), 0.3), [160, 40, 0]);
}

/// Ten seconds in steps of 10 ms: evaluations a step are stages, kicks, or as many as the iteration takes.
#[test]
fn evaluations_of_methods_with_a_fixed_step() {
    let found = FixedStepMethod::ALL.map(|method| {
        let problem = under(if method.information().coverage == Coverage::TorqueFree { "none" } else { "force world" });
        let [evaluations, steps, rejections] = effort(FixedStep::new(&problem, method, 0.01).expect("covered"));
        assert_eq!([steps, rejections], [1000, 0]);
        (method.information().name, evaluations)
    });
    let expected = [
        ("euler_naive", 1000),
        ("euler_semi_implicit", 1000),
        ("rk4", 4000),
        ("rkmk4", 4000),
        ("splitting2", 2000),
        ("splitting4", 6000),
        ("splitting6", 10000),
        ("splitting8", 18000),
        ("dmv2", 1000),
        ("dmv4", 1000),
        ("dmv6", 1000),
        ("dmv8", 1000),
        ("gauss4", 15322),
        ("gauss6", 21922),
        ("kicks2", 2000),
        ("kicks4", 6000),
    ];
    assert_eq!(found, expected);
}

#[test]
fn dop853_evaluations_steps_rejections() {
    let of = |problem: &Problem, tolerance: f64| effort(Dop853::new(problem, tolerance).expect("covered"));
    let found = [of(&under("force world"), 1e-6), of(&under("force world"), 1e-12), of(&pulsed(), 1e-9)];
    assert_eq!(found, [[237, 13, 4], [865, 67, 0], [380, 26, 1]]);
}
