use super::scale::figure;
use crate::recording::{Heading, RecordedBody, Sampling};

/// Lines that stand over plots: how many samples, by which method, how exact.
#[must_use]
pub fn words(heading: &Heading, sampling: Sampling, tolerance_rad: Option<f64>) -> Vec<String> {
    let times = format!("{} to {} s", plain_time(sampling.from_s), plain_time(sampling.to_s));
    let tolerance = tolerance_rad.map(|rad| format!(", tolerance {} rad", figure(rad))).unwrap_or_default();
    let mut lines = vec![format!("{} samples, {times}{tolerance}", grouped(sampling.samples))];
    for body in &heading.bodies {
        let method = heading.fact(&format!("body.{}.method", body.name));
        let certificate = exactness(body);
        let parts: Vec<String> = method.map(str::to_owned).into_iter().chain(certificate).collect();
        match heading.bodies.as_slice() {
            _ if parts.is_empty() => {}
            [_] => lines[0] = format!("{}; {}", lines[0], parts.join("; ")),
            _ => lines.push(format!("{}: {}", body.name, parts.join("; "))),
        }
    }
    // Few enough to leave room for the plots; the recording has them all.
    lines.truncate(6);
    lines
}

/// How far a body's recorded motion is from the exact one, if it was measured.
#[must_use]
pub fn exactness(body: &RecordedBody) -> Option<String> {
    let fact = |name: &str| body.certificate.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str());
    let number = |name: &str| fact(name).and_then(|value| value.parse::<f64>().ok());
    let error = match (number("attitude_error_rad"), number("angular_velocity_error_relative")) {
        (Some(error), _) => format!("attitude exact within {} rad", figure(error)),
        (None, Some(error)) => format!("ω exact within {} of its largest", figure(error)),
        (None, None) => return None,
    };
    let reach = match (fact("covers_the_whole_run"), number("covered_to_s")) {
        (Some("true"), _) => "over the whole run".to_owned(),
        (_, Some(to)) => format!("to {} s only", plain_time(to)),
        _ => "for an unknown time".to_owned(),
    };
    Some(format!("{error} {reach}, as measured"))
}

/// A time without the noise of its making: 0.3, not 0.30000000000000004.
#[must_use]
pub fn plain_time(time_s: f64) -> String {
    let text = format!("{time_s:.9}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// `1234567` as `1,234,567`.
#[must_use]
pub fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_plain() {
        assert_eq!([plain_time(0.1 + 0.2), plain_time(20.0), plain_time(0.0)], ["0.3", "20", "0"]);
    }

    #[test]
    fn a_certificate_is_told_with_its_reach() {
        let facts = [("attitude_error_rad", "4.100e-16"), ("covers_the_whole_run", "false"), ("covered_to_s", "12.5")];
        let certificate = facts.map(|(name, value)| (name.to_owned(), value.to_owned())).to_vec();
        let body = RecordedBody { certificate, ..RecordedBody::default() };
        assert_eq!(
            exactness(&body).expect("it was measured"),
            "attitude exact within 4.1·10⁻¹⁶ rad to 12.5 s only, as measured"
        );
        assert_eq!(exactness(&RecordedBody::default()), None);
    }
}
