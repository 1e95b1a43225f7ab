//! Work-precision studies: errors are reached, repeatable, and never claimed below what the reference resolves.

use polhode::scenario::{BodySpec, Method, MomentSpec, Plan, PlannedBody, Scenario, TorqueSpecs};
use polhode::study::{Request, WorkPrecision, work_precision};

const END_S: f64 = 5.0;
const ERRORS: [f64; 3] = [1e-3, 1e-6, 1e-9];

fn body(torque: TorqueSpecs) -> PlannedBody {
    let spec = BodySpec {
        principal_moments_kg_m2: Some([1.0, 2.0, 2.5]),
        angular_velocity_rad_s: Some([0.3, 2.0, -0.4]),
        torque,
        ..BodySpec::default()
    };
    let scene =
        Scenario { duration_s: Some(END_S), sample_every_s: Some(0.1), body: vec![spec], ..Scenario::default() };
    Plan::new(&scene).expect("a scene that plans").bodies.swap_remove(0)
}

fn driven() -> PlannedBody {
    let moment = MomentSpec { moment_n_m: [0.1, 0.2, -0.1], start_s: None, end_s: None };
    body(TorqueSpecs { constant_body: vec![moment], ..TorqueSpecs::default() })
}

fn study(body: &PlannedBody) -> WorkPrecision {
    let methods = vec![Method::ClosedForm, Method::Taylor, Method::Rk4, Method::Dop853];
    let request = Request { methods, errors_rad: ERRORS.to_vec(), budget_s: 0.0, ..Request::default() };
    work_precision(body, END_S, &request).expect("a study")
}

#[test]
fn every_stepper_reaches_every_error_as_cheaply_as_it_can() {
    let study = study(&driven());
    assert_eq!(study.auto, Some(Method::Taylor));
    assert!(study.points.iter().all(|point| point.method != Method::ClosedForm), "it does not cover torques");
    assert!(study.reference.doubt_rad < 1e-15, "the reference is in doubt by {}", study.reference.doubt_rad);
    for level in &study.levels {
        let point = &study.points[level.point.expect("smooth motion is within every method's reach")];
        assert_eq!(point.method, level.method);
        assert!(point.error_rad <= level.error_rad, "{point:?} does not reach {}", level.error_rad);
        // A bisected setting wastes little. Which of two runs of a microsecond costs less is for the clock to say, not here.
        let is_near = |near: &polhode::study::Point| {
            near.method == level.method && (1e-3 * level.error_rad..=level.error_rad).contains(&near.error_rad)
        };
        assert!(study.points.iter().any(is_near), "{:?} was not tried near {}", level.method, level.error_rad);
    }
}

#[test]
fn a_free_body_is_exact_by_the_method_that_auto_picks() {
    let study = study(&body(TorqueSpecs::default()));
    assert_eq!(study.auto, Some(Method::ClosedForm));
    let exact: Vec<_> = study.points.iter().filter(|point| point.method == Method::ClosedForm).collect();
    assert_eq!(exact.len(), 1, "nothing can be asked of it");
    assert_eq!(exact[0].effort.steps, 0);
    assert!(study.reference.doubt_rad > 0.0 && study.reference.doubt_rad < 1e-15, "{}", study.reference.doubt_rad);
}

#[test]
fn errors_and_efforts_are_the_same_every_time() {
    let facts = |study: WorkPrecision| -> Vec<_> {
        study.points.into_iter().map(|point| (point.method, point.value, point.error_rad, point.effort)).collect()
    };
    assert_eq!(facts(study(&driven())), facts(study(&driven())));
}

#[test]
fn auto_stands_for_what_it_picks() {
    let request = Request { methods: vec![Method::Auto, Method::Taylor], budget_s: 0.0, ..Request::default() };
    let study = work_precision(&driven(), END_S, &request).expect("a study");
    assert!(study.points.iter().all(|point| point.method == Method::Taylor));
    assert_eq!(study.levels.len(), request.errors_rad.len(), "Taylor once");
}

#[test]
fn the_front_is_of_points_that_nothing_beats() {
    let study = study(&driven());
    let doubt = study.reference.doubt_rad;
    for point in study.points.iter().filter(|point| point.is_on_front) {
        let beats = |other: &&polhode::study::Point| {
            other.cost.median_s < point.cost.median_s && other.error_rad.max(doubt) < point.error_rad.max(doubt)
        };
        assert!(!study.points.iter().any(|other| beats(&other)), "{point:?} is beaten");
    }
}
