use std::io::IsTerminal;

use super::execute::Matrix;
use crate::scenario::Method;
use crate::study::{Cell, Depth, Ending, Row, Trial, Verdict};

/// What each sign means, below the matrix.
pub const LEGEND: &str = "\
A number: right digits of the attitude at the finest setting, −log₁₀ of the error in rad
  =  within its limit: as right as f64 and the motion allow, or as promised
  ~  follows the motion, but less exactly than f64 allows
  c  chaotic: the motion itself magnifies one rounding past 0.1 rad
  x  loses the motion (0.1 rad), or ends with an error on the way
  !! must never be given: beyond its promise, not finite without an error,
     not of unit length, or with a jump of the quaternion's sign
  –  refused before the run, with a reason
  .  would take too many steps
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
    let heads = matrix.methods.iter().map(|method| short(*method)).collect::<Vec<_>>().join(" ");
    let rows: String = matrix.rows.iter().map(|row| line(row, widest, colours)).collect();
    let names = matrix.methods.iter().map(|method| format!("{} {}", short(*method), method.key()));
    let words = [format!("{depth:widest$}  {heads}\n{rows}"), LEGEND.to_owned(), wrapped(names), summary(matrix)];
    let remarks = matrix.rows.iter().flat_map(|row| row.cells.iter().filter_map(|cell| remark(row, cell)));
    format!("{}\n{}", words.join("\n"), remarks.collect::<String>())
}

/// How many of what.
fn summary(matrix: &Matrix) -> String {
    let cells = || matrix.rows.iter().flat_map(|row| &row.cells);
    let count = |verdict: Verdict| cells().filter(|cell| cell.verdict == verdict).count();
    let runs: usize = cells().map(|cell| cell.trials.len()).sum();
    let [kept, coarse, lost, wrong] = [Verdict::Kept, Verdict::Coarse, Verdict::Lost, Verdict::Wrong].map(count);
    let cells = cells().count();
    format!("{cells} cells, {runs} runs: {kept} within their limits, {coarse} coarse, {lost} lost, {wrong} wrong")
}

fn line(row: &Row, widest: usize, colours: bool) -> String {
    let cell = |cell: &Cell| {
        let sign = format!("{:>3}", cell.sign());
        match colour(cell.verdict).filter(|_| colours) {
            Some(colour) => format!("\x1b[{colour}m{sign}\x1b[0m"),
            None => sign,
        }
    };
    format!("{:widest$} {}\n", row.case.key, row.cells.iter().map(cell).collect::<String>())
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

/// Why a cell is wrong, or refused by `auto`: a line of its own.
fn remark(row: &Row, cell: &Cell) -> Option<String> {
    let reason = match (cell.verdict, cell.method) {
        (Verdict::Wrong, _) => cell.refusal.clone().unwrap_or_else(|| faults(cell)),
        (Verdict::Refused | Verdict::Unjudged, Method::Auto) => cell.refusal.clone()?,
        _ => return None,
    };
    let reason = reason.trim_start_matches(": ").lines().next().unwrap_or_default().to_owned();
    Some(format!("{}, {}: {reason}\n", row.case.key, cell.method.key()))
}

fn faults(cell: &Cell) -> String {
    let fault = |trial: &Trial| {
        let Trial { error_rad, limit_rad, norm_error, .. } = trial;
        let jumps = trial.sign_jumps.unwrap_or(0);
        let ending = match &trial.ending {
            Ending::Done => "done",
            Ending::Failed(error) => error,
            Ending::Silent => "not finite",
            Ending::TooLong => "too long",
        };
        format!("{error_rad:.1e} rad off, limit {limit_rad:.1e}; length {norm_error:.0e} off; {jumps} jumps; {ending}")
    };
    cell.trials.iter().map(fault).collect::<Vec<_>>().join(" | ")
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
