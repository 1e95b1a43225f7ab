use crate::compare::{Reached, Row};
use crate::peer::Peer;

/// How a table is written.
#[derive(Clone, Copy)]
pub enum Style {
    /// Columns under each other, with times.
    Terminal,
    /// For docs/performance.md: ratios only, as times depend on the machine.
    Markdown,
}

/// A row for each error, a column for each side. The ratio is the peer's time over polhode's.
pub fn table(rows: &[Row], doubt_rad: f64, peers: &[Box<dyn Peer>], style: Style) -> String {
    let mut names: Vec<&str> = peers.iter().map(|peer| peer.name()).collect();
    names.dedup();
    let mut cells = vec![["error ≤", "polhode"].into_iter().chain(names.iter().copied()).map(str::to_owned).collect()];
    for row in rows {
        let mut line: Vec<String> = vec![format!("{:.0e}", row.error_rad), our_cell(row, doubt_rad, style)];
        line.extend(names.iter().map(|name| {
            let ways =
                peers.iter().zip(&row.theirs).filter(|(peer, _)| peer.name() == *name).map(|(_, reached)| reached);
            ways.min_by(|a, b| rank(a).partial_cmp(&rank(b)).unwrap_or(std::cmp::Ordering::Equal))
                .map_or_else(String::new, |reached| their_cell(reached, row, doubt_rad, style))
        }));
        cells.push(line);
    }
    match style {
        Style::Markdown => {
            let rule = format!("|{}\n", "---|".repeat(cells[0].len()));
            let mut lines = cells.iter().map(|line| format!("| {} |\n", line.join(" | ")));
            lines.next().into_iter().chain([rule]).chain(lines).collect()
        }
        Style::Terminal => {
            let wide = |column: usize| cells.iter().map(|line| line[column].chars().count()).max().unwrap_or(0);
            let widths: Vec<usize> = (0..cells[0].len()).map(wide).collect();
            let line = |line: &Vec<String>| {
                let padded: Vec<String> =
                    line.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
                format!("{}\n", padded.join("  ").trim_end())
            };
            cells.iter().map(line).collect()
        }
    }
}

/// Of several ways to use a crate: the fastest that reaches the error, else the one that comes nearest.
fn rank(reached: &Reached) -> (bool, f64) {
    (reached.time_s.is_none(), reached.time_s.unwrap_or(reached.error_rad))
}

fn our_cell(row: &Row, doubt_rad: f64, style: Style) -> String {
    let Some(ours) = &row.ours else { return "not reached".into() };
    let cell = format!("{}, {}", resolved(ours.error_rad, doubt_rad), ours.way);
    match style {
        Style::Markdown => cell,
        Style::Terminal => format!("{cell}, {}", time(ours.time_s)),
    }
}

fn their_cell(reached: &Reached, row: &Row, doubt_rad: f64, style: Style) -> String {
    let error = resolved(reached.error_rad, doubt_rad);
    let Some(theirs) = reached.time_s else { return format!("not reached: {error}, {}", reached.way) };
    let ours = row.ours.as_ref().and_then(|ours| ours.time_s);
    let ratio = ours.map_or("–".into(), |ours| ratio(theirs / ours));
    let cell = format!("{ratio}×: {error}, {}", reached.way);
    match style {
        Style::Markdown => cell,
        Style::Terminal => format!("{cell}, {}", time(reached.time_s)),
    }
}

/// `<` where the reference does not resolve it.
fn resolved(error_rad: f64, doubt_rad: f64) -> String {
    if error_rad <= doubt_rad { format!("< {doubt_rad:.0e}") } else { format!("{error_rad:.1e}") }
}

/// Two digits.
fn ratio(ratio: f64) -> String {
    let digits = if ratio < 10.0 { 1 } else { 0 };
    format!("{ratio:.digits$}")
}

fn time(time_s: Option<f64>) -> String {
    time_s.map_or("–".into(), |time| format!("{:.1} µs", time * 1e6))
}
