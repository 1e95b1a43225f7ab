use nalgebra::Vector3;

use super::camera::{self, Room};
use super::{Arrow, BodyPicture, Cord, Picture, Poinsot, Quantity, pace, powers, scale};
use crate::propagation::PropagationError;
use crate::scenario::{Following, Plan, PlannedBody};
use crate::telemetry::{BodySamples, Channel};

/// At how many times the run is looked over.
const LOOKS: u64 = 400;
/// Longest length in sizes of the largest body, and colour. ω and L mostly point nearly the same way: their lengths tell
/// them apart.
const QUANTITIES: [(Quantity, f64, [u8; 3]); 4] = [
    (Quantity::AngularVelocity, 1.5, [240, 150, 20]),
    (Quantity::AngularMomentum, 2.2, [0, 145, 230]),
    (Quantity::Moment, 1.4, [204, 121, 167]),
    (Quantity::Force, 1.4, [150, 200, 60]),
];
/// How far the picture of a body reaches, in sizes of the largest: arrows are seldom at their longest, and point out of the picture
/// or into it as often as along it.
const REACH: f64 = 2.2;
/// Bodies in the order of the scene: all pale, so that the arrows stand out.
const BODY_COLOURS: [[u8; 4]; 4] =
    [[196, 200, 206, 255], [143, 170, 200, 255], [200, 172, 140, 255], [158, 184, 150, 255]];

/// A way of so many extents is seen from so far that the body is small.
const FAR: f64 = 6.0;
/// A moment that changes L by less than this part of it over the run is what rounding left of a balance.
const BALANCED: f64 = 1e-9;

/// What a look over the run shows of one body.
struct Look {
    /// Largest magnitude of each of [`QUANTITIES`].
    largest: [f64; 4],
    /// L at t = 0, world axes.
    momentum: Vector3<f64>,
    /// Corners of the box that the reference point stays in.
    lowest: Vector3<f64>,
    highest: Vector3<f64>,
    extent: f64,
    /// Where the cords that hold it are fixed, m.
    anchors: Vec<Vector3<f64>>,
    /// The largest number of each channel that is recorded.
    sizes: Vec<(Channel, f64)>,
}

impl Look {
    /// What the body with its arrows takes of the picture, if the largest is of this size.
    fn room(&self, size: f64) -> Room {
        let lowest = self.anchors.iter().fold(self.lowest, |lowest, anchor| lowest.inf(anchor));
        let highest = self.anchors.iter().fold(self.highest, |highest, anchor| highest.sup(anchor));
        Room { lowest, highest, radius: REACH * size }
    }
}

impl Picture {
    /// Looks the run over at a few hundred times and chooses scales and camera.
    ///
    /// # Errors
    /// If the motion cannot be propagated.
    pub fn of(plan: &Plan) -> Result<Self, PropagationError> {
        let last = plan.grid.len() - 1;
        let looks = LOOKS.min(last).max(1);
        let mut times: Vec<f64> = (0..=looks).map(|look| plan.grid.time(last * look / looks)).collect();
        times.dedup();
        let looks = plan.bodies.iter().map(|body| look(body, &times)).collect::<Result<Vec<_>, _>>()?;
        let size = looks.iter().map(|look| look.extent).fold(0.0, f64::max);
        let rooms: Vec<_> = looks.iter().map(|look| look.room(size)).collect();
        let (eye, target) = camera::place(&rooms, &looks[0].momentum);
        let scales = scales(&looks, size);
        let bodies = plan.bodies.iter().zip(&looks).zip(BODY_COLOURS.iter().cycle());
        let bodies = bodies.map(|((body, look), colour)| draw(body, look, &scales, *colour)).collect();
        let playback_speed = pace::playback_speed(plan.grid.end() - plan.grid.time(0));
        let fastest = looks.iter().map(|look| look.largest[0]).fold(0.0, f64::max);
        let stride = pace::stride(plan.grid.mean_interval(), playback_speed, fastest);
        let of_bodies = looks.iter().flat_map(|look| look.sizes.iter().copied());
        let sizes: Vec<_> = of_bodies.chain(sizes_of_points(plan, &times)?).collect();
        let powers = powers::choose(&sizes);
        let floor = floor(plan, &looks);
        Ok(Self { stride, playback_speed, last, eye, target, floor, size, bodies, powers })
    }
}

