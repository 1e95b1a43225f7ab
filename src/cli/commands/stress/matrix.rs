use std::io::IsTerminal;

use super::execute::Matrix;
use crate::cli::args::Shown;
use crate::scenario::Method;
use crate::study::{Cell, Depth, Ending, Row, Trial, Verdict};

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

/// Cases down, methods across, once for each of what is `shown`: 80 columns for every method.
pub fn as_text(matrix: &Matrix, shown: &[Shown]) -> String {
    let names = matrix.methods.iter().map(|method| format!("{} {}", short(*method), method.key()));
    let tables: String = shown.iter().map(|shown| table(matrix, *shown) + "\n").collect();
    let cells = matrix.rows.iter().flat_map(|row| row.cells.iter().filter_map(|cell| remark(row, cell)));
    let remarks: String = matrix.rows.iter().filter_map(horizon).chain(cells).collect();
    format!("{tables}{}\n\n{}\n{remarks}", wrapped(names), summary(matrix))
}

/// One matrix with its legend; each group of cases has the methods above it.
fn table(matrix: &Matrix, shown: Shown) -> String {
    let colours = std::io::stdout().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
    let widest = matrix.rows.iter().map(|row| row.case.key.len().max(row.case.group.len())).max().unwrap_or(0);
    let depth = if matrix.depth == Depth::Quick { "quick" } else { "full" };
    let heads = matrix.methods.iter().map(|method| short(*method)).collect::<Vec<_>>().join(" ");
    let group = |rows: &[Row]| {
        let title = rows.first().map_or(String::new(), |row| row.case.group.to_uppercase());
        let rows: String = rows.iter().map(|row| line(row, shown, widest, colours)).collect();
        format!("{title:widest$}  {heads}\n{rows}\n")
    };
    let groups: String = matrix.rows.chunk_by(|a, b| a.case.group == b.case.group).map(group).collect();
    format!("{depth}: {}\n\n{groups}{}", shown.title(), shown.legend())
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

fn line(row: &Row, shown: Shown, widest: usize, colours: bool) -> String {
    let cell = |cell: &Cell| {
        let sign = format!("{:>3}", shown.sign(row, cell));
        match colour(cell.verdict).filter(|_| colours && shown == Shown::Attitude) {
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

/// How far a chaotic motion is judged: a line of its own.
fn horizon(row: &Row) -> Option<String> {
    let (horizon, span) = (row.truth.as_ref().ok()?.horizon_s?, row.case.scenario.duration_s?);
    let why = "a rounding moves the motion by more than 1e-4 rad";
    Some(format!("{}: judged to {horizon:.3e} s of {span:.3e} s; later {why}\n", row.case.key))
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
