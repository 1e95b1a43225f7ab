use serde_json::{Value, json};

use crate::cli::growth::growth_as_json;
use crate::study::{Cell, Drift, Ending, Row, Trial, Truth, Verdict};

/// All of one case.
pub fn row(row: &Row) -> Value {
    let truth = row.truth.as_ref();
    json!({
        "case": row.case.key,
        "title": row.case.title,
        "span_s": row.case.scenario.duration_s,
        "refusal": truth.err().map(|none| &none.reason),
        "reference": truth.ok().map(reference),
        "cells": row.cells.iter().map(cell).collect::<Vec<_>>(),
    })
}

fn reference(truth: &Truth) -> Value {
    json!({
        "method": truth.reference.method,
        "witness": truth.reference.witness,
        "doubt_rad": truth.reference.doubt_rad,
        "horizon_s": truth.horizon_s,
        "condition_rad": truth.condition_rad,
        "fastest_rad_s": truth.fastest,
        "times": truth.times_s.len(),
    })
}

fn cell(cell: &Cell) -> Value {
    json!({
        "method": cell.method.key(),
        "verdict": word(cell.verdict),
        "refusal": cell.refusal,
        "error_rad": cell.best().map(|trial| trial.error_rad),
        "breaks_at": cell.broken().and_then(|trial| trial.value),
        "lost_at_s": cell.broken().and_then(|trial| trial.lost_at_s),
        "runs": cell.trials.iter().map(trial).collect::<Vec<_>>(),
    })
}

/// As JSON and files spell it.
pub const fn word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Kept => "kept",
        Verdict::Coarse => "coarse",
        Verdict::Chaotic => "chaotic",
        Verdict::Lost => "lost",
        Verdict::Wrong => "wrong",
        Verdict::Refused => "refused",
        Verdict::TooLong => "too_long",
        Verdict::Unjudged => "unjudged",
    }
}

fn trial(trial: &Trial) -> Value {
    let (ending, error) = match &trial.ending {
        Ending::Done => ("done", None),
        Ending::Failed(error) => ("failed", Some(error)),
        Ending::Silent => ("not_finite", None),
        Ending::TooLong => ("too_long", None),
    };
    json!({
        "setting": trial.value,
        "path": trial.path.name(),
        "ending": ending,
        "error": error,
        "error_rad": trial.error_rad,
        "limit_rad": trial.limit_rad,
        "rates_error_relative": trial.rates_error,
        "lost_at_s": trial.lost_at_s,
        "energy": trial.energy.as_ref().map(drift),
        "momentum": trial.momentum.as_ref().map(drift),
        "norm_error": trial.norm_error,
        "orthogonality_error": trial.orthogonality_error,
        "sign_jumps": trial.sign_jumps,
        "evaluations": trial.effort.evaluations,
        "steps": trial.effort.steps,
        "rejections": trial.effort.rejections,
        "shortest_step_s": trial.effort.shortest_step_s,
    })
}

fn drift(drift: &Drift) -> Value {
    json!({
        "largest_relative": drift.largest,
        "growth": drift.growth.as_ref().map(growth_as_json),
    })
}
