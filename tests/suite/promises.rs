//! `tolerance_rad` is kept over the whole run, at a cost near the least that keeps it.

use polhode::dynamics::{Load, Problem, Window};
use polhode::propagation::{Effort, PreciseTaylor, States, attitude_distance};
use polhode::scenario::{Grid, Method, Path, PlannedBody};

use crate::motions::{MOMENTS, RATES, every_torque, problem};
use crate::planned;

const PROMISES: [f64; 5] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-12];
/// A choice takes at most so many percent of the evaluations of the loosest setting of its method that keeps the promise.
const WASTE_PERCENT: u64 = 160;

fn body(problem: Problem) -> PlannedBody {
    let mut body = planned::single(1).bodies.swap_remove(0);
    body.problem = problem;
    body
}

fn grid(end: f64) -> Grid {
    Grid::Uniform { every_s: end / 100.0, count: 101 }
}

/// Attitudes right to rounding.
fn exact(problem: &Problem, grid: &Grid) -> States {
    let mut precise = PreciseTaylor::new(problem).expect("covered");
    let mut states = States::default();
    states.reset(101, true, false);
    for row in 0..states.len() {
        let state = precise.at(grid.time(row as u64)).expect("a finite motion").expect("no limit of steps");
        for (column, value) in states.attitude.iter_mut().zip(state.attitude) {
            column[row] = value.hi();
        }
    }
    states
}

/// How far a path is off, rad, and what it does.
fn run(body: &PlannedBody, grid: &Grid, exact: &States) -> (f64, Effort) {
    let (mut states, mut times) = (States::default(), Vec::new());
    grid.fill(0, usize::MAX, &mut times);
    let mut propagator = body.propagator().expect("covered");
    propagator.fill(&times, &mut states).expect("a finite motion");
    (attitude_distance(exact, &states), propagator.effort())
}

/// Under each kind of torque, short and long, tumbling, near the middle axis, and with a window.
fn problems() -> Vec<(String, Problem, f64)> {
    let mut problems = Vec::new();
    // Of those that act alike all the time.
    let steady = every_torque().into_iter().filter(|(_, torque)| torque.profile().is_none());
    for ((name, torque), end) in steady.zip([7.0, 9.0, 11.0, 13.0, 15.0, 17.0, 19.0, 21.0]) {
        let near = [1e-3, 2.0, -7e-4];
        let pulse = Window { start: 1.37, end: 5.91 };
        let cases = [("tumbling", RATES, 60.0, Window::ALWAYS), ("near the middle axis", near, 14.0, Window::ALWAYS)];
        let pulsed = ("pulsed", RATES, end, pulse);
        for (motion, rates, end, window) in cases.into_iter().chain([pulsed]) {
            let mut problem = problem(MOMENTS, rates, &[]);
            problem.loads = vec![Load { torque: torque.clone(), window }];
            problems.push((format!("{name}, {motion}, {end} s"), problem, end));
        }
    }
    problems
}

#[test]
fn promises_are_kept_at_a_cost_near_the_least() {
    let (mut kept, mut refused) = (0, 0);
    for (name, problem, end) in problems() {
        let (body, grid) = (body(problem.clone()), grid(end));
        let exact = exact(&problem, &grid);
        for promise in PROMISES {
            for method in [Method::Auto, Method::Dop853] {
                let Ok(chosen) = body.clone().keeping(method, promise, &grid) else {
                    refused += 1;
                    continue;
                };
                let (error, effort) = run(&chosen, &grid, &exact);
                if chosen.reason.contains("does not keep") {
                    refused += 1;
                    continue;
                }
                kept += 1;
                assert!(error <= promise, "{name}: {error:e} rad for {promise:e}: {}", chosen.reason);
                let evaluations = |method: Method, tolerance: f64| {
                    let other = body.clone().by(method, Some(tolerance)).expect("covered");
                    let (error, effort) = run(&other, &grid, &exact);
                    (error <= promise).then_some(effort.evaluations)
                };
                let method = match chosen.path {
                    Path::Taylor { .. } => Method::Taylor,
                    Path::Dop853 { .. } => Method::Dop853,
                    // A closed form has no setting that could be cheaper.
                    _ => continue,
                };
                let settings = (2..=26).map(|half| 10_f64.powf(-0.5 * f64::from(half)));
                let least = settings.into_iter().find_map(|tolerance| evaluations(method, tolerance));
                let (found, least) = (effort.evaluations, least.unwrap_or(effort.evaluations));
                let reason = &chosen.reason;
                assert!(100 * found <= WASTE_PERCENT * least, "{name}: {found} for {least} evaluations: {reason}");
            }
        }
    }
    println!("{kept} promises kept, {refused} refused");
    assert!(kept > 6 * refused, "refusals are for what f64 cannot do: {refused} beside {kept}");
}

