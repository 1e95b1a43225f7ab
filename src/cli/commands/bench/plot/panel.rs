use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::Color;

use super::legend::{self, Entry, Mark};
use super::scale::{Scale, power_of_ten};
use crate::cli::commands::bench::clock;
use crate::scenario::Method;
use crate::study::{Point, WorkPrecision, pareto_front};

/// Okabe and Ito's colours, which the colour-blind tell apart.
const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(80, 80, 80),
];
/// Of all text.
pub const FONT: &str = "sans-serif";
/// Of the legend, pixels.
const LEGEND: i32 = 270;
/// rad; larger errors are left out.
const WORST_SHOWN: f64 = 0.1;
const BAND: ShapeStyle = ShapeStyle { color: RGBAColor(255, 200, 0, 0.55), filled: true, stroke_width: 12 };
const LIMIT: ShapeStyle = ShapeStyle { color: RGBAColor(0, 0, 0, 0.6), filled: false, stroke_width: 1 };
const PICK: ShapeStyle = ShapeStyle { color: RGBAColor(0, 0, 0, 1.0), filled: false, stroke_width: 2 };

/// Whether it could be drawn.
pub type Drawn<B> = Result<(), DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>>;
type Chart<'a, B> =
    ChartContext<'a, B, Cartesian2d<plotters::coord::types::RangedCoordf64, plotters::coord::types::RangedCoordf64>>;

/// Error against cost of every method on one body, both logarithmic; down and to the left is better.
pub fn draw<B: DrawingBackend>(area: &DrawingArea<B, Shift>, scene: &str, study: &WorkPrecision) -> Drawn<B> {
    let scale = Scale::of(study);
    let title = format!("{scene}, {}: {} s, {} outputs", study.body, study.end_s, study.reference.states.len());
    let (width, _) = area.dim_in_pixel();
    let (axes, beside) = area.split_horizontally(i32::try_from(width).unwrap_or(i32::MAX) - LEGEND);
    let mut chart = ChartBuilder::on(&axes)
        .caption(title, (FONT, 26))
        .margin(18)
        .x_label_area_size(64)
        .y_label_area_size(92)
        .build_cartesian_2d(scale.errors.clone(), scale.costs.clone())?;
    chart
        .configure_mesh()
        .light_line_style(WHITE)
        .bold_line_style(BLACK.mix(0.12))
        .x_labels(20)
        .y_labels(12)
        .x_label_formatter(&power_of_ten)
        .y_label_formatter(&power_of_ten)
        .x_desc("attitude error, largest over the run, rad")
        .y_desc(format!("{} of set-up and all outputs, s", clock::NAME))
        .label_style((FONT, 18))
        .axis_desc_style((FONT, 20))
        .draw()?;
    resolution(&mut chart, &scale)?;
    front(&mut chart, &scale, study)?;
    let mut entries = Vec::new();
    for (index, method) in methods(study).into_iter().enumerate() {
        let points: Vec<&Point> = drawn(study).filter(|point| point.method == method).collect();
        let style = COLOURS[index % COLOURS.len()].stroke_width(2);
        curve(&mut chart, &scale, study, &points, style)?;
        entries.push(Entry { label: method.key().to_owned(), mark: Mark::Line(style.stroke_width(4)) });
    }
    picks(&mut chart, &scale, study)?;
    entries.extend([
        Entry { label: "Pareto front of all".to_owned(), mark: Mark::Line(BAND) },
        Entry { label: "cheapest that auto takes".to_owned(), mark: Mark::Ring(PICK) },
        Entry { label: "least error resolved".to_owned(), mark: Mark::Dashed(LIMIT) },
    ]);
    legend::draw(&beside, &entries)
}

/// What is worth showing: an error of more than that is no result.
fn drawn(study: &WorkPrecision) -> impl Iterator<Item = &Point> {
    study.points.iter().filter(|point| point.error_rad <= WORST_SHOWN)
}

fn methods(study: &WorkPrecision) -> Vec<Method> {
    Method::ALL.into_iter().filter(|method| drawn(study).any(|point| point.method == *method)).collect()
}

/// A dashed line where the reference ends.
fn resolution<B: DrawingBackend>(chart: &mut Chart<'_, B>, scale: &Scale) -> Drawn<B> {
    let ends = [(scale.floor, scale.costs.start), (scale.floor, scale.costs.end)];
    chart.draw_series(DashedLineSeries::new(ends, 6, 5, LIMIT))?;
    Ok(())
}

/// A ring round the cheapest point of what `auto` takes for each error asked for.
fn picks<B: DrawingBackend>(chart: &mut Chart<'_, B>, scale: &Scale, study: &WorkPrecision) -> Drawn<B> {
    let picked = study.levels.iter().filter(|level| level.is_auto).filter_map(|level| level.point);
    let places: Vec<_> = picked.map(|index| scale.place(&study.points[index])).collect();
    chart.draw_series(places.into_iter().map(|place| Circle::new(place, 9, PICK)))?;
    Ok(())
}

/// What nothing beats, as a broad pale line under everything.
fn front<B: DrawingBackend>(chart: &mut Chart<'_, B>, scale: &Scale, study: &WorkPrecision) -> Drawn<B> {
    let mut best: Vec<(f64, f64)> =
        drawn(study).filter(|point| point.is_on_front).map(|point| scale.place(point)).collect();
    best.sort_by(|a, b| a.0.total_cmp(&b.0));
    // A front of one point is a front all the same.
    chart.draw_series(best.iter().map(|place| Circle::new(*place, 10, BAND)))?;
    chart.draw_series(LineSeries::new(best, BAND))?;
    Ok(())
}

/// One method: its own front as a line, all its points, the quartiles of their costs.
fn curve<B: DrawingBackend>(
    chart: &mut Chart<'_, B>,
    scale: &Scale,
    study: &WorkPrecision,
    points: &[&Point],
    style: ShapeStyle,
) -> Drawn<B> {
    let pairs: Vec<_> = points.iter().map(|point| (point.error_rad, point.cost.median_s)).collect();
    let mut own: Vec<(f64, f64)> = pareto_front(&pairs, study.reference.doubt_rad)
        .into_iter()
        .zip(points)
        .filter(|(is_on_front, _)| *is_on_front)
        .map(|(_, point)| scale.place(point))
        .collect();
    own.sort_by(|a, b| a.0.total_cmp(&b.0));
    chart.draw_series(LineSeries::new(own, style))?;
    chart.draw_series(points.iter().map(|point| {
        let error = scale.place(point).0;
        let ends = [(error, point.cost.lower_s.log10()), (error, point.cost.upper_s.log10())];
        PathElement::new(ends, style.stroke_width(1))
    }))?;
    chart.draw_series(points.iter().map(|point| Circle::new(scale.place(point), 4, style.filled())))?;
    Ok(())
}
