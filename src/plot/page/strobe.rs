use std::f64::consts::TAU;

use nalgebra::{UnitQuaternion, Vector3};

use super::Page;
use super::partition::Partition;
use super::sections::figure;
use super::solid::{Arrow, Pose, draw};
use crate::plot::motion::View;
use crate::plot::svg::escaped;
use crate::plot::{Anchor, Drawing, Ink, Line, figure as number, plain_time};
use crate::propagation::PropagationError;
use crate::recording::picture::{BodyPicture, Picture, Quantity, attitude};
use crate::scenario::{EventKind, Plan, PlannedBody};
use crate::telemetry::{BodySamples, Channel};

/// Pictures of a body that turns where it is, and flashes of one that travels.
const PICTURES: u32 = 8;
const FLASHES: u32 = 12;
/// Of one picture, pixels.
const SIDE: f64 = 250.0;

/// Pictures of the motion at several times, if the scene is known.
pub fn section(page: &Page<'_>) -> String {
    let Some(plan) = page.plan else { return String::new() };
    let Ok(picture) = Picture::of(plan) else { return String::new() };
    let towards = picture.eye - picture.target;
    let Some(view) = View::new(&towards, &Vector3::z()) else { return String::new() };
    let mut text = "<section>\n<h2>Pictures of the motion</h2>\n".to_owned();
    for (index, body) in plan.bodies.iter().enumerate() {
        // What cannot be propagated was refused before: a page without a picture is still a page.
        let Ok(drawings) = pictures(plan, index, &picture, &view) else { continue };
        if plan.bodies.len() > 1 {
            text.extend([format!("<h3>{}</h3>\n", escaped(&body.name))]);
        }
        text += "<div class=\"figures pictures\">\n";
        text.extend(drawings.iter().map(|(drawing, caption)| figure(drawing, caption.as_deref())));
        text += "</div>\n";
        let labels: Vec<_> = picture.bodies[index].arrows.iter().map(|arrow| arrow.label.as_str()).collect();
        if !labels.is_empty() && !picture.bodies[index].travels {
            text.extend([format!("<p class=\"faint\">Arrows: {}.</p>\n", escaped(&labels.join("; ")))]);
        }
    }
    text + "</section>\n"
}

type Captioned = (Drawing, Option<String>);

fn pictures(plan: &Plan, index: usize, picture: &Picture, view: &View) -> Result<Vec<Captioned>, PropagationError> {
    let body = &plan.bodies[index];
    let travels = picture.bodies[index].travels;
    let to_s = if travels { plan.grid.end() } else { until(plan, index)? };
    let (count, last) = if travels { (FLASHES, FLASHES - 1) } else { (PICTURES, PICTURES) };
    let times: Vec<f64> = (0..count).map(|number| to_s * f64::from(number) / f64::from(last)).collect();
    let mut channels = vec![Channel::Attitude, Channel::Position];
    channels.extend(picture.bodies[index].arrows.iter().map(|arrow| arrow.quantity.channels().0));
    channels.sort_unstable();
    channels.dedup();
    let samples = body.sample(&channels, &times)?;
    // An axis comes out of the body, and no farther.
    let farthest = vertices(body).fold(Vector3::zeros(), |far: Vector3<f64>, vertex| far.sup(&vertex));
    let axes = [0, 1, 2].map(|axis: usize| farthest[axis] + 0.25 * picture.bodies[index].extent);
    let pose = |at: usize| pose(&samples, at, &picture.bodies[index], axes);
    let poses: Vec<Pose> = (0..times.len()).filter_map(pose).collect();
    let sides = Partition::of(&body.surfaces);
    if travels {
        let caption = format!("{FLASHES} flashes from 0 to {} s, and the way of the reference point", plain_time(to_s));
        let fine: Vec<f64> = (0..=200).map(|step| to_s * f64::from(step) / 200.0).collect();
        let way = body.sample(&[Channel::Position], &fine)?;
        let way: Vec<_> = (0..fine.len()).filter_map(|at| vector(&way, Channel::Position, at)).collect();
        return Ok(vec![(flashes(&sides, &poses, &way, view, &picture.bodies[index]), Some(caption))]);
    }
    let still: Vec<Pose> = poses.iter().map(|pose| Pose { position: Vector3::zeros(), ..pose.clone() }).collect();
    let frame = frame(&still, body, view);
    let one = |(pose, time): (&Pose, &f64)| {
        let mut sheet = Drawing::new(SIDE, SIDE);
        let place = |point: &Vector3<f64>| {
            let [x, y] = view.project(point);
            let part = |along: f64, middle: f64| 0.5 * (1.0 + (along - middle) / frame.half);
            [SIDE * part(x, frame.middle[0]), SIDE * (1.0 - part(y, frame.middle[1]))]
        };
        draw(&mut sheet, &sides, picture.bodies[index].colour, pose, view, &place);
        sheet.text([10.0, SIDE - 8.0], Anchor::Start, 13.0, Ink::Faint, format!("{} s", number(*time)));
        (sheet, None)
    };
    Ok(still.iter().zip(&times).map(one).collect())
}

