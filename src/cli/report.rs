use std::path::Path;
use std::time::Duration;

use serde_json::{Value, json};

use super::table::Table;
use crate::plot::{grouped, plain_time};
use crate::propagation::Effort;
use crate::recording::Finished;
use crate::scenario::{Certificate, CheckOutcome, Grid, Plan};

/// What came of running one scene.
pub struct Report {
    pub plan: Plan,
    pub files: Vec<Finished>,
    pub effort: Effort,
    pub wall: Duration,
}

impl Report {
    pub fn passed(&self) -> bool {
        self.plan.outcomes.iter().all(|check| check.passed) && self.missed_tolerances().is_empty()
    }

    /// Each certified body that does not keep the tolerance asked for, in words.
    pub fn missed_tolerances(&self) -> Vec<String> {
        let Some(tolerance) = self.plan.tolerance_rad else { return Vec::new() };
        let certified = self.plan.bodies.iter().filter_map(|body| Some((&body.name, body.certificate.as_ref()?)));
        let missed = certified.filter(|(_, certificate)| !certificate.keeps(tolerance));
        missed
            .map(|(name, certificate)| {
                let error = certificate.attitude_rad.unwrap_or_default();
                let reach = plain_time(certificate.covered_to_s);
                if error > tolerance {
                    format!("tolerance missed: {name} is {error:.1e} rad off, tolerance_rad = {tolerance:e}")
                } else {
                    format!("tolerance not certified: {name} could be measured to t = {reach} s only")
                }
            })
            .collect()
    }

    /// An aligned summary.
    pub fn as_text(&self) -> String {
        let mut table = Table::default();
        for body in &self.plan.bodies {
            table.row([body.name.clone(), format!("{}: {}", body.path.name(), body.reason)]);
        }
        for body in &self.plan.bodies {
            if let Some(certificate) = &body.certificate {
                let name = if self.plan.bodies.len() > 1 { format!("{}: ", body.name) } else { String::new() };
                table.row(["certified".to_owned(), format!("{name}{}", in_words(certificate))]);
            }
        }
        table.row(["samples".to_owned(), sampling(&self.plan.grid)]);
        for (index, line) in files_as_text(&self.files).lines().enumerate() {
            let label = if index == 0 { "files" } else { "" };
            table.row([label, line.trim_start()]);
        }
        table.row(["wall time".to_owned(), self.time()]);
        let text = format!("{}: {}\n{}", self.plan.name, self.plan.title, table.render("  "));
        text + &self.checks_as_text()
    }

    #[expect(clippy::cast_precision_loss, reason = "for people")]
    fn time(&self) -> String {
        let seconds = self.wall.as_secs_f64();
        let each = seconds * 1e9 / self.plan.grid.len() as f64;
        let Effort { evaluations, steps, rejections, .. } = self.effort;
        let work = if steps == 0 {
            format!("{} evaluations", grouped(evaluations))
        } else {
            format!("{} evaluations, {} steps, {} rejected", grouped(evaluations), grouped(steps), grouped(rejections))
        };
        format!("{seconds:.3} s, {each:.0} ns a sample; {work}")
    }

    fn checks_as_text(&self) -> String {
        if self.plan.outcomes.is_empty() {
            return String::new();
        }
        let mut table = Table::default();
        table.row(["checks", "", "measured", "expected", "tolerance"]);
        for check in &self.plan.outcomes {
            let verdict = if check.passed { "ok" } else { "FAILED" };
            table.row([
                verdict.to_owned(),
                check.name.clone(),
                number(check.measured),
                number(check.expected),
                format!("{:e} {}", check.tolerance, check.unit),
            ]);
            if let Some(seen) = &check.observed {
                let off = format!("off by {:.3e}", check.measured - seen.published);
                let published = number(seen.published);
                let uncertainty = format!("{:e} {}", seen.uncertainty, check.unit);
                table.row([String::new(), "  as observed".into(), off, published, uncertainty]);
            }
        }
        table.render("  ")
    }

