use std::error::Error;
use std::hint::black_box;
use std::time::Duration;

use polhode::propagation::{States, attitude_distance};
use polhode::scenario::{Method, PlannedBody};
use polhode::study::{Reference, Request, interleaved, reference_states, work_precision};

use crate::cases::Case;
use crate::peer::Peer;

/// What is asked for, rad.
pub const ERRORS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];
/// What the runs of one error may take to be timed, s.
const BUDGET_S: f64 = 2.0;

/// One error that was asked for, and what each side needs for it.
pub struct Row {
    pub error_rad: f64,
    pub ours: Option<Reached>,
    /// A peer each, in order.
    pub theirs: Vec<Reached>,
}

/// The cheapest run of one side that reaches an error, or its best one.
pub struct Reached {
    pub way: String,
    pub error_rad: f64,
    /// `None` where the error that was asked for is not reached.
    pub time_s: Option<f64>,
}

/// What one peer's setting leads to.
struct Tried {
    setting: f64,
    error_rad: f64,
}

/// A row for each error: the loosest setting of each side, all timed in turn; and what the reference resolves, rad.
pub fn compare(case: &Case, peers: &[Box<dyn Peer>]) -> Result<(Vec<Row>, f64), Box<dyn Error>> {
    let (body, times) = (case.body()?, case.times());
    let reference = reference_states(&body, &times)?;
    let request = Request {
        methods: vec![Method::Auto],
        errors_rad: ERRORS.to_vec(),
        budget_s: 0.0,
        clock: cpu_clock,
        ..Request::default()
    };
    let study = work_precision(&body, case.end_s, &request)?;
    let tried: Vec<Vec<Tried>> = peers.iter().map(|peer| tries(peer.as_ref(), case, &reference)).collect();
    let mut rows = Vec::new();
    for error_rad in ERRORS {
        // Where nothing can be promised, what was tried may still be right.
        let of_error = study.levels.iter().filter(|level| level.error_rad == error_rad);
        let level = of_error.max_by_key(|level| level.is_auto);
        let point = level.and_then(|level| level.point).map(|index| &study.points[index]);
        let ours = point.map(|point| body.clone().by(point.method, point.value)).transpose()?;
        let cheapest = |tried: &Vec<Tried>| tried.iter().position(|tried| tried.error_rad <= error_rad);
        let found: Vec<Option<usize>> = tried.iter().map(cheapest).collect();
        let mut works: Vec<Box<dyn FnMut()>> = Vec::new();
        works.extend(ours.map(|body| Box::new(our_run(body, &times)) as Box<dyn FnMut()>));
        for ((peer, tried), found) in peers.iter().zip(&tried).zip(&found) {
            let Some(index) = *found else { continue };
            works.push(Box::new(move || drop(black_box(peer.states(case, tried[index].setting)))));
        }
        let mut times_s = interleaved(&mut works, cpu_clock, BUDGET_S).into_iter().map(|spread| spread.median_s);
        let ours = point.map(|point| Reached {
            way: point.method.key().into(),
            error_rad: point.error_rad,
            time_s: times_s.next(),
        });
        let theirs = peers.iter().zip(&tried).zip(&found).map(|((peer, tried), found)| match found {
            Some(index) => Reached { way: peer.way(), error_rad: tried[*index].error_rad, time_s: times_s.next() },
            None => Reached { way: peer.way(), error_rad: best(tried), time_s: None },
        });
        rows.push(Row { error_rad, ours, theirs: theirs.collect() });
    }
    Ok((rows, reference.doubt_rad))
}

/// From loose to tight, until the tightest error is reached.
fn tries(peer: &dyn Peer, case: &Case, reference: &Reference) -> Vec<Tried> {
    let mut tried = Vec::new();
    for setting in peer.settings(case) {
        let states = peer.states(case, setting);
        let error_rad = states.map_or(f64::INFINITY, |states| attitude_distance(&reference.states, &states));
        tried.push(Tried { setting, error_rad });
        if ERRORS.iter().all(|error| error_rad <= *error) {
            break;
        }
    }
    tried
}

fn best(tried: &[Tried]) -> f64 {
    tried.iter().map(|tried| tried.error_rad).fold(f64::INFINITY, f64::min)
}

fn our_run(body: PlannedBody, times: &[f64]) -> impl FnMut() {
    let mut states = States::default();
    move || {
        let done = body.propagator().and_then(|mut propagator| propagator.fill(times, &mut states));
        done.expect("it ran before");
        black_box(&states);
    }
}

/// Processor time of this thread: what else runs on the machine does not count.
fn cpu_clock() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
}
