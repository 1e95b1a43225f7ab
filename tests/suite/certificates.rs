//! Certificates say what a run's error is: small where the path is exact, large where it is not, the same every time.

use polhode::scenario::{BodySpec, Certificate, Method, MomentSpec, Plan, Scenario, TorqueSpecs};
use polhode::study::certify;

/// Of attitude, rad, and relative of ω and L: what closed form and Taylor may be off by over a few turns.
const ROUNDING: f64 = 1e-14;

fn scene(method: Method) -> Scenario {
    let body = BodySpec {
        principal_moments_kg_m2: Some([1.0, 2.0, 2.6]),
        angular_velocity_rad_s: Some([0.7, -0.4, 1.1]),
        ..BodySpec::default()
    };
    Scenario { method, duration_s: Some(6.0), sample_every_s: Some(0.05), body: vec![body], ..Scenario::default() }
}

fn pushed(method: Method) -> Scenario {
    let mut scene = scene(method);
    let push = MomentSpec { moment_n_m: [0.3, -0.2, 0.1], start_s: Some(1.03), end_s: Some(2.51) };
    scene.body[0].torque = TorqueSpecs { constant_body: vec![push], ..TorqueSpecs::default() };
    scene
}

fn only(scene: &Scenario) -> Certificate {
    let plan = Plan::new(scene).expect("a sound scene");
    certify(&plan).expect("a finite motion").remove(0)
}

fn attitude(scene: &Scenario) -> f64 {
    only(scene).attitude_rad.expect("an attitude is recorded")
}

#[test]
fn closed_form_and_taylor_are_certified_to_rounding() {
    for scene in [scene(Method::Auto), pushed(Method::Auto)] {
        let certificate = only(&scene);
        println!("{certificate:?}");
        assert!(certificate.is_whole && certificate.samples == 121 && certificate.covered_to_s > 5.99);
        let errors = [
            certificate.attitude_rad.expect("an attitude is recorded"),
            certificate.angular_velocity_relative,
            certificate.angular_momentum_relative.expect("an attitude is recorded"),
        ];
        assert!(errors.iter().all(|error| *error > 0.0 && *error < ROUNDING), "{errors:?}");
    }
}

#[test]
fn a_coarse_path_is_found_out_and_halving_its_step_seen() {
    let coarse = attitude(&Scenario { step_s: Some(0.05), ..pushed(Method::Rk4) });
    let fine = attitude(&Scenario { step_s: Some(0.025), ..pushed(Method::Rk4) });
    println!("{coarse:e} {fine:e}");
    assert!(coarse > 1e-8 && coarse < 1e-4);
    assert!((8.0..32.0).contains(&(coarse / fine)), "order 4 gains a factor of 16: {coarse:e}, {fine:e}");
}

#[test]
fn certificates_are_the_same_every_time_and_say_whether_a_tolerance_is_kept() {
    let certificate = only(&pushed(Method::Auto));
    assert_eq!(certificate, only(&pushed(Method::Auto)));
    assert!(certificate.keeps(1e-12) && !certificate.keeps(1e-18));
    assert!(!Certificate { is_whole: false, ..certificate }.keeps(1e-12), "what was not compared is not certified");
}

#[test]
fn a_run_beyond_the_reference_is_certified_as_far_as_it_reaches() {
    let long = Scenario { duration_s: Some(2e6), sample_every_s: Some(1.0), ..scene(Method::Auto) };
    let certificate = only(&long);
    println!("{certificate:?}");
    assert!(!certificate.is_whole && certificate.samples == 1000);
    assert!(certificate.covered_to_s > 1000.0 && certificate.covered_to_s < 2e6);
    assert!(certificate.attitude_rad.is_some_and(|error| error < ROUNDING));
}

#[test]
fn on_the_separatrix_the_certificate_ends_where_106_bits_do() {
    let mut scene = Scenario { duration_s: Some(50.0), ..scene(Method::Auto) };
    scene.body[0].principal_moments_kg_m2 = Some([0.75, 2.0, 1.25]);
    scene.body[0].angular_velocity_rad_s = Some([1.0, 0.5, -3.0]);
    let certificate = only(&scene);
    println!("{certificate:?}");
    assert!(!certificate.is_whole && certificate.covered_to_s > 10.0 && certificate.covered_to_s < 40.0);
    assert!(certificate.attitude_rad.is_some_and(|error| error < ROUNDING), "{certificate:?}");
}

#[test]
fn what_is_not_propagated_has_no_figure() {
    let rates = Scenario { channels: Some(vec!["angular_velocity".into()]), ..scene(Method::Auto) };
    let certificate = only(&rates);
    assert_eq!((certificate.attitude_rad, certificate.position_m), (None, None));
    assert!(certificate.facts().iter().all(|(name, _)| *name != "attitude_error_rad"));
}
