//! How exactly rapier turns a free body, said by goldens: `cargo test -- --nocapture` shows the reports.

use std::error::Error;

use polhode::golden::{self, Golden, HoldError, Limits, Pose, Report};
use polhode::scenario::{Plan, Scenario};
use rapier_golden::FreeBody;

/// Body axes are principal axes and, at the start, world axes.
const MOMENTS: [f64; 3] = [1.0, 2.0, 3.0];
/// Parts of a step in rapier, where nothing else is said.
const SUBSTEPS: usize = 4;

fn start(angular_velocity: [f64; 3]) -> Pose {
    Pose::wxyz([1.0, 0.0, 0.0, 0.0]).turning_in_body(angular_velocity)
}

/// What rapier makes of a body that starts as `start` says.
fn simulation(moments: [f64; 3], start: &Pose, step_s: f64) -> impl FnMut(f64) -> Pose + use<> {
    let angular_velocity = start.angular_velocity_in_world().expect("a start turns");
    let mut body = FreeBody::new(moments, start.attitude_wxyz(), angular_velocity, step_s, SUBSTEPS);
    move |time_s| {
        body.advance_to(time_s);
        Pose::wxyz(body.attitude()).turning_in_world(body.angular_velocity())
    }
}

fn worst_rad(report: &Report) -> f64 {
    report.attitude.map_or(0.0, |worst| worst.difference)
}

/// rapier turns an attitude by 1 + hω/2, made unit: by 2 atan(hω/2) in place of hω, which is (hω)²/12 of it less.
#[test]
fn a_spin_about_a_principal_axis_holds_but_for_what_a_linear_turn_leaves_out() -> Result<(), HoldError> {
    let (spin, step_s, duration_s) = (3.0, 1e-2, 10.0);
    let start = start([0.0, 0.0, spin]);
    let golden = Golden::free(MOMENTS, start, duration_s, 0.1)?;
    let substep_turn: f64 = spin * step_s / SUBSTEPS as f64;
    let left_out = spin * duration_s * substep_turn.powi(2) / 12.0;
    let limits = Limits::attitude(1.001 * left_out).angular_velocity(1e-12);
    let report = golden.hold(limits, simulation(MOMENTS, &start, step_s))?;
    println!("{report}\n");
    assert!(worst_rad(&report) > 0.999 * left_out, "{} rad in place of {left_out}", worst_rad(&report));
    Ok(())
}

/// The gyroscopic term is taken at the start of each substep: an error of the first order, at any step.
#[test]
fn a_tumbling_body_is_off_in_proportion_to_the_step() -> Result<(), HoldError> {
    let start = start([1.0, 2.0, 1.5]);
    let golden = Golden::free(MOMENTS, start, 10.0, 0.1)?;
    let mut errors = Vec::new();
    for step_s in [1e-2, 5e-3, 2.5e-3] {
        let report = golden.hold(Limits::none(), simulation(MOMENTS, &start, step_s))?;
        println!("a step of {step_s} s: {report}\n");
        errors.push(worst_rad(&report));
    }
    assert!((0.08..0.09).contains(&errors[0]), "{errors:?} rad");
    for pair in errors.windows(2) {
        assert!((1.9..2.1).contains(&(pair[0] / pair[1])), "{errors:?} rad: no first order");
    }
    Ok(())
}

/// The committed golden, at 240 steps a second: right through the first flip (at 4.4 s), not through the second (13.1 s),
/// where the handle comes late.
#[test]
fn the_t_handle_of_the_golden_turns_over_but_not_when_it_should() -> Result<(), Box<dyn Error>> {
    let path = "../../recordings/golden/dzhanibekov.mcap";
    let plan = Plan::new(&Scenario::named("dzhanibekov", &[])?)?;
    let moments = plan.bodies[0].properties.moments.vector().into();
    let start = Golden::open(path)?.poses()[0];
    let engine = || simulation(moments, &start, 1.0 / 240.0);
    golden::hold(path, Limits::attitude(1e-2).until(10.0), engine())?;
    let Err(HoldError::Diverged(report)) = golden::hold(path, Limits::attitude(1e-2), engine()) else {
        return Err("rapier has become exact, or the golden is gone".into());
    };
    println!("{report}\n");
    let first = report.first.ok_or("no divergence")?;
    assert!((11.0..14.0).contains(&first.time_s), "{report}");
    assert!((0.05..0.5).contains(&worst_rad(&report)), "{report}");
    Ok(())
}
