use super::candidates::{FEWEST_PER_TURN, RIGHT};
use super::cause::{Cause, Finding};
use super::kinematics::{CLEAR, Kinematics};
use super::reading::axes_name;
use super::series::{Series, rms};
use super::{Reading, Rotation, Verdict, Verification, unexplained};
use crate::recording::Observed;

/// A reading that leaves more than this of each turn is wrong, relative.
const MISREAD: f64 = 0.3;
/// What leads less than this share of the tolerance astray is no cause.
const COUNTS: f64 = 0.1;

/// Puts the verdict, its reasons, the causes and the remarks.
pub(super) fn judge(found: &mut Verification, observed: &Observed, series: &Series, of_rates: Vec<Finding>) {
    let mut causes = of_columns(found, observed);
    let misread = found.candidates.mismatch().is_some_and(|mismatch| mismatch > MISREAD);
    let mut reasons = Vec::new();
    if !causes.is_empty() {
        reasons.push(format!("the columns are not what they are said to be: {}", found.candidates.chosen.words()));
    }
    let tolerance = found.tolerance_rad;
    if let Some(length) = found.length.as_ref().filter(|length| length.off > tolerance.max(CLEAR * length.floor)) {
        reasons.push(format!("|q| is off 1 by up to {:.1e} (at {:.6} s)", length.off, length.off_at_s));
        causes.push(Finding {
            cause: Cause::NotNormalised,
            share: 1.0,
            evidence: format!("|q| − 1 is up to {:.1e}; the file resolves {:.0e}", length.off, length.floor),
        });
    }
    let motion = moves_wrong(found, &mut reasons);
    let turning = found.kinematics.as_ref().and_then(|kinematics| turns_wrong(kinematics, tolerance, &mut reasons));
    if misread {
        reasons.push("no reading of the columns makes attitude and ω one motion".into());
        causes.push(Finding {
            cause: Cause::RatesDisagree,
            share: 1.0,
            evidence: format!(
                "they differ by {:.0} % of each turn",
                100.0 * found.candidates.mismatch().unwrap_or(1.0)
            ),
        });
    }
    if motion {
        // By how much of the error each explains; those of ω come before those of q, which follow from it.
        causes.extend(of_rates);
    } else {
        found.habits = of_rates.into_iter().filter(|finding| finding.share > 0.0).collect();
    }
    if let Some((finding, effect)) = found.kinematics.as_ref().and_then(|kinematics| of_turning(kinematics, series)) {
        // Half a step between q and ω is the habit of engines: a cause where there is no other.
        let is_lag = matches!(finding.cause, Cause::OutOfStep { .. });
        let is_cause = (motion || turning.is_some()) && effect > COUNTS * tolerance && (causes.is_empty() || !is_lag);
        if is_cause {
            causes.push(finding);
        } else if !is_lag {
            found.habits.push(finding);
        }
    } else if let Some(kinematics) = found.kinematics.as_ref().filter(|kinematics| {
        // Of the method's own error next to nothing is left in a turn.
        turning.is_some() && kinematics.jumps == 0 && (!motion || kinematics.mismatch > RIGHT)
    }) && causes.iter().all(|finding| finding.cause == Cause::Truncation)
    {
        causes.insert(0, unexplained::of_turning(kinematics));
    }
    if motion && causes.is_empty() {
        causes.push(unexplained::of_motion(found, observed));
    }
    if let Some(kinematics) = found.kinematics.as_ref().filter(|kinematics| kinematics.jumps > 0) {
        reasons.push(format!(
            "the attitude jumps {} times, first at {:.6} s",
            kinematics.jumps,
            kinematics.first_jump_s.unwrap_or(0.0)
        ));
        causes.insert(
            0,
            Finding {
                cause: Cause::DroppedFrames,
                share: 1.0,
                evidence: format!(
                    "{} turns from sample to sample are far from ω and from their neighbours",
                    kinematics.jumps
                ),
            },
        );
    }
    let known = found.laws.is_some() || found.kinematics.is_some();
    found.verdict = match (reasons.is_empty(), known) {
        (false, _) => Verdict::Wrong,
        (true, true) => Verdict::Clean,
        (true, false) => Verdict::CannotTell,
    };
    if found.verdict == Verdict::CannotTell {
        reasons.push(unknown(series));
    }
    found.remarks = remarks(found, observed, series);
    found.reasons = reasons;
    found.causes = causes;
}

