use serde_json::{Value, json};

use super::clock;
use crate::cli::table::Table;
use crate::plot::grouped;
use crate::study::{Point, WorkPrecision};

/// What a person wants to know: who reaches which error at what cost.
pub fn as_text((scene, bodies): &(String, Vec<WorkPrecision>)) -> String {
    bodies.iter().map(|study| body(scene, study)).collect::<Vec<_>>().join("\n")
}

fn body(scene: &str, study: &WorkPrecision) -> String {
    let reference = &study.reference;
    let mut text = format!(
        "{scene}, {}: {} s\n  reference: {}, in doubt by {:.1e} rad (witness: {}): errors below that are not resolved\n",
        study.body, study.end_s, reference.method, reference.doubt_rad, reference.witness,
    );
    let mut table = Table::default();
    let cost = format!("{} (quartiles)", clock::NAME);
    table.row(["error ≤", "method", "setting", "error", "evaluations", "steps", cost.as_str(), ""]);
    let mut last = f64::NAN;
    for level in &study.levels {
        let asked = if level.error_rad == last { String::new() } else { format!("{:.0e}", level.error_rad) };
        last = level.error_rad;
        let mut marks = Vec::new();
        if level.is_auto {
            marks.push("auto");
        }
        let Some(point) = level.point.map(|index| &study.points[index]) else {
            let [method, mark] = [level.method.key().to_owned(), marks.join(", ")];
            let empty = String::new;
            table.row([asked, method, "–".to_owned(), "not reached".to_owned(), empty(), empty(), empty(), mark]);
            continue;
        };
        if point.is_on_front {
            marks.push("front");
        }
        table.row([
            asked,
            level.method.key().to_owned(),
            setting(point),
            error(point, study),
            grouped(point.effort.evaluations),
            grouped(point.effort.steps),
            format!("{} ({}–{})", time(point.cost.median_s), time(point.cost.lower_s), time(point.cost.upper_s)),
            marks.join(", "),
        ]);
    }
    text.push_str(&table.render("  "));
    text
}

fn setting(point: &Point) -> String {
    use crate::scenario::Setting;
    let unit = match point.method.setting() {
        Setting::None => return "–".to_owned(),
        Setting::Tolerance => "rad",
        Setting::Step => "s",
    };
    point.value.map_or_else(|| "–".to_owned(), |value| format!("{value:.1e} {unit}"))
}

fn error(point: &Point, study: &WorkPrecision) -> String {
    let doubt = study.reference.doubt_rad;
    if point.error_rad <= doubt { format!("< {doubt:.1e}") } else { format!("{:.1e}", point.error_rad) }
}

/// With three digits and a unit to match.
pub fn time(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 1e-6 => (s * 1e9, "ns"),
        s if s < 1e-3 => (s * 1e6, "µs"),
        s if s < 1.0 => (s * 1e3, "ms"),
        s => (s, "s"),
    };
    let digits = if value < 10.0 { 2 } else { usize::from(value < 100.0) };
    format!("{value:.digits$} {unit}")
}

/// All of it.
pub fn as_json((scene, bodies): &(String, Vec<WorkPrecision>)) -> Value {
    let body = |study: &WorkPrecision| {
        let point = |point: &Point| {
            json!({
                "method": point.method.key(),
                "setting": point.value,
                "error_rad": point.error_rad,
                "evaluations": point.effort.evaluations,
                "steps": point.effort.steps,
                "rejections": point.effort.rejections,
                "cost_median_s": point.cost.median_s,
                "cost_lower_quartile_s": point.cost.lower_s,
                "cost_upper_quartile_s": point.cost.upper_s,
                "repeats": point.cost.count,
                "on_front": point.is_on_front,
            })
        };
        let level = |level: &crate::study::Level| json!({ "error_rad": level.error_rad, "method": level.method.key(), "auto": level.is_auto, "point": level.point });
        json!({
            "body": study.body,
            "end_s": study.end_s,
            "reference": study.reference.method,
            "reference_witness": study.reference.witness,
            "reference_doubt_rad": study.reference.doubt_rad,
            "picked_by_auto": study.auto.map(crate::scenario::Method::key),
            "clock": clock::NAME,
            "points": study.points.iter().map(point).collect::<Vec<_>>(),
            "levels": study.levels.iter().map(level).collect::<Vec<_>>(),
        })
    };
    json!({ "scene": scene, "bodies": bodies.iter().map(body).collect::<Vec<_>>() })
}
