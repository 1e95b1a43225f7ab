use super::{Drawing, Limit, Series, TimeChart, grid};
use crate::comparison::{BodyReport, ChannelReport, Report};

/// How far two motions are apart over time: a panel for each channel that differs, worst first, with the limit that it
/// is held to.
#[must_use]
pub fn differences(report: &Report) -> Drawing {
    let mut channels: Vec<_> = report.channels().filter(|(_, channel)| channel.worst_difference() > 0.0).collect();
    channels.sort_by(|one, other| other.1.severity().total_cmp(&one.1.severity()));
    let [a, b] = &report.sides;
    let title = format!("{} and {}", a.name, b.name);
    let columns = if channels.len() > 1 { 2 } else { 1 };
    let panels = channels.into_iter().map(|(body, channel)| panel(body, channel)).collect();
    grid(&title, &[report.verdict()], panels, columns)
}

fn panel(body: &BodyReport, channel: &ChannelReport) -> Drawing {
    let growth = channel.growth.as_ref().map(crate::comparison::Growth::in_words).unwrap_or_default();
    // What is infinite, as beside a NaN, has no place.
    let finite = |(time_s, value): (f64, f64)| [time_s, if value.is_finite() { value } else { f64::NAN }];
    let limit = channel.limit.filter(|limit| *limit > 0.0);
    TimeChart {
        title: format!("{} of {}", channel.channel.row().name, body.name()),
        unit: channel.unit().to_owned(),
        series: vec![Series::new(growth, channel.trace.points().map(finite).collect())],
        limits: limit.map(|value| Limit { label: "limit".into(), value }).into_iter().collect(),
        is_logarithmic: true,
        ..TimeChart::default()
    }
    .draw(560.0, 240.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::comparison::{Comparison, Side};
    use crate::plot::Surroundings;
    use crate::scenario::{BodySpec, Plan, Scenario};

    #[test]
    fn each_channel_that_differs_has_a_panel_with_its_limit() {
        let plan = |rate: f64| {
            let body = BodySpec {
                principal_moments_kg_m2: Some([1.0, 2.0, 3.0]),
                angular_velocity_rad_s: Some([0.0, 0.0, rate]),
                ..BodySpec::default()
            };
            let channels = Some(vec!["attitude".into(), "angular_velocity".into()]);
            let times = (Some(1.0), Some(0.01));
            Plan::new(&Scenario {
                duration_s: times.0,
                sample_every_s: times.1,
                body: vec![body],
                channels,
                ..Scenario::default()
            })
            .expect("a plan")
        };
        let (a, b) = (plan(1.0), plan(1.0 + 1e-6));
        let report = Comparison::default().run(Side::Scene(&a), Side::Scene(&b)).expect("times in common");
        let svg = differences(&report).svg(Surroundings::Paper);
        assert!(svg.contains("angular_velocity of body, rad/s") && svg.contains("stays bounded"), "{svg}");
        assert!(svg.contains("attitude of body, rad") && svg.contains("grows as t^1.0"), "{svg}");
        assert!(svg.contains("differs: angular_velocity of body leaves 1.0e-9 rad/s at 0 s (and 1 more)"), "{svg}");
        let same = Comparison::default().run(Side::Scene(&a), Side::Scene(&a)).expect("times in common");
        assert!(differences(&same).svg(Surroundings::Paper).contains("same to the bit"));
    }
}