/// What is seen: a square.
struct Frame {
    middle: [f64; 2],
    half: f64,
}

/// Around the body and its arrows in all poses.
fn frame(poses: &[Pose], body: &PlannedBody, view: &View) -> Frame {
    let vertices: Vec<Vector3<f64>> = vertices(body).collect();
    let points = poses.iter().flat_map(|pose| {
        let axes = [0, 1, 2].map(|axis| Vector3::ith(axis, 1.15 * pose.axes[axis]));
        let turned = vertices.iter().chain(&axes).map(|vertex| pose.world_from_body * vertex);
        turned.chain(pose.arrows.iter().map(|arrow| arrow.vector * 1.08)).collect::<Vec<_>>()
    });
    let (mut low, mut high) = ([0.0_f64; 2], [0.0_f64; 2]);
    for point in points {
        let projected = view.project(&point);
        for axis in 0..2 {
            low[axis] = low[axis].min(projected[axis]);
            high[axis] = high[axis].max(projected[axis]);
        }
    }
    let middle = [0, 1].map(|axis: usize| 0.5 * (low[axis] + high[axis]));
    let size = (high[0] - low[0]).max(high[1] - low[1]).max(f64::MIN_POSITIVE);
    Frame { middle, half: 0.54 * size }
}

fn vertices(body: &PlannedBody) -> impl Iterator<Item = Vector3<f64>> {
    let all = body.surfaces.iter().flat_map(|surface| &surface.vertices);
    all.map(|vertex| Vector3::from(vertex.map(f64::from)))
}

/// Until when pictures tell what the body does, s: past its second flip, once round in precession, or one turn.
fn until(plan: &Plan, index: usize) -> Result<f64, PropagationError> {
    let (body, end) = (&plan.bodies[index], plan.grid.end());
    let mut flips = plan.events.iter().filter(|event| event.body == index && event.kind == EventKind::Flip);
    if let Some(second) = flips.nth(1) {
        return Ok((1.1 * second.time_s).min(end));
    }
    let channel = if body.channels.contains(&Channel::PrecessionRate) {
        Channel::PrecessionRate
    } else {
        Channel::AngularVelocity
    };
    let looks: Vec<f64> = (0..=200).map(|look| end * f64::from(look) / 200.0).collect();
    let samples = body.sample(&[channel], &looks)?;
    let columns = samples.channel(channel).unwrap_or_default();
    let rate = |at: usize| columns.iter().map(|column| column[at] * column[at]).sum::<f64>().sqrt();
    let mean = (0..looks.len()).map(rate).sum::<f64>() / 201.0;
    let turn = TAU / mean;
    Ok(if turn.is_finite() { turn.min(end) } else { end })
}

fn vector(samples: &BodySamples, channel: Channel, at: usize) -> Option<Vector3<f64>> {
    let columns = samples.channel(channel)?;
    Some(Vector3::from_fn(|row, _| columns[row][at]))
}

fn pose(samples: &BodySamples, at: usize, picture: &BodyPicture, axes: [f64; 3]) -> Option<Pose> {
    let read = |channel: Channel| vector(samples, channel, at);
    let world_from_body: UnitQuaternion<f64> = attitude(samples, at)?;
    let arrows = picture.arrows.iter().filter_map(|arrow| {
        let vector = read(arrow.quantity.channels().0)? * arrow.metres_per_unit;
        let symbol = arrow.quantity.words().0;
        let (width, aside) = if arrow.quantity == Quantity::AngularVelocity { (3.0, -12.0) } else { (2.2, 12.0) };
        Some(Arrow { vector, symbol, colour: arrow.colour, width, aside })
    });
    let arrows = arrows.collect();
    Some(Pose { world_from_body, position: read(Channel::Position)?, arrows, axes })
}

/// All flashes on one sheet, and the way of the reference point.
fn flashes(sides: &Partition, poses: &[Pose], way: &[Vector3<f64>], view: &View, body: &BodyPicture) -> Drawing {
    let room = 1.05 * body.extent;
    let projected: Vec<[f64; 2]> = poses.iter().map(|pose| view.project(&pose.position)).collect();
    let reach = |axis: usize, sign: f64| {
        projected.iter().map(|point| sign * point[axis]).fold(f64::NEG_INFINITY, f64::max) + room
    };
    let [left, right, low, high] = [-reach(0, -1.0), reach(0, 1.0), -reach(1, -1.0), reach(1, 1.0)];
    let scale = (1000.0 / (right - left)).min(560.0 / (high - low));
    let mut sheet = Drawing::new(scale * (right - left), scale * (high - low));
    let place = |point: &Vector3<f64>| {
        let [x, y] = view.project(point);
        [scale * (x - left), scale * (high - y)]
    };
    sheet.line(way.iter().map(&place).collect::<Vec<_>>(), Line::new(Ink::Faint, 1.0));
    for pose in poses {
        let pose = &Pose { arrows: Vec::new(), ..pose.clone() };
        draw(&mut sheet, sides, body.colour, pose, view, &place);
    }
    sheet
}