#[test]
fn what_f64_cannot_keep_is_refused_and_a_stepper_that_was_asked_for_says_so() {
    let (_, torque) = every_torque().swap_remove(0);
    let body = body(problem(MOMENTS, [1e-3, 2.0, -7e-4], &[torque]));
    let grid = grid(200.0);
    let message = body.clone().keeping(Method::Auto, 3e-15, &grid).expect_err("beyond f64").to_string();
    assert!(
        message.contains("3e-15 rad is more than f64 can promise") && message.contains("to about t = "),
        "{message}"
    );
    let reason = body.keeping(Method::Taylor, 3e-15, &grid).expect("a yardstick").reason;
    assert!(reason.contains("does not keep 3e-15 rad"), "{reason}");
}

#[test]
fn a_run_too_long_to_be_tried_says_how_far_it_was() {
    let (_, torque) = every_torque().swap_remove(0);
    let body = body(problem(MOMENTS, RATES, &[torque]));
    let long = Grid::Uniform { every_s: 1e5, count: 10_001 };
    let reason = body.keeping(Method::Taylor, 1e-3, &long).expect("a yardstick").reason;
    println!("{reason}");
    assert!(reason.contains("tried to t = "), "{reason}");
}

/// A brick that bounces on a cord and does not turn keeps any promise of its attitude; its way must come out as well.
#[cfg(feature = "serde")]
#[test]
fn the_way_of_a_body_that_does_not_turn_is_kept_too() {
    use polhode::scenario::{Plan, Scenario, library};
    let text = library::text("tether").expect("a scene");
    let scenario = Scenario::parse(text, "tether", &["tolerance_rad=1e-6".to_owned()]).expect("a scene");
    let plan = Plan::new(&scenario).expect("a plan");
    let mut states = States::default();
    plan.bodies[0].propagator().expect("covered").fill(&[6.0], &mut states).expect("a finite motion");
    let due = -0.5405 - 0.2595 * (20.0_f64.sqrt() * 6.0).cos();
    assert!((states.position[2][0] - due).abs() < 1e-5, "{} m, due {due} m", states.position[2][0]);
}

/// Near what f64 can promise of a fall that magnifies roundings, a promise is refused, or it is kept.
#[cfg(feature = "serde")]
#[test]
fn what_a_tape_rounds_is_not_promised_away() {
    use polhode::scenario::{Plan, Scenario, library};
    let text = library::text("explorer_1").expect("a scene");
    let mut kept = 0;
    for promise in ["1e-11", "2e-11", "3e-11", "5e-11", "1e-10"] {
        let scenario = Scenario::parse(text, "explorer_1", &[format!("tolerance_rad={promise}")]).expect("a scene");
        let Ok(plan) = Plan::new(&scenario) else { continue };
        let body = &plan.bodies[0];
        let exact = exact(&body.problem, &grid(120.0));
        let (error, _) = run(body, &grid(120.0), &exact);
        let promise: f64 = promise.parse().expect("a number");
        assert!(error <= promise, "{error:e} rad, promised {promise:e}");
        kept += 1;
    }
    assert!(kept >= 1, "1e-10 is within reach");
}
