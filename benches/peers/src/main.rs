//! polhode beside other people's integrators: error against CPU time, in one process, on one thread.
//!
//! `cargo run --release` in this folder prints a Markdown table.

mod cases;
mod peer;

use std::error::Error;
use std::time::Duration;

use cases::Case;
use polhode::propagation::States;
use polhode::scenario::{PlannedBody, Setting};
use polhode::propagation::attitude_distance;
use polhode::study::{Reference, Request, interleaved, reference_states, work_precision};

const ERRORS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];
/// What each pair of runs may take to be timed, s.
const BUDGET_S: f64 = 1.0;

fn main() -> Result<(), Box<dyn Error>> {
    println!("| case | error ≤ | polhode | its error | its time | ode_solvers Dop853, its error | its time | ratio |");
    println!("|---|---|---|---|---|---|---|---|");
    for case in cases::all() {
        compare(&case)?;
    }
    Ok(())
}

/// A row for each error: the cheapest setting of each side, both timed in turn.
fn compare(case: &Case) -> Result<(), Box<dyn Error>> {
    let (body, times) = (case.body()?, case.times());
    let reference = reference_states(&body, &times)?;
    let request = Request {
        methods: vec![polhode::scenario::Method::Auto],
        errors_rad: ERRORS.to_vec(),
        budget_s: 0.0,
        clock: cpu_clock,
        ..Request::default()
    };
    let study = work_precision(&body, case.end_s, &request)?;
    let tolerances: Vec<f64> = (6..=30).map(|half| 10_f64.powf(-f64::from(half) / 2.0)).collect();
    let errors: Vec<f64> =
        tolerances.iter().map(|tolerance| peer_error(case, &times, &reference, *tolerance)).collect();
    for (error, level) in study.levels.iter().filter(|level| level.is_auto).map(|level| (&level.error_rad, level)) {
        let point = level.point.map(|index| &study.points[index]);
        let ours = point.map(|point| body.clone().by(point.method, point.value)).transpose()?;
        let theirs = errors.iter().position(|found| found <= error);
        let mut works: Vec<Box<dyn FnMut()>> = Vec::new();
        works.extend(ours.map(|body| Box::new(our_run(body, &times)) as Box<dyn FnMut()>));
        works.extend(theirs.map(|index| Box::new(their_run(case, &times, tolerances[index])) as Box<dyn FnMut()>));
        let mut medians = interleaved(&mut works, cpu_clock, BUDGET_S).into_iter().map(|spread| spread.median_s);
        let our_time = point.and_then(|_| medians.next());
        let their_time = theirs.and_then(|_| medians.next());
        let ratio = our_time.zip(their_time).map_or("–".into(), |(ours, theirs)| format!("{:.3}", theirs / ours));
        let our_error = point.map_or("–".into(), |point| resolved(point.error_rad, &reference));
        let their_error = theirs.map_or("not reached".into(), |index| resolved(errors[index], &reference));
        let name = point.map_or("not reached", |point| point.method.key());
        debug_assert!(point.is_none_or(|point| point.method.setting() != Setting::Step));
        let (our_time, their_time) = (microseconds(our_time), microseconds(their_time));
        println!(
            "| {} | {error:.0e} | {name} | {our_error} | {our_time} | {their_error} | {their_time} | {ratio} |",
            case.name
        );
    }
    Ok(())
}

fn our_run(body: PlannedBody, times: &[f64]) -> impl FnMut() {
    let mut states = States::default();
    move || {
        let done = body.propagator().and_then(|mut propagator| propagator.fill(times, &mut states));
        done.expect("it ran before");
        std::hint::black_box(&states);
    }
}

fn their_run(case: &Case, times: &[f64], tolerance: f64) -> impl FnMut() {
    move || {
        std::hint::black_box(peer::dop853(case, times, tolerance));
    }
}

/// Infinite where the peer gives up.
fn peer_error(case: &Case, times: &[f64], reference: &Reference, tolerance: f64) -> f64 {
    peer::dop853(case, times, tolerance).map_or(f64::INFINITY, |states| attitude_distance(&reference.states, &states))
}

fn resolved(error: f64, reference: &Reference) -> String {
    let doubt = reference.doubt_rad;
    if error <= doubt { format!("< {doubt:.0e}") } else { format!("{error:.1e}") }
}

fn microseconds(time: Option<f64>) -> String {
    time.map_or("–".into(), |time| format!("{:.1} µs", time * 1e6))
}

/// Processor time of this thread: what else runs on the machine does not count.
fn cpu_clock() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
}
