use nalgebra::Vector3;

use super::globe::{Ellipsoid, View};
use super::trail::Trail;
use crate::body::MassProperties;
use crate::plot::simplify::simplified;
use crate::plot::{Anchor, Dash, Drawing, Entry, Fill, Ink, Line, Point, Sign, figure, text_width};

/// Of a figure, pixels.
pub const FIGURE: (f64, f64) = (600.0, 440.0);
/// Where the middle of a globe is, and half of what there is room for.
const CENTRE: Point = [300.0, 240.0];
const ROOM: [f64; 2] = [195.0, 150.0];

const OUTLINE: Line = Line::new(Ink::Faint, 1.2);
const GRATICULE: Line = Line { ink: Ink::Faint, width: 0.8, opacity: 0.45, dash: Dash::Solid };
const SEPARATRIX: Line = Line { ink: Ink::Series(3), width: 1.1, opacity: 0.9, dash: Dash::Solid };
const CURVE: Line = Line::new(Ink::Series(0), 2.0);
const START: Ink = Ink::Series(1);
const AXIS: Line = Line::new(Ink::Text, 1.3);

/// The path of ω, whose directions in body axes are `directions`, on the ellipsoid of inertia.
pub fn polhode(directions: &Trail, properties: &MassProperties, is_free: Option<bool>) -> Option<Drawing> {
    let moments = properties.moments.vector();
    let ellipsoid = Ellipsoid::new(moments)?;
    let to_principal = properties.body_from_principal.inverse();
    let place = |direction: &Vector3<f64>| ellipsoid.point(&(to_principal * direction));
    let start = place(&directions.first()?);
    let strokes: Vec<Vec<_>> = directions.strokes().iter().map(|part| part.iter().map(place).collect()).collect();
    let order = ellipsoid.order();
    let view = view(order, &strokes, &start)?;
    let is_aligned = properties.body_from_principal.angle() == 0.0;
    let labels = [0, 1, 2].map(|axis| {
        let rank = order.iter().position(|other| *other == axis).unwrap_or(axis);
        let name = if is_aligned { ["x", "y", "z"][axis] } else { ["1", "2", "3"][rank] };
        format!("{name}: I = {}", figure(moments[axis]))
    });
    let title = match is_free {
        Some(true) => "polhode: ω on the energy ellipsoid",
        _ => "polhode: ω, scaled to √(2T) = 1, on the ellipsoid of inertia",
    };
    let drawn = directions.full_at_s().map(|time| format!(", drawn to {time:.0} s")).unwrap_or_default();
    let words = format!("fixed in the body; principal axes with moments in kg m²; the dot is the start{drawn}");
    let globe = Globe { ellipsoid, view, labels, title: title.into(), words };
    Some(globe.draw(&strokes, &start, "ω"))
}

/// The path of a body's axis on the unit sphere of the world.
pub fn axis_path(path: &Trail, axis: &Vector3<f64>) -> Option<Drawing> {
    let start = path.first()?;
    let mean = path.strokes().iter().flatten().fold(start, |sum, point| sum + point);
    let towards = Vector3::new(side(mean.x, 0.75), side(mean.y, 0.45), side(mean.z, 0.42));
    let view = View::new(&towards, &Vector3::z())?;
    let letter = ["x", "y", "z"][axis.iamax()];
    let name = if axis.amax() == 1.0 {
        format!("path of the body's {letter} axis")
    } else {
        format!("path of the body's axis nearest to {letter}")
    };
    let drawn = path.full_at_s().map(|time| format!(", drawn to {time:.0} s")).unwrap_or_default();
    let globe = Globe {
        ellipsoid: Ellipsoid::sphere(),
        view,
        labels: ["x", "y", "z"].map(str::to_owned),
        title: format!("{name}, seen in the world"),
        words: format!("its tip on the unit sphere, world axes; the dot is the start{drawn}"),
    };
    Some(globe.draw(path.strokes(), &start, "axis"))
}

/// `size` with the sign of `like`.
fn side(like: f64, size: f64) -> f64 {
    if like < 0.0 { -size } else { size }
}

/// From where a polhode is seen best: the axis of the greatest moment upwards, the curve on the near side.
fn view(order: [usize; 3], strokes: &[Vec<Vector3<f64>>], start: &Vector3<f64>) -> Option<View> {
    let mean = strokes.iter().flatten().fold(*start, |sum, point| sum + point);
    let mut towards = Vector3::zeros();
    for (axis, size) in order.into_iter().zip([0.62, 0.6, 0.5]) {
        towards[axis] = side(mean[axis], size);
    }
    View::new(&towards, &Vector3::ith(order[2], 1.0))
}

/// An ellipsoid with its axes, and a curve on it.
struct Globe {
    ellipsoid: Ellipsoid,
    view: View,
    /// Of the axes.
    labels: [String; 3],
    title: String,
    words: String,
}

