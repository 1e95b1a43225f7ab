use std::sync::Arc;

use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use super::cause::{Cause, Finding};
use super::inertia::InertiaFit;
use super::kinematics::CLEAR;
use super::laws::Steps;
use super::model::{Model, carried_by};
use super::pushed::Pushed;
use super::reading::axes_name;
use super::series::{Series, rms};
use super::subject::Subject;
use super::{templates, unexplained};
use crate::body::{MassProperties, PrincipalMoments};
use crate::dynamics::{Load, Problem, Profile, Torque};
use crate::propagation::PropagationError;
use crate::recording::Axes;
use crate::scenario::PlannedBody;

/// Intervals on which the hypotheses are tried.
const MOST_INTERVALS: usize = 400;
/// A hypothesis explains the errors if it leaves less than this of them.
const EXPLAINS: f64 = 0.4;

/// A way in which ω may have been made, and what it leaves unexplained, rad/s.
struct Trial {
    cause: Cause,
    left: f64,
    what: String,
}

/// Why ω does not change as it should: what explains most first. Nothing where rounding explains it.
pub(super) fn explain(
    body: &PlannedBody,
    series: &Series,
    other_frame: Option<(&Series, Axes)>,
    pushed: Option<&Arc<Pushed>>,
    rounding_s: f64,
) -> Result<Vec<Finding>, PropagationError> {
    let subject = Subject::new(body, series, pushed);
    let steps = Steps::of(&subject, series, rounding_s, MOST_INTERVALS)?;
    let (all, floor) = (steps.defect(), steps.floor());
    if all <= CLEAR * floor {
        return Ok(Vec::new());
    }
    let mut trials = vec![no_gyroscopic_term(&subject, series, &steps)];
    let left = |body: &PlannedBody, series: &Series| {
        Steps::of(&Subject::new(body, series, pushed), series, rounding_s, MOST_INTERVALS).map(|steps| steps.defect())
    };
    if let Some((other, turns_in)) = other_frame {
        let law = if turns_in == Axes::World { Axes::Body } else { Axes::World };
        trials.push(Trial {
            cause: Cause::WrongFrame { turns_in },
            left: left(body, other)?,
            what: format!(
                "ω obeys Euler's equations if read in {} axes, but turns the attitude in {} axes",
                axes_name(law),
                axes_name(turns_in)
            ),
        });
    }
    for (cause, changed, what) in other_bodies(&subject, series) {
        trials.push(Trial { cause, left: left(&changed, series)?, what });
    }
    if !subject.is_free() {
        trials.extend(not_rotated(&subject, series, &steps));
    }
    trials.sort_by(|one, other| one.left.total_cmp(&other.left));
    let mut findings = Vec::new();
    let share = |left: f64| 1.0 - ((left / all) * (left / all)).min(1.0);
    // A wrong law leaves little of the errors; a law with an error of order h leaves its own share.
    let template = templates::best(&subject, series, &steps, &steps.defects);
    let law = trials.into_iter().next().filter(|trial| trial.left < EXPLAINS * all);
    let is_law = |trial: &Trial| template.as_ref().is_none_or(|(_, left)| trial.left < 0.5 * *left);
    if let Some(clamped) = clamped(&subject, series, &steps) {
        findings.push(clamped);
    }
    match law.filter(is_law) {
        Some(trial) => {
            let without = matches!(trial.cause, Cause::MissingGyroscopicTerm);
            findings.push(Finding { share: share(trial.left), evidence: trial.what, cause: trial.cause });
            if without {
                let defects = no_gyroscopic_defects(&subject, series, &steps);
                if rms(defects.iter().map(Vector3::norm)) > CLEAR * floor {
                    findings.extend(templates::explain(&subject, series, &steps, defects, floor, all));
                }
            }
        }
        None => findings.extend(templates::explain(&subject, series, &steps, steps.defects.clone(), floor, all)),
    }
    if findings.is_empty() {
        findings.push(unexplained::of_rates(&steps, series));
    }
    Ok(findings)
}

fn no_gyroscopic_defects(subject: &Subject, series: &Series, steps: &Steps) -> Vec<Vector3<f64>> {
    let defect = |k: &usize| subject.omega[k + 1] - carried_by(Model::NoGyroscopicTerm, subject, series, *k);
    steps.intervals.iter().map(defect).collect()
}

fn no_gyroscopic_term(subject: &Subject, series: &Series, steps: &Steps) -> Trial {
    let left = rms(no_gyroscopic_defects(subject, series, steps).iter().map(Vector3::norm));
    let what = if subject.is_free() {
        format!("ω stays within {:.1e} from sample to sample, in the body and so in the world", left / series.rate())
    } else {
        "I ω̇ is the torque alone".to_owned()
    };
    Trial { cause: Cause::MissingGyroscopicTerm, left, what }
}

fn not_rotated(subject: &Subject, series: &Series, steps: &Steps) -> Vec<Trial> {
    let first = subject.attitude.first().copied().unwrap_or_default();
    let body = subject.body.properties.body_from_principal;
    let mut trials = Vec::new();
    for held in [first, body] {
        for gyroscopic in [false, true] {
            let model = Model::InertiaInWorld { world_from_principal: held, gyroscopic };
            let defect = |k: &usize| (subject.omega[k + 1] - carried_by(model, subject, series, *k)).norm();
            trials.push(Trial {
                cause: Cause::InertiaNotRotated,
                left: rms(steps.intervals.iter().map(defect)),
                what: "ω changes as that of a tensor that stays as it is in world axes".into(),
            });
        }
    }
    trials
}

