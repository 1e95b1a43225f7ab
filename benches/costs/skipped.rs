//! What a plan leaves out, each with and without: the ratios stand in `docs/performance.md`.

use divan::Bencher;
use divan::counter::ItemsCount;
use nalgebra::{UnitQuaternion, Vector3};
use polhode::propagation::{FreeRotation, Propagator, States, Taylor};
use polhode::telemetry::{BodySamples, Channel, Derivation};

use super::motions::{COUNT, fill, problem, times, with_torque};

const MOMENTS: [f64; 3] = [1.0, 2.0, 3.0];
const RATES: [f64; 3] = [1.0, 2.0, 1.5];

#[divan::bench(args = [false, true])]
fn attitude(bencher: Bencher, with: bool) {
    let mut problem = problem(MOMENTS, RATES);
    problem.wants_attitude = with;
    fill(bencher, &problem);
}

#[divan::bench(args = [false, true])]
fn translation(bencher: Bencher, with: bool) {
    let mut problem = with_torque(problem(MOMENTS, RATES));
    problem.wants_translation = with;
    run_taylor(bencher, &problem);
}

#[divan::bench(args = [false, true])]
fn torque(bencher: Bencher, with: bool) {
    let free = problem(MOMENTS, RATES);
    run_taylor(bencher, &if with { with_torque(free) } else { free });
}

fn run_taylor(bencher: Bencher, problem: &polhode::dynamics::Problem) {
    let (times, mut states) = (times(), States::default());
    bencher.counter(ItemsCount::new(COUNT)).bench_local(|| {
        let mut taylor = Taylor::new(problem, 1e-16).expect("it is covered");
        taylor.fill(&times, &mut states)
    });
}

#[divan::bench(args = [false, true])]
fn turning_back(bencher: Bencher, with: bool) {
    let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.3, 0.2, 0.1));
    let turn = if with { turn } else { UnitQuaternion::identity() };
    derive(bencher, turn, &[Channel::Attitude, Channel::AngularVelocity]);
}

#[divan::bench(args = [1, 2, 4, 6])]
fn channels(bencher: Bencher, count: usize) {
    let all = [
        Channel::Attitude,
        Channel::AngularVelocity,
        Channel::AngularMomentumWorld,
        Channel::RotationalEnergy,
        Channel::EnergyDrift,
        Channel::MomentumDrift,
    ];
    derive(bencher, UnitQuaternion::identity(), &all[..count]);
}

fn derive(bencher: Bencher, turn: UnitQuaternion<f64>, channels: &[Channel]) {
    let problem = problem(MOMENTS, RATES);
    let (times, mut states, mut samples) = (times(), States::default(), BodySamples::new(channels));
    FreeRotation::new(&problem).expect("it is free").fill(&times, &mut states).expect("it runs");
    let derivation = Derivation::new(&problem, turn);
    bencher.counter(ItemsCount::new(COUNT)).bench_local(|| derivation.derive(&times, &states, &mut samples));
}
