use super::Page;
use crate::plot::svg::escaped;
use crate::plot::{Drawing, Surroundings, exactness, figure as number, grouped, plain_time};
use crate::recording::RecordedBody;
use crate::scenario::{CheckOutcome, EventKind, PlannedBody, Provenance};

/// A drawing in the page, with words under it.
pub fn figure(drawing: &Drawing, caption: Option<&str>) -> String {
    let caption = caption.map(|text| format!("<figcaption>{}</figcaption>\n", escaped(text))).unwrap_or_default();
    format!("<figure>\n{}{caption}</figure>\n", drawing.svg(Surroundings::Page))
}

/// Whether the motion is what it should be, and how exact: first of all.
pub fn verdicts(page: &Page<'_>) -> String {
    let outcomes = page.plan.map(|plan| plan.outcomes.as_slice()).unwrap_or_default();
    let told: Vec<&str> = page
        .heading
        .provenance
        .iter()
        .filter(|(name, _)| name.starts_with("check."))
        .map(|(_, words)| words.as_str())
        .collect();
    let mut text = "<section>\n<div class=\"cards\">\n".to_owned();
    text += &card(&checks_card(outcomes, &told), "checks against numbers from elsewhere");
    for body in &page.heading.bodies {
        text += &exactness_card(page, body);
    }
    text += "</div>\n";
    if !outcomes.is_empty() {
        text += "<h3>Checks</h3>\n<div class=\"wide\"><table class=\"checks\">\n<tr><th></th><th>what</th><th>found</th><th>expected</th>\
                 <th>tolerance</th><th>unit</th></tr>\n";
        text.extend(outcomes.iter().map(check));
        text += "</table></div>\n";
    } else if !told.is_empty() {
        text += "<h3>Checks</h3>\n<ul>\n";
        text.extend(told.iter().map(|words| format!("<li>{}</li>\n", escaped(words))));
        text += "</ul>\n";
    }
    for body in page.heading.bodies.iter().filter(|body| !body.certificate.is_empty()) {
        text.extend([format!("<h3>Certificate of {}</h3>\n", escaped(&body.name))]);
        text += &table(body.certificate.iter().map(|(name, value)| (name.as_str(), value.as_str())));
    }
    text + "</section>\n"
}

fn card(verdict: &str, words: &str) -> String {
    format!("<div class=\"card\">{verdict}<span class=\"faint\">{}</span></div>\n", escaped(words))
}

fn checks_card(outcomes: &[CheckOutcome], told: &[&str]) -> String {
    let (passed, all) = if outcomes.is_empty() {
        (told.iter().filter(|words| words.ends_with(": passed")).count(), told.len())
    } else {
        (outcomes.iter().filter(|check| check.passed).count(), outcomes.len())
    };
    match all {
        0 => "<b>No checks</b>".to_owned(),
        _ if passed == all => format!("<b class=\"good\">✓ {passed} of {all} passed</b>"),
        _ => format!("<b class=\"bad\">✗ {} of {all} failed</b>", all - passed),
    }
}

fn exactness_card(page: &Page<'_>, body: &RecordedBody) -> String {
    let planned = page.plan.and_then(|plan| plan.bodies.iter().find(|planned| planned.name == body.name));
    let tolerance = page.plan.and_then(|plan| plan.tolerance_rad);
    let certificate = planned.and_then(|planned| planned.certificate.as_ref());
    let class = match (certificate, tolerance) {
        (Some(certificate), Some(tolerance)) if !certificate.keeps(tolerance) => "bad",
        (Some(certificate), _) if !certificate.is_whole => "bad",
        _ => "good",
    };
    let verdict = exactness(body).map_or_else(
        || "<b>Not certified</b>".to_owned(),
        |words| format!("<b class=\"{class}\">{}</b>", escaped(&words)),
    );
    let asked = tolerance.map(|rad| format!("; asked for: {} rad", number(rad))).unwrap_or_default();
    card(&verdict, &format!("how exact the recording of {} is{asked}", body.name))
}

fn check(check: &CheckOutcome) -> String {
    let CheckOutcome { name, expected, measured, tolerance, unit, passed, .. } = check;
    let verdict = if *passed { "<td class=\"good\">✓ passed</td>" } else { "<td class=\"bad\">✗ failed</td>" };
    format!(
        "<tr>{verdict}<td>{}</td><td class=\"number\">{measured:?}</td><td class=\"number\">{expected:?}</td>\
         <td class=\"number\">{tolerance:e}</td><td>{}</td></tr>\n",
        escaped(name),
        escaped(unit)
    )
}

