use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::Color;

use super::scale::{Scale, power_of_ten};
use crate::cli::bench::clock;
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
const FONT: &str = "sans-serif";

type Drawn<B> = Result<(), DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>>;
type Chart<'a, B> =
    ChartContext<'a, B, Cartesian2d<plotters::coord::types::RangedCoordf64, plotters::coord::types::RangedCoordf64>>;

/// Error against cost of every method on one body, both logarithmic; down and to the left is better.
pub fn draw<B: DrawingBackend>(area: &DrawingArea<B, Shift>, scene: &str, study: &WorkPrecision) -> Drawn<B> {
    let scale = Scale::of(study);
    let title = format!("{scene}, {}: {} s, {} outputs", study.body, study.end_s, study.reference.states.len());
    let mut chart = ChartBuilder::on(area)
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
    resolution(&mut chart, &scale, study)?;
    front(&mut chart, &scale, study)?;
    for (index, method) in methods(study).into_iter().enumerate() {
        let points: Vec<&Point> = study.points.iter().filter(|point| point.method == method).collect();
        let is_auto = study.auto == Some(method);
        curve(&mut chart, &scale, study, &points, (COLOURS[index % COLOURS.len()], is_auto))?;
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .label_font((FONT, 18))
        .background_style(WHITE.mix(0.9))
        .border_style(BLACK.mix(0.3))
        .margin(12)
        .draw()?;
    Ok(())
}

fn methods(study: &WorkPrecision) -> Vec<Method> {
    Method::ALL.into_iter().filter(|method| study.points.iter().any(|point| point.method == *method)).collect()
}

/// A dashed line where the reference ends.
fn resolution<B: DrawingBackend>(chart: &mut Chart<'_, B>, scale: &Scale, study: &WorkPrecision) -> Drawn<B> {
    let ends = [(scale.floor, scale.costs.start), (scale.floor, scale.costs.end)];
    let style = BLACK.mix(0.6).stroke_width(1);
    let name = format!("reference ({}) resolves no less", study.reference.method.key());
    chart
        .draw_series(DashedLineSeries::new(ends, 6, 5, style))?
        .label(name)
        .legend(move |(x, y)| PathElement::new([(x, y), (x + 26, y)], BLACK.mix(0.6)));
    Ok(())
}

/// What nothing beats, as a broad pale line under everything.
fn front<B: DrawingBackend>(chart: &mut Chart<'_, B>, scale: &Scale, study: &WorkPrecision) -> Drawn<B> {
    let mut best: Vec<(f64, f64)> =
        study.points.iter().filter(|point| point.is_on_front).map(|point| scale.place(point)).collect();
    best.sort_by(|a, b| a.0.total_cmp(&b.0));
    let style = RGBColor(255, 200, 0).mix(0.55);
    // A front of one point is a front all the same.
    chart.draw_series(best.iter().map(|place| Circle::new(*place, 10, style.filled())))?;
    chart
        .draw_series(LineSeries::new(best, style.stroke_width(12)))?
        .label("Pareto front of all")
        .legend(move |(x, y)| PathElement::new([(x, y), (x + 26, y)], style.stroke_width(10)));
    Ok(())
}

/// One method: its own front as a line, all its points, the quartiles of their costs.
fn curve<B: DrawingBackend>(
    chart: &mut Chart<'_, B>,
    scale: &Scale,
    study: &WorkPrecision,
    points: &[&Point],
    (colour, is_auto): (RGBColor, bool),
) -> Drawn<B> {
    let pairs: Vec<_> = points.iter().map(|point| (point.error_rad, point.cost.median_s)).collect();
    let mut own: Vec<(f64, f64)> = pareto_front(&pairs, study.reference.doubt_rad)
        .into_iter()
        .zip(points)
        .filter(|(is_on_front, _)| *is_on_front)
        .map(|(_, point)| scale.place(point))
        .collect();
    own.sort_by(|a, b| a.0.total_cmp(&b.0));
    let name = points.first().map_or("", |point| point.method.key());
    let name = if is_auto { format!("{name} (auto picks it)") } else { name.to_owned() };
    let width = if is_auto { 3 } else { 2 };
    chart
        .draw_series(LineSeries::new(own, colour.stroke_width(width)))?
        .label(name)
        .legend(move |(x, y)| PathElement::new([(x, y), (x + 26, y)], colour.stroke_width(width + 1)));
    chart.draw_series(points.iter().map(|point| {
        let error = scale.place(point).0;
        let ends = [(error, point.cost.lower_s.log10()), (error, point.cost.upper_s.log10())];
        PathElement::new(ends, colour.stroke_width(1))
    }))?;
    let size = if is_auto { 5 } else { 4 };
    chart.draw_series(points.iter().map(|point| Circle::new(scale.place(point), size, colour.filled())))?;
    Ok(())
}