/// The same body with something else: moments, or what acts on it.
fn other_bodies(subject: &Subject, series: &Series) -> Vec<(Cause, PlannedBody, String)> {
    let (body, mut all) = (subject.body, Vec::new());
    let moments: [f64; 3] = body.properties.moments.vector().into();
    for order in [[0, 2, 1], [1, 0, 2], [2, 1, 0], [1, 2, 0], [2, 0, 1]] {
        let permuted = order.map(|axis| moments[axis]);
        let distinct = permuted.iter().zip(moments).any(|(one, other)| (one / other - 1.0).abs() > 1e-6);
        if let Some(moments) = PrincipalMoments::new(permuted).ok().filter(|_| distinct) {
            let properties = MassProperties { moments, ..body.properties.clone() };
            let what = format!("Euler's equations hold with moments {permuted:?} kg m²");
            all.push((Cause::PermutedMoments { order }, with_inertia(body, properties), what));
        }
    }
    if subject.is_free() {
        all.extend(fitted(body, series));
        return all;
    }
    let swapped =
        |load: &Load| Load { torque: swapped(&load.torque, body.properties.body_from_principal), ..load.clone() };
    let changes: [(Cause, Vec<Load>, &str); 3] = [
        (
            Cause::TorqueInWrongFrame,
            body.problem.loads.iter().map(swapped).collect(),
            "ω changes as under the same numbers in the other axes",
        ),
        (Cause::TorqueMissing, Vec::new(), "ω changes as if nothing acted"),
        (
            Cause::TorqueReversed,
            body.problem.loads.iter().map(reversed).collect(),
            "ω changes as under the opposite torque",
        ),
    ];
    for (cause, loads, what) in changes {
        if loads != body.problem.loads {
            let problem = Problem { loads, ..body.problem.clone() };
            all.push((cause, PlannedBody { problem, ..body.clone() }, what.to_owned()));
        }
    }
    all
}

fn fitted(body: &PlannedBody, series: &Series) -> Option<(Cause, PlannedBody, String)> {
    let fit = InertiaFit::of(series)?;
    let properties = MassProperties::from_tensor(None, fit.tensor * body.properties.tensor().trace()).ok()?;
    let what = format!("R I ω stays within {:.1e} of constant with the tensor that fits", fit.residual);
    Some((Cause::OtherInertia { ratios: fit.ratios }, with_inertia(body, properties), what))
}

fn with_inertia(body: &PlannedBody, properties: MassProperties) -> PlannedBody {
    let problem = Problem { moments: properties.moments, ..body.problem.clone() };
    PlannedBody { properties, problem, ..body.clone() }
}

/// The numbers given for one frame taken in the other.
fn swapped(torque: &Torque, body_from_principal: UnitQuaternion<f64>) -> Torque {
    let (out, back) = (body_from_principal, body_from_principal.inverse());
    let by = |turn: UnitQuaternion<f64>, profile: &Profile| {
        Arc::new(profile.transformed(turn.to_rotation_matrix().matrix()))
    };
    match *torque {
        Torque::ProfileBody { ref moment } => Torque::ProfileWorld { moment: by(out, moment) },
        Torque::ProfileWorld { ref moment } => Torque::ProfileBody { moment: by(back, moment) },
        Torque::ForceProfileBody { ref force, arm } => Torque::ForceProfileWorld { force: by(out, force), arm },
        Torque::ForceProfileWorld { ref force, arm } => Torque::ForceProfileBody { force: by(back, force), arm },
        Torque::ConstantBody { moment } => Torque::ConstantWorld { moment: out * moment },
        Torque::ConstantWorld { moment } => Torque::ConstantBody { moment: back * moment },
        Torque::ForceBody { force, arm } => Torque::ForceWorld { force: out * force, arm },
        Torque::ForceWorld { force, arm } => Torque::ForceBody { force: back * force, arm },
        ref other => other.clone(),
    }
}

fn reversed(load: &Load) -> Load {
    let torque = match load.torque.clone() {
        Torque::ConstantBody { moment } => Torque::ConstantBody { moment: -moment },
        Torque::ConstantWorld { moment } => Torque::ConstantWorld { moment: -moment },
        Torque::ForceBody { force, arm } => Torque::ForceBody { force: -force, arm },
        Torque::ForceWorld { force, arm } => Torque::ForceWorld { force: -force, arm },
        Torque::MagneticDipole { dipole, field } => Torque::MagneticDipole { dipole: -dipole, field },
        ref other => {
            let mut other = other.clone();
            if let Some(profile) = other.profile_mut() {
                *profile = Arc::new(profile.transformed(&-Matrix3::identity()));
            }
            other
        }
    };
    Load { torque, window: load.window }
}

/// |ω| at its largest again and again, where it should have gone beyond.
fn clamped(subject: &Subject, series: &Series, steps: &Steps) -> Option<Finding> {
    const SAME: f64 = 1e-6;
    let limit = subject.omega.iter().map(Vector3::norm).fold(0.0, f64::max);
    let at_limit = |k: usize| subject.omega[k].norm() > limit * (1.0 - SAME);
    let (mut count, mut beyond, mut explained, mut all) = (0_usize, 0_usize, 0.0, 0.0);
    for (index, &k) in steps.intervals.iter().enumerate() {
        let defect = steps.defects[index].norm_squared();
        all += defect;
        if at_limit(k + 1) {
            count += 1;
            explained += defect;
            let due = steps.exact[index].angular_velocity.in_body().norm();
            beyond += usize::from(due > limit + CLEAR * series.omega_doubt);
        }
    }
    let is_clamp = count >= 5 && beyond * 10 >= count * 9 && explained > 0.8 * all && all > 0.0;
    is_clamp.then(|| Finding {
        cause: Cause::ClampedRate { limit },
        share: explained / all,
        evidence: format!("{count} samples have the largest |ω| of all, where it should have grown"),
    })
}