/// By which method, why, and when samples were taken.
pub fn making(page: &Page<'_>) -> String {
    let sampling = page.sampling;
    let when = sampling.interval_s.map_or_else(
        || "at times of their own".to_owned(),
        |interval| format!("every {interval} s: sample n is at n times that, rounded once"),
    );
    let times = format!("{} to {} s", plain_time(sampling.from_s), plain_time(sampling.to_s));
    let mut rows = vec![("samples".to_owned(), format!("{}, {times}, {when}", grouped(sampling.samples)))];
    for body in &page.heading.bodies {
        let fact = |what: &str| page.heading.fact(&format!("body.{}.{what}", body.name));
        if let Some(method) = fact("method") {
            let reason = fact("reason").map(|reason| format!(": {reason}")).unwrap_or_default();
            rows.push((format!("method, {}", body.name), format!("{method}{reason}")));
        }
        let planned = page.plan.and_then(|plan| plan.bodies.iter().find(|planned| planned.name == body.name));
        rows.extend(planned.map(|planned| (format!("body, {}", body.name), mass(planned))));
        let channels: Vec<_> = body.channels.iter().map(|channel| channel.row().name).collect();
        rows.push((format!("recorded, {}", body.name), channels.join(", ")));
    }
    let events = page.plan.map(|plan| plan.events.as_slice()).unwrap_or_default();
    let happened = events.iter().filter(|event| matches!(event.kind, EventKind::Load | EventKind::Flip));
    rows.extend(happened.map(|event| (format!("at {} s", plain_time(event.time_s)), event.text.clone())));
    let rows = rows.iter().map(|(name, value)| (name.as_str(), value.as_str()));
    format!("<section>\n<h2>How it was made</h2>\n{}</section>\n", table(rows))
}

fn mass(body: &PlannedBody) -> String {
    let [a, b, c] = body.properties.moments.vector().map(number).into();
    let mass = body.properties.mass.map(|mass| format!("{} kg, ", number(mass))).unwrap_or_default();
    format!("{mass}principal moments {a}, {b}, {c} kg m²")
}

/// What the recording says of itself; what stands elsewhere on the page is not repeated.
pub fn provenance(page: &Page<'_>) -> String {
    let is_elsewhere = |name: &str| name.starts_with("check.") || name.starts_with("body.") || name == "title";
    let told = page.heading.provenance.iter().filter(|(name, _)| !is_elsewhere(name));
    let facts: Vec<_> = told.map(|(name, value)| (name.as_str(), value.as_str())).collect();
    let sources: Vec<(&str, &str)> = page.plan.map(|plan| sources(&plan.provenance)).unwrap_or_default();
    if facts.is_empty() && sources.is_empty() {
        let words = "<p>The file says nothing of its making: a table holds columns only.</p>\n";
        return format!("<section>\n<h2>Provenance</h2>\n{words}</section>\n");
    }
    format!("<section>\n<h2>Provenance</h2>\n{}</section>\n", table(sources.into_iter().chain(facts)))
}

/// Where the scene's numbers come from; addresses are words here, for a page that loads nothing.
fn sources(provenance: &Provenance) -> Vec<(&str, &str)> {
    let rows = [("numbers from", &provenance.source), ("read at", &provenance.url), ("note", &provenance.note)];
    rows.into_iter().filter(|(_, value)| !value.is_empty()).map(|(name, value)| (name, value.as_str())).collect()
}

/// How to get it again, and the scene that it takes.
pub fn reproduction(page: &Page<'_>) -> String {
    let mut text = "<section>\n<h2>Get it again</h2>\n".to_owned();
    if !page.commands.is_empty() {
        let lines: Vec<_> = page.commands.iter().map(|line| escaped(line)).collect();
        text.extend([format!("<pre><code>{}</code></pre>\n", lines.join("\n"))]);
    }
    if let Some(digest) = page.heading.fact("identity_sha256") {
        text.extend([format!(
            "<p class=\"faint\">Recordings with the same identity hold the same motion: SHA-256 <code>{}</code></p>\n",
            escaped(digest)
        )]);
    }
    if let Some(scene) = &page.heading.scene {
        text.extend([format!(
            "<details><summary>The scene, as it was run</summary>\n<pre><code>{}</code></pre>\n</details>\n",
            escaped(scene)
        )]);
    }
    text + "</section>\n"
}

fn table<'a>(rows: impl Iterator<Item = (&'a str, &'a str)>) -> String {
    let rows = rows.map(|(name, value)| {
        let lines: Vec<_> = value.lines().map(escaped).collect();
        format!("<tr><th>{}</th><td>{}</td></tr>\n", escaped(name), lines.join("<br>"))
    });
    format!("<div class=\"wide\"><table>\n{}</table></div>\n", rows.collect::<String>())
}
