use nalgebra::Vector3;

use super::polhode::FIGURE;
use super::trail::Trail;
use crate::plot::{Anchor, Axes, Dash, Drawing, Fill, Ink, Line, Rectangle, Scale};

/// The path of ω on the invariable plane, which L stands across, seen from the tip of L.
#[derive(Debug, Clone, Default)]
pub struct Herpolhode {
    start: Option<Start>,
    /// How far L went from where it was, relative.
    departure: f64,
    /// Least and greatest distance from L, rad/s.
    radii: Option<(f64, f64)>,
}

#[derive(Debug, Clone)]
struct Start {
    momentum: Vector3<f64>,
    /// Unit vectors in the plane.
    across: [Vector3<f64>; 2],
    omega: f64,
    trail: Trail,
}

/// L that changes by more of itself has no plane.
const STEADY: f64 = 1e-6;
/// A path that is smaller beside ω is a point.
const POINT: f64 = 1e-9;

impl Herpolhode {
    /// ω and L at a time, world axes.
    pub fn push(&mut self, time_s: f64, omega: &Vector3<f64>, momentum: &Vector3<f64>) {
        if self.start.is_none() {
            self.start = start(omega, momentum);
        }
        let Some(start) = &mut self.start else { return };
        self.departure = self.departure.max((momentum - start.momentum).norm() / start.momentum.norm());
        let [x, y] = start.across.map(|axis| axis.dot(omega));
        let radius = libm::hypot(x, y);
        let (least, greatest) = self.radii.unwrap_or((radius, radius));
        self.radii = Some((least.min(radius), greatest.max(radius)));
        start.trail.push(time_s, Vector3::new(x, y, 0.0));
    }

    /// Why there is no panel.
    pub fn reason(&self) -> Option<&'static str> {
        let Some(start) = &self.start else { return Some("ω or L is zero") };
        if self.departure > STEADY {
            return Some("L changes, so that there is no invariable plane");
        }
        let is_point = self.radii.is_none_or(|(_, greatest)| greatest <= POINT * start.omega);
        is_point.then_some("ω points along L")
    }

    /// A sheet with it.
    pub fn panel(&self) -> Option<Drawing> {
        if self.reason().is_some() {
            return None;
        }
        let (start, (least, greatest)) = (self.start.as_ref()?, self.radii?);
        let mut sheet = Drawing::new(FIGURE.0, FIGURE.1);
        let side = FIGURE.1 - 118.0;
        let frame = Rectangle { left: 0.5 * (FIGURE.0 - side), top: 62.0, width: side, height: side };
        let scale = Scale::linear(-1.1 * greatest, 1.1 * greatest, 6);
        let axes = Axes { frame, across: scale.clone(), up: scale };
        sheet.text([20.0, 20.0], Anchor::Start, 14.0, Ink::Text, "herpolhode: ω on the invariable plane");
        sheet.text([20.0, 40.0], Anchor::Start, 12.5, Ink::Faint, Self::words(start));
        let unit = axes.across.counted("rad/s");
        axes.draw(&mut sheet, &format!("ω across L, {unit}"), "");
        let centre = axes.place([0.0, 0.0]);
        let per_unit = side / (2.2 * greatest);
        for radius in [least, greatest] {
            if radius > 0.01 * greatest {
                sheet.circle(centre, radius * per_unit, None, Some(BOUND));
            }
        }
        sheet.circle(centre, 3.0, Some(Fill::new(Ink::Text)), None);
        sheet.text([centre[0] - 7.0, centre[1] + 4.0], Anchor::End, 12.5, Ink::Text, "L");
        for stroke in start.trail.strokes() {
            axes.curve(&mut sheet, stroke.iter().map(|point| [point.x, point.y]), CURVE);
        }
        if let Some(first) = start.trail.first() {
            sheet.circle(axes.place([first.x, first.y]), 4.0, Some(Fill::new(Ink::Series(1))), None);
        }
        Some(sheet)
    }

    fn words(start: &Start) -> String {
        let drawn = start.trail.full_at_s().map(|time| format!(", drawn to {time:.0} s")).unwrap_or_default();
        format!("seen from the tip of L; the dot is the start; ω stays between the dashed circles{drawn}")
    }
}

const BOUND: Line = Line { ink: Ink::Faint, width: 1.0, opacity: 0.8, dash: Dash::Dashed };
const CURVE: Line = Line::new(Ink::Series(0), 1.2);

fn start(omega: &Vector3<f64>, momentum: &Vector3<f64>) -> Option<Start> {
    let normal = momentum.try_normalize(0.0)?;
    let size = omega.norm();
    if !(size > 0.0 && size.is_finite() && normal.iter().all(|part| part.is_finite())) {
        return None;
    }
    let along = normal.dot(omega) * normal;
    // Where ω starts along L, any direction will do.
    let away = (omega - along).try_normalize(1e-12 * size);
    let first = away.unwrap_or_else(|| normal.cross(&Vector3::ith(normal.iamin(), 1.0)).normalize());
    let across = [first, normal.cross(&first)];
    Some(Start { momentum: *momentum, across, omega: size, trail: Trail::new(size) })
}
