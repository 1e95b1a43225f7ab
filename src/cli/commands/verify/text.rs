use crate::cli::table::Table;
use crate::comparison::verify::{Estimate, Finding, Kinematics, Laws, Verdict, Verification};
use crate::plot::grouped;

/// Columns of a terminal.
const WIDTH: usize = 80;

/// The verdict, why, the likely causes and what was measured.
pub fn of(file: &str, source: Option<&str>, found: &Verification) -> String {
    let mut text = format!("{file}: {}: {}\n", found.name, headline(found));
    for reason in &found.reasons {
        text.push_str(&wrapped(reason, "  "));
    }
    if !found.causes.is_empty() {
        text.push_str("\nLikely cause\n");
        for (number, finding) in found.causes.iter().enumerate() {
            text.push_str(&cause(number + 1, finding));
        }
    }
    if !found.habits.is_empty() {
        text.push_str("\nWhat error there is, within the tolerance\n");
        for (number, finding) in found.habits.iter().enumerate() {
            text.push_str(&cause(number + 1, finding));
        }
    }
    text.push_str("\nMeasured\n");
    text.push_str(&measured(source, found).render("  "));
    if !found.remarks.is_empty() {
        text.push_str("\nRemarks\n");
        for remark in &found.remarks {
            text.push_str(&wrapped(remark, "  "));
        }
    }
    text
}

/// Those of the file as a whole.
pub fn remarks(remarks: &[String]) -> String {
    let lines: String = remarks.iter().map(|remark| wrapped(remark, "  ")).collect();
    if lines.is_empty() { lines } else { format!("\nThe file\n{lines}") }
}

fn headline(found: &Verification) -> String {
    match found.verdict {
        Verdict::Clean if found.laws.is_none() => {
            "clean: attitude and ω are of one motion; without a body that is all".into()
        }
        Verdict::Clean => format!("clean, within {} rad", found.tolerance_rad),
        Verdict::Wrong => {
            let words = found.causes.first().map(|finding| finding.cause.words());
            format!("WRONG{}", words.map_or_else(String::new, |words| format!(": {words}")))
        }
        Verdict::CannotTell => "cannot tell".into(),
    }
}

fn cause(number: usize, finding: &Finding) -> String {
    let share =
        if finding.share > 0.0 { format!(" ({:.0} % of the error)", 100.0 * finding.share) } else { String::new() };
    let mut text = wrapped(&format!("{number}. {}{share}", finding.cause.words()), "  ");
    text.push_str(&wrapped(&finding.evidence, "     "));
    text.push_str(&wrapped(finding.cause.advice(), "     "));
    text
}

fn measured(source: Option<&str>, found: &Verification) -> Table {
    let mut table = Table::default();
    let clock = &found.clock;
    let [from, to] = clock.span_s;
    table.row(["held against", source.unwrap_or("nothing: no body is given")]);
    table.row([
        "samples",
        &format!(
            "{}, {} to {} s, every {} s",
            grouped(clock.samples as u64),
            plain(from),
            plain(to),
            plain(clock.interval_s)
        ),
    ]);
    table.row(["columns", &found.candidates.chosen.words()]);
    if let Some((_, mismatch)) = found.candidates.runner_up() {
        table.row(["", &format!("the next best reading is off by {mismatch:.1e} of each turn")]);
    }
    if let Some(length) = &found.length {
        table.row(["|q| − 1", &format!("{:.1e} at most; the file resolves {:.0e}", length.off, length.floor)]);
    }
    if let Some(kinematics) = &found.kinematics {
        turning(&mut table, kinematics);
    }
    if let Some(laws) = &found.laws {
        obeying(&mut table, laws);
    }
    if let Some(montgomery) = &found.montgomery {
        table.row([
            "turn about L",
            &format!(
                "off 2ET/|L| − Ω by {:.1e} rad a period of {} s",
                montgomery.worst_rad,
                plain(montgomery.period_s)
            ),
        ]);
        table.row(["", &format!("resolved to {:.0e}; {} periods", montgomery.floor_rad, montgomery.periods)]);
    }
    if let Some(distance) = &found.distance {
        let worst = format!("{:.1e} rad at worst, at {} s", distance.worst_rad, plain(distance.worst_at_s));
        table.row(["from exact motion", &worst]);
        let growth = distance.growth.map_or_else(String::new, |growth| format!(", {}", growth.in_words()));
        table.row(["", &format!("first state leaves {:.0e} rad open{growth}", distance.open_rad)]);
    }
    if let Some(fit) = &found.inertia {
        let [a, b, c] = fit.ratios;
        table.row([
            "inertia that fits",
            &format!("moments {a:.4} : {b:.4} : {c:.4}; R I ω constant to {:.0e}", fit.residual),
        ]);
    }
    table
}

fn turning(table: &mut Table, kinematics: &Kinematics) {
    table.row([
        "turns by ω",
        &format!(
            "within {:.1e}, resolved to {:.0e}; {:.0} samples a turn",
            kinematics.mismatch, kinematics.floor, kinematics.samples_per_turn
        ),
    ]);
    table.row([
        "ω integrated",
        &format!(
            "{:.1e} rad from the attitudes at worst, resolved to {:.0e}",
            kinematics.apart_rad, kinematics.apart_floor_rad
        ),
    ]);
}

fn obeying(table: &mut Table, laws: &Laws) {
    table.row(["error of ω", &format!("{:.1e} from sample to sample, resolved to {:.0e}", laws.defect, laws.floor)]);
    let per_turn = |gain: Estimate| {
        let seen = if gain.is_seen() { "" } else { ": none seen" };
        format!("{:+.1e} a turn, ± {:.0e}{seen}", gain.value, gain.doubt)
    };
    table.row(["gain of E", &per_turn(laws.energy_per_turn)]);
    table.row(["gain of |L|", &per_turn(laws.momentum_per_turn)]);
    if let Some(direction) = laws.direction_rad {
        let seen = if direction.is_seen() { "" } else { ": none seen" };
        table.row([
            "turning of L",
            &format!("{:.1e} rad in {:.1} turns, ± {:.0e}{seen}", direction.value, laws.turns, direction.doubt),
        ]);
    }
}

/// To six digits, without zeros at the end.
fn plain(value: f64) -> String {
    let text = format!("{value:.5e}");
    let rounded: f64 = text.parse().unwrap_or(value);
    if rounded == 0.0 || (1e-3..1e7).contains(&rounded.abs()) { rounded.to_string() } else { format!("{rounded:e}") }
}

/// Broken between words, each line behind `indent`.
fn wrapped(text: &str, indent: &str) -> String {
    let (mut lines, mut line) = (String::new(), indent.to_owned());
    for word in text.split_whitespace() {
        if line.chars().count() > indent.len() && line.chars().count() + word.chars().count() >= WIDTH {
            lines.push_str(&line);
            lines.push('\n');
            indent.clone_into(&mut line);
        }
        if line.chars().count() > indent.len() {
            line.push(' ');
        }
        line.push_str(word);
    }
    lines + &line + "\n"
}
