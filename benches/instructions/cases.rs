//! What is counted.

use std::hint::black_box;
use std::process::ExitCode;

use nalgebra::{UnitQuaternion, Vector3};
use polhode::dynamics::Problem;
use polhode::propagation::{Dop853, FreeRotation, LagrangeTop, Propagator, States, Taylor};
use polhode::telemetry::{BodySamples, Channel, Derivation};

use super::problems::{MOMENTS, RATES, free, pushed, times};
use super::top::top;

/// Something that can be done any number of times.
pub struct Case {
    pub name: &'static str,
    /// How often makes a count that start-up does not disturb.
    pub count: u32,
    work: fn(u32),
}

pub const ALL: &[Case] = &[
    Case { name: "torque-free, set-up", count: 100, work: |count| set_up(count, || FreeRotation::new(&body())) },
    Case { name: "torque-free, sample", count: 8192, work: |count| fill(FreeRotation::new(&body()), &times(count)) },
    Case { name: "Lagrange top, set-up", count: 100, work: |count| set_up(count, || LagrangeTop::new(&top())) },
    Case { name: "Lagrange top, sample", count: 8192, work: |count| fill(LagrangeTop::new(&top()), &times(count)) },
    Case {
        name: "Taylor, second of motion",
        count: 100,
        work: |count| fill(Taylor::new(&pushed(), 1e-16), &[f64::from(count)]),
    },
    Case {
        name: "DOP853, second of motion",
        count: 100,
        work: |count| fill(Dop853::new(&pushed(), 1e-12), &[f64::from(count)]),
    },
    Case { name: "six channels, turned, sample", count: 2048, work: derive },
    #[cfg(feature = "cli")]
    Case { name: "mcap, sample", count: 1024, work: |count| recording::record(count, "mcap") },
    #[cfg(feature = "cli")]
    Case { name: "rrd, sample", count: 1024, work: |count| recording::record(count, "rrd") },
];

/// Runs one case.
pub fn run(name: &str, count: u32) -> ExitCode {
    let Some(case) = ALL.iter().find(|case| case.name == name) else { return ExitCode::FAILURE };
    (case.work)(count);
    ExitCode::SUCCESS
}

fn body() -> Problem {
    free(MOMENTS, RATES)
}

fn set_up<T, E>(count: u32, new: impl Fn() -> Result<T, E>) {
    for _ in 0..count {
        assert!(black_box(new()).is_ok());
    }
}

fn fill<P: Propagator, E: std::fmt::Debug>(propagator: Result<P, E>, times: &[f64]) {
    let (mut propagator, mut states) = (propagator.expect("it is covered"), States::default());
    // As runs do it: batches that stay in the cache.
    for times in times.chunks(1024) {
        propagator.fill(times, &mut states).expect("a finite motion");
        black_box(&states);
    }
}

fn derive(count: u32) {
    let channels = [
        Channel::Attitude,
        Channel::AngularVelocity,
        Channel::AngularMomentumWorld,
        Channel::RotationalEnergy,
        Channel::EnergyDrift,
        Channel::MomentumDrift,
    ];
    let (problem, times) = (body(), times(1024));
    let (mut states, mut samples) = (States::default(), BodySamples::new(&channels));
    FreeRotation::new(&problem).expect("it is free").fill(&times, &mut states).expect("a finite motion");
    let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.3, 0.2, 0.1));
    let derivation = Derivation::new(&problem, turn);
    for _ in 0..count / 1024 {
        derivation.derive(&times, &states, &mut samples);
        black_box(&samples);
    }
}

#[cfg(feature = "cli")]
mod recording {
    use polhode::recording::Recorder;
    use polhode::scenario::{Plan, Scenario};

    /// A run of so many samples, propagated and recorded.
    pub fn record(count: u32, extension: &str) {
        let assignments = [format!("duration_s={}", 0.01 * f64::from(count)), "sample_every_s=0.01".to_owned()];
        let scene = Scenario::named("dzhanibekov", &assignments).expect("it comes with the program");
        let plan = Plan::new(&scene).expect("it plans");
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join(format!("run.{extension}"));
        let mut recorder = Recorder::create(&plan, &[path], false).expect("a recorder");
        let mut run = plan.start().expect("it starts");
        while let Some(samples) = run.next_batch().expect("it runs") {
            recorder.write(samples).expect("it is written");
        }
        recorder.finish().expect("it is whole");
    }
}
