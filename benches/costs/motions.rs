//! Set-up and samples of each path.

use divan::Bencher;
use divan::counter::ItemsCount;
use polhode::dynamics::Problem;
use polhode::propagation::{FreeRotation, LagrangeTop, Propagator, States, Taylor};

use super::problems::{free, pushed, times};
use super::top::top;

/// Samples in a batch.
const COUNT: u32 = 4096;

/// One per branch of the closed form.
const BRANCHES: [(&str, [f64; 3], [f64; 3]); 6] = [
    ("tri-axial", [1.0, 2.0, 3.0], [1.0, 2.0, 1.5]),
    ("near separatrix", [1.0, 2.0, 3.0], [1e-3, 5.0, 1e-3]),
    ("separatrix", [3.0, 4.0, 6.0], [2.0, 1.0, 1.0]),
    ("symmetric", [1.0, 1.0, 1.5], [1.0, 2.0, 1.5]),
    ("spherical", [2.0, 2.0, 2.0], [1.0, 2.0, 1.5]),
    ("principal axis", [1.0, 2.0, 3.0], [0.0, 0.0, 5.0]),
];

fn branch(name: &str) -> Problem {
    let (_, moments, rates) = BRANCHES.into_iter().find(|branch| branch.0 == name).expect("a branch of that name");
    free(moments, rates)
}

#[divan::bench(args = BRANCHES.map(|branch| branch.0))]
fn closed_form_set_up(bencher: Bencher, name: &str) {
    let problem = branch(name);
    bencher.bench_local(|| FreeRotation::new(&problem));
}

#[divan::bench(args = BRANCHES.map(|branch| branch.0))]
fn closed_form_rates(bencher: Bencher, name: &str) {
    let mut problem = branch(name);
    problem.wants_attitude = false;
    fill(bencher, &problem);
}

#[divan::bench(args = BRANCHES.map(|branch| branch.0))]
fn closed_form_rates_and_attitude(bencher: Bencher, name: &str) {
    fill(bencher, &branch(name));
}

/// A propagator does not go back in time: each round takes a fresh one, made outside what is timed.
fn fill(bencher: Bencher, problem: &Problem) {
    let (times, mut states) = (times(COUNT), States::default());
    let fresh = || FreeRotation::new(problem).expect("it is free");
    let run = |mut rotation: FreeRotation| rotation.fill(&times, &mut states).expect("times ascend");
    bencher.counter(ItemsCount::new(COUNT)).with_inputs(fresh).bench_local_values(run);
}

#[divan::bench]
fn top_set_up(bencher: Bencher) {
    let problem = top();
    bencher.bench_local(|| LagrangeTop::new(&problem));
}

#[divan::bench]
fn top_rates_and_attitude(bencher: Bencher) {
    let (problem, times, mut states) = (top(), times(COUNT), States::default());
    let fresh = || LagrangeTop::new(&problem).expect("it is a top");
    let run = |mut top: LagrangeTop| top.fill(&times, &mut states).expect("times ascend");
    bencher.counter(ItemsCount::new(COUNT)).with_inputs(fresh).bench_local_values(run);
}

/// A hundred seconds with one output: steps, and next to nothing else. 5e-11 gives order 20, 1e-16 order 24.
#[divan::bench(args = [5e-11, 1e-16])]
fn taylor_steps(bencher: Bencher, tolerance: f64) {
    let problem = pushed();
    let mut states = States::default();
    let mut run = || {
        let mut taylor = Taylor::new(&problem, tolerance).expect("it is covered");
        taylor.fill(&[100.0], &mut states).expect("it runs");
        taylor.effort().steps
    };
    let steps = run();
    bencher.counter(ItemsCount::new(steps)).bench_local(run);
}
