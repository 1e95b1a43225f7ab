use crate::plot::{Anchor, Axes, Dash, Drawing, Entry, Fill, Ink, Line, Rectangle, Scale, Sign, grid, legend};
use crate::scenario::Method;
use crate::study::{Point, WorkPrecision, pareto_front};

use super::clock;
use super::execute::Studies;

/// Of one panel, pixels.
const PANEL: (f64, f64) = (860.0, 470.0);
/// Of its axes.
const FRAME: Rectangle = Rectangle { left: 78.0, top: 40.0, width: 540.0, height: 370.0 };
/// rad; larger errors are left out.
const WORST_SHOWN: f64 = 0.1;
const BAND: Line = Line { ink: Ink::Given([255, 200, 0]), width: 9.0, opacity: 0.55, dash: Dash::Solid };
const LIMIT: Line = Line { ink: Ink::Text, width: 1.0, opacity: 0.7, dash: Dash::Dashed };
const PICK: Line = Line::new(Ink::Text, 1.4);

/// A panel for each body of each scene: error against cost of every method, both logarithmic; down and to the left is
/// better.
pub fn draw(studies: &Studies) -> Drawing {
    let panels = studies.iter().flat_map(|(scene, bodies)| bodies.iter().map(|study| panel(scene, study)));
    let panels: Vec<Drawing> = panels.collect();
    let columns = if panels.len() > 1 { 2 } else { 1 };
    grid("", &[], panels, columns)
}

fn panel(scene: &str, study: &WorkPrecision) -> Drawing {
    let mut sheet = Drawing::new(PANEL.0, PANEL.1);
    let floor = study.reference.doubt_rad.max(1e-16);
    let axes = axes(study, floor);
    let title = format!("{scene}, {}: {} s, {} outputs", study.body, study.end_s, study.reference.states.len());
    sheet.text([FRAME.left, 24.0], Anchor::Start, 16.0, Ink::Text, title);
    let cost = format!("{} of set-up and all outputs, s", clock::NAME);
    axes.draw(&mut sheet, "attitude error, largest over the run, rad", &cost);
    axes.mark(&mut sheet, floor, LIMIT);
    // An error that the reference does not resolve is drawn at what it resolves.
    let place = |point: &Point| [point.error_rad.max(floor), point.cost.median_s];
    front(&mut sheet, &axes, study, &place);
    let mut entries = Vec::new();
    for (index, method) in methods(study).into_iter().enumerate() {
        let points: Vec<&Point> = drawn(study).filter(|point| point.method == method).collect();
        curve(&mut sheet, &axes, study, &points, &place, Ink::Series(index));
        entries.push(Entry::line(method.key(), Line::new(Ink::Series(index), 3.0)));
    }
    let picked = study.levels.iter().filter(|level| level.is_auto).filter_map(|level| level.point);
    for index in picked {
        sheet.circle(axes.place(place(&study.points[index])), 7.0, None, Some(PICK));
    }
    entries.extend([
        Entry::line("Pareto front of all", BAND),
        Entry { label: "cheapest that auto takes".to_owned(), sign: Sign::Ring(PICK) },
        Entry::line("least error resolved", LIMIT),
    ]);
    legend(&mut sheet, [FRAME.right() + 24.0, FRAME.top + 14.0], &entries);
    sheet
}

fn axes(study: &WorkPrecision, floor: f64) -> Axes {
    let costs = || study.points.iter().map(|point| point.cost.median_s);
    let (cheapest, dearest) = (costs().fold(1e-5, f64::min), costs().fold(0.0, f64::max));
    let across = Scale::logarithmic(floor, 1.0, 8);
    Axes { frame: FRAME, across, up: Scale::logarithmic(cheapest / 2.0, dearest.max(10.0 * cheapest) * 1.6, 8) }
}

/// What is worth showing: an error of more than that is no result.
fn drawn(study: &WorkPrecision) -> impl Iterator<Item = &Point> {
    study.points.iter().filter(|point| point.error_rad <= WORST_SHOWN)
}

fn methods(study: &WorkPrecision) -> Vec<Method> {
    Method::ALL.into_iter().filter(|method| drawn(study).any(|point| point.method == *method)).collect()
}

/// What nothing beats, as a broad pale line under everything.
fn front(sheet: &mut Drawing, axes: &Axes, study: &WorkPrecision, place: &dyn Fn(&Point) -> [f64; 2]) {
    let mut best: Vec<_> = drawn(study).filter(|point| point.is_on_front).map(place).collect();
    best.sort_by(|a, b| a[0].total_cmp(&b[0]));
    // A front of one point is a front all the same.
    for point in &best {
        let fill = Fill { ink: BAND.ink, opacity: BAND.opacity };
        sheet.circle(axes.place(*point), 8.0, Some(fill), None);
    }
    axes.curve(sheet, best.into_iter(), BAND);
}

/// One method: its own front as a line, all its points, the quartiles of their costs.
fn curve(
    sheet: &mut Drawing,
    axes: &Axes,
    study: &WorkPrecision,
    points: &[&Point],
    place: &dyn Fn(&Point) -> [f64; 2],
    ink: Ink,
) {
    let pairs: Vec<_> = points.iter().map(|point| (point.error_rad, point.cost.median_s)).collect();
    let is_on_front = pareto_front(&pairs, study.reference.doubt_rad);
    let mut own: Vec<_> = is_on_front.into_iter().zip(points).filter(|(is_on_front, _)| *is_on_front).collect();
    own.sort_by(|a, b| a.1.error_rad.total_cmp(&b.1.error_rad));
    axes.curve(sheet, own.iter().map(|(_, point)| place(point)), Line::new(ink, 1.6));
    for point in points {
        let [error, _] = place(point);
        let ends = [[error, point.cost.lower_s], [error, point.cost.upper_s]];
        axes.curve(sheet, ends.into_iter(), Line::new(ink, 1.0));
        sheet.circle(axes.place(place(point)), 3.0, Some(Fill::new(ink)), None);
    }
}
