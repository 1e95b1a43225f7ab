use std::io::IsTerminal;

use super::execute::Matrix;
use crate::scenario::Method;
use crate::study::{Cell, Depth, Row, Verdict};

/// What each sign means, below the matrix.
pub const LEGEND: &str = "\
A number: how many digits of the attitude are right at the finest setting, −log₁₀ of the error in rad.
  =  within its limit: as right as f64 and the motion allow, or as promised
  ~  follows the motion, but less exactly than f64 allows
  c  chaotic: the motion itself magnifies one rounding past 0.1 rad
  x  loses the motion (0.1 rad), or ends with an error on the way
  !! what must never be given: beyond its promise, not finite without an error, not of unit length
  –  refused before the run, with a reason       .  would take too many steps
  ?  nothing to measure it by";

/// Letters of one column: two to a method.
#[must_use]
pub const fn short(method: Method) -> &'static str {
    match method {
        Method::Auto => "au",
        Method::ClosedForm => "cf",
        Method::Taylor => "ta",
        Method::Dop853 => "do",
        Method::EulerNaive => "en",
        Method::EulerSemiImplicit => "es",
        Method::Rk4 => "rk",
        Method::Rkmk4 => "mk",
        Method::Splitting2 => "s2",
        Method::Splitting4 => "s4",
        Method::Splitting6 => "s6",
        Method::Splitting8 => "s8",
        Method::Dmv2 => "d2",
        Method::Dmv4 => "d4",
        Method::Dmv6 => "d6",
        Method::Dmv8 => "d8",
        Method::Gauss4 => "g4",
        Method::Gauss6 => "g6",
        Method::Kicks2 => "k2",
        Method::Kicks4 => "k4",
    }
}

/// Cases down, methods across: 80 columns for every method.
pub fn as_text(matrix: &Matrix) -> String {
    let colours = std::io::stdout().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
    let widest = matrix.rows.iter().map(|row| row.case.key.len()).max().unwrap_or(0);
    let depth = if matrix.depth == Depth::Quick { "quick" } else { "full" };
    let mut text = format!("{depth:widest$} ");
    for method in &matrix.methods {
        text.push_str(&format!(" {:>2}", short(*method)));
    }
    text.push('\n');
    for row in &matrix.rows {
        text.push_str(&line(row, widest, colours));
    }
    let names = matrix.methods.iter().map(|method| format!("{} {}", short(*method), method.key()));
    text.push_str(&format!("\n{LEGEND}\n{}\n", wrapped(names)));
    let cells = || matrix.rows.iter().flat_map(|row| &row.cells);
    let count = |verdict: Verdict| cells().filter(|cell| cell.verdict == verdict).count();
    let runs: usize = cells().map(|cell| cell.trials.len()).sum();
    text.push_str(&format!(
        "{} cells, {runs} runs: {} within their limits, {} coarse, {} lost, {} wrong\n",
        cells().count(),
        count(Verdict::Kept),
        count(Verdict::Coarse),
        count(Verdict::Lost),
        count(Verdict::Wrong),
    ));
    for row in &matrix.rows {
        for cell in row.cells.iter().filter(|cell| cell.verdict == Verdict::Wrong || cell.method == Method::Auto) {
            if let Some(reason) = remark(row, cell) {
                text.push_str(&format!("{}, {}: {reason}\n", row.case.key, cell.method.key()));
            }
        }
    }
    text
}

fn line(row: &Row, widest: usize, colours: bool) -> String {
    let mut text = format!("{:widest$} ", row.case.key);
    for cell in &row.cells {
        let sign = format!("{:>3}", cell.sign());
        match colour(cell.verdict).filter(|_| colours) {
            Some(colour) => text.push_str(&format!("\x1b[{colour}m{sign}\x1b[0m")),
            None => text.push_str(&sign),
        }
    }
    text.push('\n');
    text
}

/// As terminals number colours.
const fn colour(verdict: Verdict) -> Option<&'static str> {
    match verdict {
        Verdict::Kept => Some("32"),
        Verdict::Coarse | Verdict::Chaotic => Some("33"),
        Verdict::Lost => Some("31"),
        Verdict::Wrong => Some("1;97;41"),
        Verdict::Refused | Verdict::TooLong | Verdict::Unjudged => None,
    }
}

/// Why a cell is refused or wrong.
fn remark(row: &Row, cell: &Cell) -> Option<String> {
    match cell.verdict {
        Verdict::Refused | Verdict::Unjudged => cell.refusal.clone(),
        Verdict::Wrong => Some(cell.refusal.clone().unwrap_or_else(|| {
            let worst = cell.trials.iter().map(|trial| {
                format!(
                    "{}: {:.1e} rad off, limit {:.1e}, length {:.0e}, {:?} jumps, {:?}",
                    trial.path.name(),
                    trial.error_rad,
                    trial.limit_rad,
                    trial.norm_error,
                    trial.sign_jumps,
                    trial.ending
                )
            });
            let truth =
                row.truth.as_ref().map_or(String::new(), |truth| format!("reference: {}; ", truth.reference.method));
            truth + &worst.collect::<Vec<_>>().join("; ")
        })),
        _ => None,
    }
}

/// Words on lines of at most 80 letters.
fn wrapped(words: impl Iterator<Item = String>) -> String {
    let mut lines = vec![String::new()];
    for word in words {
        let last = lines.last().map_or(0, String::len);
        if last > 0 && last + 2 + word.len() > 78 {
            lines.push(String::new());
        }
        if let Some(line) = lines.last_mut() {
            if !line.is_empty() {
                line.push_str(", ");
            }
            line.push_str(&word);
        }
    }
    lines.join("\n")
}
