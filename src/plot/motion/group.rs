use super::envelope::Envelope;
use super::wanted::Wanted;
use crate::plot::{Drawing, Mark, Series, TimeChart};
use crate::telemetry::Channel;

/// Columns of pixels that a curve is thinned to: about as many as there are between a chart's axes.
const COLUMNS: usize = 516;

/// Channels of one unit that share a chart, and its title.
const SHARED: [(&str, &[(Channel, &str)]); 2] = [
    (
        "energy",
        &[
            (Channel::RotationalEnergy, "rotational"),
            (Channel::TranslationalEnergy, "translational"),
            (Channel::PotentialEnergy, "potential"),
            (Channel::TotalEnergy, "total"),
            (Channel::KineticEnergy, "kinetic"),
            (Channel::JacobiIntegral, "Jacobi"),
        ],
    ),
    ("drift, relative", &[(Channel::EnergyDrift, "energy"), (Channel::MomentumDrift, "L"), (Channel::Slip, "slip")]),
];
/// In the order in which they are looked at.
const ORDER: [Channel; 28] = [
    Channel::AngularVelocity,
    Channel::AngularVelocityWorld,
    Channel::AngularMomentumWorld,
    Channel::AngularMomentumBody,
    Channel::Tilt,
    Channel::PrecessionRate,
    Channel::MomentBody,
    Channel::MomentWorld,
    Channel::Position,
    Channel::Velocity,
    Channel::Acceleration,
    Channel::PositionBody,
    Channel::VelocityBody,
    Channel::AccelerationBody,
    Channel::Gyroscope,
    Channel::Accelerometer,
    Channel::ForceWorld,
    Channel::Attitude,
    Channel::FigureAngles,
    Channel::FigureRates,
    Channel::MomentumTilt,
    Channel::PolhodePhase,
    Channel::SeparatrixDistance,
    Channel::KovalevskayaIntegral,
    Channel::EulerZxz,
    Channel::EulerZyz,
    Channel::EulerZyx,
    Channel::EulerXyz,
];
/// A drift of more than so many 1e-15 is looked at by its power of ten.
const LARGE_DRIFT: f64 = 1e4;
/// What changes by less than this part of itself stands still.
const STILL: f64 = 1e-12;

type Curves = [(Channel, Vec<Envelope>)];

/// A chart for each channel or group of channels: those wanted, or else those that tell most.
pub fn charts(curves: &Curves, wanted: &[Wanted], marks: &[Mark], size: (f64, f64)) -> Vec<Drawing> {
    let is_shown = |channel: Channel| {
        let is_told = columns(curves, channel).is_some();
        is_told && if wanted.is_empty() { tells(curves, channel) } else { wanted.contains(&Wanted::Channel(channel)) }
    };
    let vectors = ORDER.into_iter().filter(|channel| is_shown(*channel)).map(|channel| single(curves, channel));
    let mut charts: Vec<TimeChart> = vectors.collect();
    let shared = SHARED.iter().filter_map(|(title, members)| {
        let shown: Vec<_> = members.iter().copied().filter(|(channel, _)| is_shown(*channel)).collect();
        (!shown.is_empty()).then(|| together(curves, title, &shown))
    });
    // After ω and L.
    let place = charts.iter().position(|chart| is_later(&chart.title)).unwrap_or(charts.len());
    charts.splice(place..place, shared.collect::<Vec<_>>());
    for chart in &mut charts {
        chart.marks = marks.to_vec();
    }
    charts.iter().map(|chart| chart.draw(size.0, size.1)).collect()
}

fn is_later(title: &str) -> bool {
    ORDER[4..].iter().any(|channel| channel.row().title == title)
}

fn columns(curves: &Curves, channel: Channel) -> Option<&[Envelope]> {
    curves.iter().find(|(known, _)| *known == channel).map(|(_, columns)| columns.as_slice())
}

/// Whether a channel is worth a chart that nobody asked for.
fn tells(curves: &Curves, channel: Channel) -> bool {
    let has = |channel| columns(curves, channel).is_some();
    match channel {
        Channel::Attitude => curves.len() == 1,
        Channel::AngularVelocityWorld => !has(Channel::AngularVelocity),
        Channel::AngularMomentumBody => !has(Channel::AngularMomentumWorld),
        Channel::MomentWorld => !has(Channel::MomentBody) && !is_zero(curves, channel),
        Channel::MomentBody | Channel::ForceWorld => !is_zero(curves, channel),
        Channel::Position | Channel::Velocity => moves(curves, channel),
        _ => true,
    }
}

fn is_zero(curves: &Curves, channel: Channel) -> bool {
    ranges(curves, channel).iter().all(|range| *range == (0.0, 0.0))
}

fn moves(curves: &Curves, channel: Channel) -> bool {
    ranges(curves, channel).iter().any(|(least, greatest)| greatest - least > STILL * greatest.abs().max(least.abs()))
}

fn ranges(curves: &Curves, channel: Channel) -> Vec<(f64, f64)> {
    columns(curves, channel).unwrap_or_default().iter().filter_map(Envelope::range).collect()
}

fn single(curves: &Curves, channel: Channel) -> TimeChart {
    let row = channel.row();
    let columns = columns(curves, channel).unwrap_or_default().iter().zip(row.components);
    let series = columns.map(|(column, name)| Series::new(*name, column.points(COLUMNS)));
    TimeChart { title: row.title.into(), unit: row.unit.into(), series: series.collect(), ..TimeChart::default() }
}

fn together(curves: &Curves, title: &str, members: &[(Channel, &str)]) -> TimeChart {
    if let [(only, _)] = members {
        let chart = single(curves, *only);
        return by_size(chart, *only);
    }
    let series = members.iter().flat_map(|(channel, name)| {
        let columns = columns(curves, *channel).unwrap_or_default();
        columns.iter().map(|column| Series::new(*name, column.points(COLUMNS)))
    });
    let unit = members[0].0.row().unit;
    let chart = TimeChart { title: title.into(), unit: unit.into(), series: series.collect(), ..TimeChart::default() };
    by_size(chart, members[0].0)
}

/// A drift that is large, by its size on a logarithmic axis.
fn by_size(mut chart: TimeChart, channel: Channel) -> TimeChart {
    let values = || chart.series.iter().flat_map(|series| &series.points).map(|point| point[1].abs());
    if channel.row().unit != "1e-15" || values().fold(0.0, f64::max) <= LARGE_DRIFT {
        return chart;
    }
    for point in chart.series.iter_mut().flat_map(|series| &mut series.points) {
        point[1] = 1e-15 * point[1].abs();
    }
    chart.is_logarithmic = true;
    chart.title = format!("size of the {}", chart.title);
    chart.unit.clear();
    chart
}