/// The largest number of each channel of each point.
fn sizes_of_points(plan: &Plan, times: &[f64]) -> Result<Vec<(Channel, f64)>, PropagationError> {
    let having = plan.bodies.iter().filter(|body| !body.points.is_empty());
    let bodies: Vec<_> = having.map(|body| body.clone().watching(&[])).collect();
    let mut samples = Following::samples(&bodies);
    Following::new(&bodies)?.fill(times, &mut samples)?;
    let size = |samples: &BodySamples, channel| (channel, powers::size(samples, channel));
    let sizes = samples.iter().flat_map(|samples| samples.channels().map(move |channel| size(samples, channel)));
    Ok(sizes.collect())
}

fn floor(plan: &Plan, looks: &[Look]) -> f64 {
    let bottoms = plan.bodies.iter().zip(looks).map(|(body, look)| {
        let depth = if body.is_pivoted { 0.0 } else { 1.5 * look.extent };
        body.problem.initial.position.z - depth
    });
    bottoms.reduce(f64::min).unwrap_or(0.0)
}

fn look(body: &PlannedBody, times: &[f64]) -> Result<Look, PropagationError> {
    let channels = QUANTITIES.map(|(quantity, ..)| quantity.channels().0);
    let recorded = body.channels.iter().copied().filter(|channel| powers::has_unit(*channel));
    let mut watched: Vec<_> = channels.into_iter().chain([Channel::Position]).chain(recorded).collect();
    watched.sort_unstable();
    watched.dedup();
    let samples = body.sample(&watched, times)?;
    let vectors = |channel: Channel| vectors(&samples, channel);
    let mut largest = channels.map(|channel| vectors(channel).map(|vector| vector.norm()).fold(0.0, f64::max));
    let duration = times.last().copied().unwrap_or_default();
    if largest[2] * duration < BALANCED * largest[1] {
        largest[2] = 0.0;
    }
    let start = body.problem.initial.position;
    Ok(Look {
        largest,
        momentum: vectors(Channel::AngularMomentumWorld).next().unwrap_or_default(),
        lowest: vectors(Channel::Position).fold(start, |lowest, position| lowest.inf(&position)),
        highest: vectors(Channel::Position).fold(start, |highest, position| highest.sup(&position)),
        anchors: Cord::of(body).iter().map(|cord| cord.anchor).collect(),
        sizes: body.channels.iter().map(|channel| (*channel, powers::size(&samples, *channel))).collect(),
        extent: body.surfaces.iter().map(crate::body::Surface::extent).fold(0.0, f64::max),
    })
}

fn vectors(samples: &BodySamples, channel: Channel) -> impl Iterator<Item = Vector3<f64>> {
    let columns = samples.channel(channel).unwrap_or_default();
    let count = columns.first().map_or(0, Vec::len);
    (0..count).map(move |index| Vector3::from_fn(|row, _| columns[row][index]))
}

/// Label and length per unit of each of [`QUANTITIES`], the same for all bodies: side by side they are to be compared.
fn scales(looks: &[Look], size: f64) -> [Option<(String, f64)>; 4] {
    [0, 1, 2, 3].map(|number| {
        let (quantity, length, _) = QUANTITIES[number];
        let largest = looks.iter().map(|look| look.largest[number]).fold(0.0, f64::max);
        (largest > 0.0 && largest.is_finite()).then(|| scale::choose(quantity, length * size, largest))
    })
}

fn draw(body: &PlannedBody, look: &Look, scales: &[Option<(String, f64)>; 4], colour: [u8; 4]) -> BodyPicture {
    let arrow = |number: usize| {
        let (quantity, _, colour) = QUANTITIES[number];
        let is_there = quantity.is_recorded(&body.channels) && look.largest[number] > 0.0;
        let (label, metres_per_unit) = scales[number].clone().filter(|_| is_there)?;
        Some(Arrow { quantity, label, colour, metres_per_unit })
    };
    BodyPicture {
        colour,
        extent: look.extent,
        arrows: (0..QUANTITIES.len()).filter_map(arrow).collect(),
        spin_axis: spin_axis(body),
        position: body.problem.initial.position,
        travels: body.channels.contains(&Channel::Position) && (look.highest - look.lowest).norm() > FAR * look.extent,
        cords: Cord::of(body),
        poinsot: Poinsot::of(body),
    }
}

/// The principal axis nearest to ω at t = 0, pointing its way; the third of a body at rest.
fn spin_axis(body: &PlannedBody) -> Vector3<f64> {
    let omega = body.problem.initial.angular_velocity.in_body();
    let nearest = if omega == Vector3::zeros() { 2 } else { omega.iamax() };
    let sign = if omega[nearest] < 0.0 { -1.0 } else { 1.0 };
    body.properties.body_from_principal * (sign * Vector3::ith(nearest, 1.0))
}
