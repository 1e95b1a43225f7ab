use serde_json::{Value, json};

use crate::cli::growth::growth_as_json;
use crate::comparison::verify::{Estimate, Finding, Reading, Update, Verification, axes_name};

/// All that was found of a body.
pub fn of(found: &Verification) -> Value {
    let clock = &found.clock;
    json!({
        "body": found.name,
        "verdict": found.verdict.name(),
        "reasons": found.reasons,
        "causes": found.causes.iter().map(finding).collect::<Vec<_>>(),
        "habits": found.habits.iter().map(finding).collect::<Vec<_>>(),
        "remarks": found.remarks,
        "tolerance_rad": found.tolerance_rad,
        "samples": {
            "count": clock.samples,
            "from_s": clock.span_s[0],
            "to_s": clock.span_s[1],
            "interval_s": clock.interval_s,
            "gaps": clock.gaps,
            "not_ascending": clock.not_ascending,
            "repeated": clock.repeated,
            "rounding_s": clock.rounding_s,
        },
        "columns": columns(found),
        "norm": found.length.as_ref().map(|length| json!({
            "off": length.off,
            "off_at_s": length.off_at_s,
            "floor": length.floor,
            "sign_flips": length.sign_flips,
        })),
        "kinematics": found.kinematics.as_ref().map(|kinematics| json!({
            "samples_per_turn": kinematics.samples_per_turn,
            "mismatch": kinematics.mismatch,
            "floor": kinematics.floor,
            "lag_s": estimate(kinematics.lag),
            "excess": estimate(kinematics.excess),
            "apart_rad": kinematics.apart_rad,
            "apart_floor_rad": kinematics.apart_floor_rad,
            "jumps": kinematics.jumps,
            "first_jump_s": kinematics.first_jump_s,
            "update": kinematics.update.map(Update::words),
        })),
        "laws": found.laws.as_ref().map(|laws| json!({
            "defect": laws.defect,
            "floor": laws.floor,
            "energy_per_turn": estimate(laws.energy_per_turn),
            "momentum_per_turn": estimate(laws.momentum_per_turn),
            "direction_rad": laws.direction_rad.map(estimate),
            "turns": laws.turns,
        })),
        "montgomery": found.montgomery.as_ref().map(|montgomery| json!({
            "period_s": montgomery.period_s,
            "periods": montgomery.periods,
            "due_rad": montgomery.due_rad,
            "worst_rad": montgomery.worst_rad,
            "floor_rad": montgomery.floor_rad,
        })),
        "distance": found.distance.as_ref().map(|distance| json!({
            "worst_rad": distance.worst_rad,
            "worst_at_s": distance.worst_at_s,
            "open_rad": distance.open_rad,
            "last_rad": distance.last_rad,
            "leaves_at_s": distance.leaves_at_s,
            "growth": distance.growth.as_ref().map(growth_as_json),
        })),
        "inertia": found.inertia.as_ref().map(|fit| json!({
            "ratios": fit.ratios,
            "tensor": (0..3).map(|row| (0..3).map(|column| fit.tensor[(row, column)]).collect()).collect::<Vec<Vec<f64>>>(),
            "residual": fit.residual,
        })),
    })
}

fn finding(finding: &Finding) -> Value {
    json!({
        "cause": finding.cause.name(),
        "words": finding.cause.words(),
        "share": finding.share,
        "evidence": finding.evidence,
        "advice": finding.cause.advice(),
    })
}

fn estimate(estimate: Estimate) -> Value {
    json!({ "value": estimate.value, "doubt": estimate.doubt })
}

fn columns(found: &Verification) -> Value {
    let reading = |reading: &Reading| {
        json!({
            "words": reading.words(),
            "scalar_last": reading.scalar_last,
            "body_from_world": reading.body_from_world,
            "axes": axes_name(reading.axes),
            "rate_factor": reading.rate_factor,
        })
    };
    let candidates = &found.candidates;
    let all: Vec<_> =
        candidates.all.iter().map(|(one, mismatch)| json!({ "reading": reading(one), "mismatch": mismatch })).collect();
    json!({ "chosen": reading(&candidates.chosen), "frame_is_decided": candidates.is_decided, "candidates": all })
}