/// Columns that mean other things than they are said to.
fn of_columns(found: &Verification, observed: &Observed) -> Vec<Finding> {
    let (Some(_), Some(rates)) = (&observed.attitude, &observed.angular_velocity) else { return Vec::new() };
    let Reading { scalar_last, body_from_world, axes, rate_factor } = found.candidates.chosen;
    let told = rates.axes;
    let plain = found.candidates.all.iter().find(|(reading, _)| {
        *reading == Reading::plain(told.unwrap_or(axes)) || told.is_none() && *reading == Reading::plain(reading.axes)
    });
    let evidence = format!(
        "attitude and ω then agree within {:.1e} of each turn, otherwise within {:.1e}",
        found.candidates.mismatch().unwrap_or(f64::NAN),
        plain.map_or(f64::NAN, |(_, mismatch)| *mismatch)
    );
    let other = told.is_some_and(|told| told != axes) && found.candidates.is_decided;
    let misread = found.candidates.mismatch().is_some_and(|mismatch| mismatch > MISREAD);
    let causes = [
        (scalar_last, Cause::QuaternionOrder),
        (body_from_world, Cause::QuaternionConjugated),
        (rate_factor == Reading::DEGREES, Cause::Degrees),
        (rate_factor != 1.0 && rate_factor != Reading::DEGREES, Cause::TimeScale { factor: rate_factor }),
        (other && !body_from_world, Cause::OtherFrameThanTold { found: axes }),
    ];
    let is_one = |(is, _): &(bool, Cause)| *is && !misread;
    causes
        .into_iter()
        .filter(is_one)
        .map(|(_, cause)| Finding { cause, share: 1.0, evidence: evidence.clone() })
        .collect()
}

/// Whether the motion is not the exact one.
fn moves_wrong(found: &Verification, reasons: &mut Vec<String>) -> bool {
    let before = reasons.len();
    if let Some(distance) = &found.distance {
        if let Some(time) = distance.leaves_at_s {
            reasons.push(format!(
                "attitudes leave the exact motion: by {:.1e} rad from {:.6} s on, by {:.1e} rad at worst",
                found.tolerance_rad, time, distance.worst_rad
            ));
        }
    } else if let Some(laws) = &found.laws {
        for (name, gain) in [("E", laws.energy_per_turn), ("|L|", laws.momentum_per_turn)] {
            if gain.is_seen() && (gain.value * laws.turns).abs() > found.tolerance_rad {
                reasons
                    .push(format!("{name} changes by {:+.1e} in each turn, with no torque that does it", gain.value));
            }
        }
    }
    reasons.len() > before
}

/// Whether attitudes go another way than ω.
fn turns_wrong(kinematics: &Kinematics, tolerance: f64, reasons: &mut Vec<String>) -> Option<()> {
    let is_wrong = kinematics.apart_rad > tolerance + CLEAR * kinematics.apart_floor_rad;
    is_wrong.then(|| {
        reasons
            .push(format!("attitudes go another way than ω: by up to {:.1e} rad over the whole", kinematics.apart_rad));
    })
}