    pub fn as_json(&self) -> Value {
        let plan = &self.plan;
        let bodies: Vec<_> = plan
            .bodies
            .iter()
            .map(|body| {
                let certificate = body.certificate.as_ref().map(certificate_as_json);
                json!({
                    "name": body.name, "path": body.path.name(), "reason": body.reason, "certificate": certificate,
                })
            })
            .collect();
        let check = |check: &CheckOutcome| {
            json!({
                "name": check.name,
                "measured": check.measured,
                "expected": check.expected,
                "tolerance": check.tolerance,
                "unit": check.unit,
                "passed": check.passed,
                "observed": check.observed.map(|seen| json!({
                    "published": seen.published,
                    "uncertainty": seen.uncertainty,
                    "residual": check.measured - seen.published,
                    "tolerance": seen.tolerance,
                })),
            })
        };
        json!({
            "name": plan.name,
            "title": plan.title,
            "bodies": bodies,
            "samples": plan.grid.len(),
            "end_s": plan.grid.end(),
            "files": files_as_json(&self.files),
            "wall_s": self.wall.as_secs_f64(),
            "evaluations": self.effort.evaluations,
            "steps": self.effort.steps,
            "rejections": self.effort.rejections,
            "tolerance_rad": plan.tolerance_rad,
            "checks": self.plan.outcomes.iter().map(check).collect::<Vec<_>>(),
            "passed": self.passed(),
        })
    }
}

/// A line for each file, with its size.
pub fn files_as_text(files: &[Finished]) -> String {
    let mut table = Table::default();
    for file in files {
        table.row([shown(&file.path), size(file.bytes)]);
    }
    table.render("  ")
}

pub fn files_as_json(files: &[Finished]) -> Vec<Value> {
    files.iter().map(|file| json!({ "path": shown(&file.path), "bytes": file.bytes })).collect()
}

/// The errors, where they are worst, and by what they were measured.
fn in_words(certificate: &Certificate) -> String {
    let Certificate { samples, reference, .. } = certificate;
    let figures = [
        certificate.attitude_rad.map(|error| format!("attitude {error:.1e} rad")),
        Some(format!("ω {:.1e} of its largest", certificate.angular_velocity_relative)),
        certificate.angular_momentum_relative.map(|error| format!("L {error:.1e} of its largest")),
        certificate.position_m.map(|error| format!("position {error:.1e} m")),
    ];
    let figures: Vec<_> = figures.into_iter().flatten().collect();
    let worst = plain_time(certificate.worst_at_s);
    let reach = plain_time(certificate.covered_to_s);
    let until = if certificate.is_whole { String::new() } else { format!(", certified to t = {reach} s only") };
    format!("{}; worst at {worst} s of {samples} samples{until}; by {reference}", figures.join(", "))
}

fn certificate_as_json(certificate: &Certificate) -> Value {
    json!({
        "attitude_rad": certificate.attitude_rad,
        "angular_velocity_relative": certificate.angular_velocity_relative,
        "angular_momentum_relative": certificate.angular_momentum_relative,
        "position_m": certificate.position_m,
        "worst_at_s": certificate.worst_at_s,
        "covered_to_s": certificate.covered_to_s,
        "is_whole": certificate.is_whole,
        "samples": certificate.samples,
        "method": certificate.method,
        "reference": certificate.reference,
        "reference_uncertainty": certificate.reference_uncertainty,
    })
}

/// How many samples, to when.
pub fn sampling(grid: &Grid) -> String {
    let count = grouped(grid.len());
    match grid {
        Grid::Uniform { every_s, .. } => format!("{count}, every {every_s} s to {} s", plain_time(grid.end())),
        Grid::List(_) => format!("{count}, at listed times to {} s", plain_time(grid.end())),
    }
}

/// Fifteen digits at most, as few as will do.
fn number(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let rounded: f64 = format!("{value:.14e}").parse().unwrap_or(value);
    if (1e-4..1e9).contains(&value.abs()) { rounded.to_string() } else { format!("{value:.3e}") }
}

/// With a unit to match.
#[expect(clippy::cast_precision_loss, reason = "for people")]
pub fn size(bytes: u64) -> String {
    match bytes {
        0..1_000 => format!("{bytes} B"),
        1_000..1_000_000 => format!("{:.1} kB", bytes as f64 / 1e3),
        1_000_000..1_000_000_000 => format!("{:.1} MB", bytes as f64 / 1e6),
        _ => format!("{:.1} GB", bytes as f64 / 1e9),
    }
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}
