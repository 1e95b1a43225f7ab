use nalgebra::{UnitQuaternion, Vector3};

use super::partition::Partition;
use crate::plot::motion::View;
use crate::plot::{Anchor, Drawing, Fill, Ink, Line, Point, Shape};

/// A body at one instant.
#[derive(Debug, Clone)]
pub struct Pose {
    pub world_from_body: UnitQuaternion<f64>,
    /// Of the reference point, world axes, m.
    pub position: Vector3<f64>,
    /// Vectors from the reference point.
    pub arrows: Vec<Arrow>,
    /// How far its axes are drawn, m.
    pub axes: [f64; 3],
}

/// A vector as an arrow.
#[derive(Debug, Clone)]
pub struct Arrow {
    /// World axes, m.
    pub vector: Vector3<f64>,
    pub symbol: &'static str,
    pub colour: [u8; 3],
    /// Pixels.
    pub width: f64,
    /// How far to the right of its tip the symbol stands, pixels.
    pub aside: f64,
}

/// Where the light comes from, as seen: right, up, towards the eye.
const LIGHT: [f64; 3] = [-0.35, 0.6, 0.72];
/// Shades of a colour: few, so that neighbours share one and are drawn together.
const SHADES: f64 = 20.0;

/// The body in its colour, with what points away from the eye behind it and the rest before it.
pub fn draw(
    sheet: &mut Drawing,
    sides: &Partition,
    colour: [u8; 4],
    pose: &Pose,
    view: &View,
    place: &dyn Fn(&Vector3<f64>) -> Point,
) {
    let (before, behind): (Vec<_>, Vec<_>) =
        pose.arrows.iter().partition(|arrow| arrow.vector.dot(&view.towards) >= 0.0);
    for arrow in behind {
        point(sheet, arrow, pose, place);
    }
    // In a picture without arrows axes would be all there is to see.
    let has_axes = !pose.arrows.is_empty();
    if has_axes {
        axes(sheet, pose, view, place, false);
    }
    faces(sheet, sides, colour, pose, view, place);
    if has_axes {
        axes(sheet, pose, view, place, true);
    }
    for arrow in before {
        point(sheet, arrow, pose, place);
    }
}

/// Sides that face the eye, the farthest first.
fn faces(
    sheet: &mut Drawing,
    sides: &Partition,
    colour: [u8; 4],
    pose: &Pose,
    view: &View,
    place: &dyn Fn(&Vector3<f64>) -> Point,
) {
    let towards = pose.world_from_body.inverse() * view.towards;
    for side in sides.seen_from(&towards) {
        let normal = pose.world_from_body * side.normal;
        let seen = Vector3::new(normal.dot(&view.right), normal.dot(&view.up), normal.dot(&view.towards));
        let shade = shaded(colour, seen.dot(&Vector3::from(LIGHT)));
        let at = |corner: &Vector3<f64>| place(&(pose.position + pose.world_from_body * corner));
        let corners: Vec<Point> = side.corners.iter().map(at).collect();
        // The line closes the seam to the neighbour.
        let (line, fill) = (Line::new(Ink::Given(shade), 0.7), Fill::new(Ink::Given(shade)));
        match sheet.shapes.last_mut() {
            Some(Shape::Path { strokes, is_closed: true, fill: Some(last), .. }) if *last == fill => {
                strokes.push(corners);
            }
            _ => sheet.area(corners, Some(fill), Some(line)),
        }
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
fn shaded([red, green, blue, _]: [u8; 4], light: f64) -> [u8; 3] {
    let strength = (0.42 + 0.58 * light.max(0.0)).min(1.0);
    let strength = (strength * SHADES).round() / SHADES;
    [red, green, blue].map(|part| (f64::from(part) * strength).round() as u8)
}

/// The body's axes, those that point to the eye or those that do not.
fn axes(sheet: &mut Drawing, pose: &Pose, view: &View, place: &dyn Fn(&Vector3<f64>) -> Point, is_before: bool) {
    for (index, name) in ["x", "y", "z"].into_iter().enumerate() {
        let axis = pose.world_from_body * Vector3::ith(index, pose.axes[index]);
        if (axis.dot(&view.towards) >= 0.0) == is_before {
            let tip = pose.position + axis;
            sheet.line([place(&pose.position), place(&tip)], Line::new(Ink::Faint, 1.0));
            let [x, y] = place(&(pose.position + axis * 1.1));
            sheet.text([x, y + 4.0], Anchor::Middle, 11.0, Ink::Faint, name);
        }
    }
}

fn point(sheet: &mut Drawing, arrow: &Arrow, pose: &Pose, place: &dyn Fn(&Vector3<f64>) -> Point) {
    let (from, to) = (place(&pose.position), place(&(pose.position + arrow.vector)));
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let length = libm::hypot(dx, dy);
    // Seen along itself it is a dot.
    if length < 2.0 {
        sheet.circle(to, arrow.width, Some(Fill::new(Ink::Given(arrow.colour))), None);
        return;
    }
    let [ux, uy] = [dx / length, dy / length];
    let head = (4.0 * arrow.width).min(length);
    let neck = [to[0] - head * ux, to[1] - head * uy];
    let ink = Ink::Given(arrow.colour);
    sheet.line([from, neck], Line::new(ink, arrow.width));
    let half = 0.42 * head;
    let corner = |side: f64| [neck[0] - side * half * uy, neck[1] + side * half * ux];
    sheet.area([to, corner(1.0), corner(-1.0)], Some(Fill::new(ink)), None);
    // Beside the tip: arrows often point nearly the same way.
    let at = [to[0] + 4.0 * ux + arrow.aside * uy, to[1] + 4.0 * uy - arrow.aside * ux + 4.0];
    sheet.text(at, Anchor::Middle, 13.0, ink, arrow.symbol);
}