/// Why attitudes turn otherwise than ω says, and how far that leads over the whole, rad.
fn of_turning(kinematics: &Kinematics, series: &Series) -> Option<(Finding, f64)> {
    let (update, excess, lag) = (kinematics.update, kinematics.excess, kinematics.lag);
    let found = |cause, evidence| Finding { cause, share: 0.0, evidence };
    let is_first_order = update.is_some_and(super::Update::is_first_order);
    if is_first_order || excess.value.abs() > CLEAR * excess.doubt {
        let effect = excess.value.abs() * series.angle();
        let missing = -excess.value;
        let turn = rms((1..series.len()).map(|k| series.omega[k - 1].norm() * (series.times[k] - series.times[k - 1])));
        // 2 arctan(θ/2) = θ − θ³/12, arctan θ = θ − θ³/3: no step is longer than the time between samples.
        if is_first_order || (missing > 0.0 && missing < 1.2 * turn * turn / 3.0) {
            let step = (12.0 * missing.max(0.0)).sqrt() / series.rate();
            let of_matrix = update.is_some_and(|update| update.rotation == Rotation::OrthogonalisedMatrix);
            let step_s = if of_matrix { 0.5 * step } else { step };
            let formula = update.map_or_else(String::new, |update| format!("; each is {}", update.words()));
            let evidence = format!("attitudes turn by {missing:.2e} less than ω says, as |ω|² h²/12 is{formula}");
            return Some((found(Cause::FirstOrderAttitude { step_s, update }, evidence), effect));
        }
        let evidence = format!("the turns from sample to sample are {:+.3e} of what ω makes", excess.value);
        return Some((found(Cause::TimeScale { factor: 1.0 + excess.value }, evidence), effect));
    }
    let evidence = match update {
        Some(update) => format!("each attitude is that before turned by {}", update.words()),
        None => format!("attitudes turn as ω does {:+.3e} s later", lag.value),
    };
    let effect = lag.value.abs() * series.rate();
    lag.is_seen().then(|| (found(Cause::OutOfStep { lag_s: lag.value, update }, evidence), effect))
}

fn unknown(series: &Series) -> String {
    let per_turn = series.samples_per_turn();
    if per_turn < FEWEST_PER_TURN {
        return format!("{per_turn:.1} samples to a turn do not tell: it takes {FEWEST_PER_TURN}, or ω and a body");
    }
    "without a body only attitude and ω together can be judged, and one is missing".into()
}

/// What is odd and no fault.
fn remarks(found: &Verification, observed: &Observed, series: &Series) -> Vec<String> {
    let mut remarks = Vec::new();
    let clock = &found.clock;
    if clock.repeated > 0 {
        remarks.push(format!(
            "{} samples repeat the one before and are left out: the recorder is faster than the simulation",
            clock.repeated
        ));
    }
    if clock.not_ascending > 0 {
        remarks.push(format!("{} times do not come after the one before; left out", clock.not_ascending));
    }
    if clock.gaps > 0 {
        remarks.push(format!("{} intervals are longer than 1.5 times the usual", clock.gaps));
    }
    if clock.rounding_s > 1e-9 * clock.interval_s {
        remarks.push(format!("times are uneven by {:.1e} s, as rounding is", clock.rounding_s));
    }
    if found.length.as_ref().is_some_and(|length| length.sign_flips > 0) {
        remarks.push("q changes its sign now and then, which is the same attitude".into());
    }
    let told = observed.angular_velocity.as_ref().and_then(|track| track.axes);
    if observed.attitude.is_some() && observed.angular_velocity.is_some() && !found.candidates.is_decided {
        let by = if told.is_some() { "told" } else { "assumed" };
        remarks.push(format!(
            "the motion does not tell the frame of ω: {} axes are {by}",
            axes_name(found.candidates.chosen.axes)
        ));
    }
    if series.is_derived {
        remarks
            .push(format!("there is no ω in the file: found from attitudes, within {:.1e} rad/s", series.omega_doubt));
    }
    if let Some(kinematics) = &found.kinematics {
        if kinematics.lag.is_seen() {
            let interval = clock.interval_s;
            remarks.push(format!(
                "attitudes turn as ω does {:+.3e} s later ({:+.2} samples): q and ω are not of one instant",
                kinematics.lag.value,
                kinematics.lag.value / interval
            ));
        }
        if let Some(update) = kinematics.update {
            remarks.push(format!("to rounding, each attitude is that before turned by {}", update.words()));
        }
    } else if observed.attitude.is_some() && observed.angular_velocity.is_some() {
        remarks.push(format!(
            "{:.1} samples to a turn do not show whether attitudes turn as ω says: it takes {FEWEST_PER_TURN}",
            series.samples_per_turn()
        ));
    }
    remarks
}