impl Globe {
    fn draw(&self, strokes: &[Vec<Vector3<f64>>], start: &Vector3<f64>, name: &str) -> Drawing {
        let mut sheet = Drawing::new(FIGURE.0, FIGURE.1);
        sheet.text([20.0, 20.0], Anchor::Start, 14.0, Ink::Text, self.title.clone());
        sheet.text([20.0, 40.0], Anchor::Start, 12.5, Ink::Faint, self.words.clone());
        let silhouette = self.ellipsoid.silhouette(&self.view);
        let reach =
            |axis: usize| silhouette.iter().map(|point| self.view.project(point)[axis].abs()).fold(0.0, f64::max);
        let scale = (ROOM[0] / reach(0)).min(ROOM[1] / reach(1));
        let separatrices = self.ellipsoid.separatrices();
        let curves = |sheet: &mut Drawing, is_seen: bool| {
            for equator in self.ellipsoid.equators() {
                self.curve(sheet, scale, &[equator], is_seen, GRATICULE);
            }
            self.curve(sheet, scale, &separatrices, is_seen, SEPARATRIX);
            self.curve(sheet, scale, strokes, is_seen, CURVE);
            self.axes(sheet, scale, is_seen);
            self.dot(sheet, scale, start, is_seen);
        };
        curves(&mut sheet, false);
        let outline: Vec<Point> = silhouette.iter().map(|point| self.place(scale, point)).collect();
        sheet.area(outline, Some(Fill { ink: Ink::Series(5), opacity: 0.1 }), Some(OUTLINE));
        curves(&mut sheet, true);
        let mut entries = if strokes.is_empty() {
            vec![Entry { label: format!("{name}, which stays there"), sign: Sign::Dot(Fill::new(START)) }]
        } else {
            vec![Entry::line(name, CURVE), Entry::line(format!("{name} behind"), behind(CURVE))]
        };
        if !separatrices.is_empty() {
            entries.push(Entry::line("separatrix", SEPARATRIX));
        }
        let width: f64 = entries.iter().map(Entry::width).sum();
        let mut x = CENTRE[0] - 0.5 * width;
        for entry in entries {
            entry.draw(&mut sheet, [x, FIGURE.1 - 8.0]);
            x += entry.width();
        }
        sheet
    }

    fn place(&self, scale: f64, point: &Vector3<f64>) -> Point {
        let [right, up] = self.view.project(point);
        [CENTRE[0] + scale * right, CENTRE[1] - scale * up]
    }

    /// The parts of curves on the surface that are seen, or those that are not.
    fn curve(&self, sheet: &mut Drawing, scale: f64, strokes: &[Vec<Vector3<f64>>], is_seen: bool, line: Line) {
        let parts = strokes.iter().flat_map(|stroke| self.ellipsoid.parts(stroke, &self.view));
        let drawn = parts.filter(|part| part.is_seen == is_seen).map(|part| {
            let points: Vec<Point> = part.points.iter().map(|point| self.place(scale, point)).collect();
            simplified(&points, 0.04)
        });
        sheet.strokes(drawn.collect(), if is_seen { line } else { behind(line) });
    }

    /// From the surface outwards, each with its label.
    fn axes(&self, sheet: &mut Drawing, scale: f64, is_seen: bool) {
        for axis in 0..3 {
            let surface = self.ellipsoid.point(&Vector3::ith(axis, 1.0));
            if (self.ellipsoid.facing(&surface, &self.view) >= 0.0) != is_seen {
                continue;
            }
            let from = self.place(scale, &surface);
            let tip = surface + Vector3::ith(axis, 42.0 / scale);
            let to = self.place(scale, &tip);
            sheet.line([from, to], AXIS);
            sheet.circle(from, 1.8, Some(Fill::new(Ink::Text)), None);
            let anchor = if to[0] < from[0] - 4.0 {
                Anchor::End
            } else if to[0] > from[0] + 4.0 {
                Anchor::Start
            } else {
                Anchor::Middle
            };
            let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
            let length = libm::hypot(dx, dy).max(1.0);
            let at = [to[0] + 5.0 * dx / length, to[1] + 8.0 * dy / length + 4.0];
            let label = &self.labels[axis];
            let reach = text_width(label, 12.5);
            let (low, high) = match anchor {
                Anchor::Start => (0.0, FIGURE.0 - reach),
                Anchor::Middle => (0.5 * reach, FIGURE.0 - 0.5 * reach),
                Anchor::End => (reach, FIGURE.0),
            };
            // A label at the edge of the sheet stays on it.
            sheet.text([at[0].clamp(low, high.max(low)), at[1]], anchor, 12.5, Ink::Text, label.clone());
        }
    }

    fn dot(&self, sheet: &mut Drawing, scale: f64, start: &Vector3<f64>, is_seen: bool) {
        if (self.ellipsoid.facing(start, &self.view) >= 0.0) != is_seen {
            return;
        }
        let at = self.place(scale, start);
        if is_seen {
            sheet.circle(at, 4.0, Some(Fill::new(START)), None);
        } else {
            sheet.circle(at, 3.5, None, Some(Line::new(START, 1.4)));
        }
    }
}

/// How a line looks behind the body.
fn behind(line: Line) -> Line {
    Line { opacity: 0.55 * line.opacity, width: 0.7 * line.width, dash: Dash::Dashed, ..line }
}
