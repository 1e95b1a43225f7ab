use std::f64::consts::TAU;

use nalgebra::{UnitQuaternion, Vector3};

use super::Page;
use super::sections::figure;
use super::solid::{Arrow, Pose, draw};
use crate::plot::motion::View;
use crate::plot::svg::escaped;
use crate::plot::{Anchor, Drawing, Ink, Line, plain_time};
use crate::propagation::PropagationError;
use crate::recording::picture::{Picture, Quantity, attitude};
use crate::scenario::{EventKind, Plan, PlannedBody};
use crate::telemetry::{BodySamples, Channel};

/// Pictures of a body that turns where it is, and flashes of one that travels.
const PICTURES: u32 = 8;
const FLASHES: u32 = 12;
/// Of one picture, pixels.
const SIDE: f64 = 250.0;
/// Half of what is seen of a body that turns where it is, in sizes of the largest.
const HALF: f64 = 2.35;

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
            text += &format!("<h3>{}</h3>\n", escaped(&body.name));
        }
        text += "<div class=\"figures pictures\">\n";
        text.extend(drawings.iter().map(|(drawing, caption)| figure(drawing, caption.as_deref())));
        text += "</div>\n";
        let labels: Vec<_> = picture.bodies[index].arrows.iter().map(|arrow| arrow.label.as_str()).collect();
        if !labels.is_empty() {
            text += &format!("<p class=\"faint\">Arrows: {}.</p>\n", escaped(&labels.join("; ")));
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
    let poses: Vec<Pose> = (0..times.len()).filter_map(|at| pose(&samples, at, picture, index)).collect();
    if travels {
        return Ok(vec![(
            flashes(body, &poses, view, picture, index),
            Some(format!("from 0 to {} s", plain_time(to_s))),
        )]);
    }
    let half = HALF * picture.size;
    let one = |(pose, time): (&Pose, &f64)| {
        let mut sheet = Drawing::new(SIDE, SIDE);
        let pose = Pose { position: Vector3::zeros(), ..pose.clone() };
        let place = |point: &Vector3<f64>| {
            let [right, up] = view.project(point);
            [0.5 * SIDE * (1.0 + right / half), 0.5 * SIDE * (1.0 - up / half)]
        };
        draw(&mut sheet, &body.surfaces, picture.bodies[index].colour, &pose, view, &place);
        sheet.text([10.0, SIDE - 8.0], Anchor::Start, 13.0, Ink::Faint, format!("{time:.4} s"));
        (sheet, None)
    };
    Ok(poses.iter().zip(&times).map(one).collect())
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

fn pose(samples: &BodySamples, at: usize, picture: &Picture, index: usize) -> Option<Pose> {
    let read = |channel: Channel| {
        let columns = samples.channel(channel)?;
        Some(Vector3::from_fn(|row, _| columns[row][at]))
    };
    let world_from_body: UnitQuaternion<f64> = attitude(samples, at)?;
    let arrows = picture.bodies[index].arrows.iter().filter_map(|arrow| {
        let vector = read(arrow.quantity.channels().0)? * arrow.metres_per_unit;
        let symbol = arrow.quantity.words().0;
        let width = if arrow.quantity == Quantity::AngularVelocity { 3.0 } else { 2.2 };
        Some(Arrow { vector, symbol, colour: arrow.colour, width })
    });
    let arrows = arrows.collect();
    Some(Pose { world_from_body, position: read(Channel::Position)?, arrows, size: picture.bodies[index].extent })
}

/// All flashes on one sheet, and the way of the reference point.
fn flashes(body: &PlannedBody, poses: &[Pose], view: &View, picture: &Picture, index: usize) -> Drawing {
    let room = 1.25 * picture.bodies[index].extent;
    let projected: Vec<[f64; 2]> = poses.iter().map(|pose| view.project(&pose.position)).collect();
    let reach = |axis: usize, sign: f64| {
        projected.iter().map(|point| sign * point[axis]).fold(f64::NEG_INFINITY, f64::max) + room
    };
    let [left, right, low, high] = [-reach(0, -1.0), reach(0, 1.0), -reach(1, -1.0), reach(1, 1.0)];
    let scale = (1000.0 / (right - left)).min(640.0 / (high - low));
    let mut sheet = Drawing::new(scale * (right - left), scale * (high - low));
    let place = |point: &Vector3<f64>| {
        let [x, y] = view.project(point);
        [scale * (x - left), scale * (high - y)]
    };
    let way: Vec<_> = poses.iter().map(|pose| place(&pose.position)).collect();
    sheet.line(way, Line::new(Ink::Faint, 1.0).faded(0.6));
    for pose in poses {
        let pose = Pose { arrows: Vec::new(), ..pose.clone() };
        draw(&mut sheet, &body.surfaces, picture.bodies[index].colour, &pose, view, &place);
    }
    sheet
}
