use nalgebra::Vector3;

use super::camera::{self, Room};
use super::{Arrow, BodyPicture, Picture, Poinsot, Quantity, pace, scale};
use crate::propagation::PropagationError;
use crate::scenario::{Plan, PlannedBody};
use crate::telemetry::{BodySamples, Channel};

/// At how many times the run is looked over.
const LOOKS: u64 = 400;
/// Longest length in extents, and colour. ω and L mostly point nearly the same way: their lengths tell them apart.
const QUANTITIES: [(Quantity, f64, [u8; 3]); 4] = [
    (Quantity::AngularVelocity, 1.3, [240, 150, 20]),
    (Quantity::AngularMomentum, 2.2, [0, 145, 230]),
    (Quantity::Moment, 1.4, [204, 121, 167]),
    (Quantity::Force, 1.4, [150, 200, 60]),
];
/// How far the picture of a body reaches, in extents: arrows are seldom at their longest, and point out of the picture
/// or into it as often as along it.
const REACH: f64 = 2.2;
/// Bodies in the order of the scene: all pale, so that the arrows stand out.
const BODY_COLOURS: [[u8; 4]; 4] =
    [[196, 200, 206, 255], [143, 170, 200, 255], [200, 172, 140, 255], [158, 184, 150, 255]];

/// What a look over the run shows of one body.
struct Look {
    /// Largest magnitude of each of [`QUANTITIES`].
    largest: [f64; 4],
    /// Corners of the box that the reference point stays in.
    lowest: Vector3<f64>,
    highest: Vector3<f64>,
    extent: f64,
}

impl Look {
    /// What the body with its arrows takes of the picture.
    fn room(&self) -> Room {
        Room { lowest: self.lowest, highest: self.highest, radius: REACH * self.extent }
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
        let rooms: Vec<_> = looks.iter().map(Look::room).collect();
        let (eye, target) = camera::place(&rooms);
        let bodies = plan.bodies.iter().zip(&looks).zip(BODY_COLOURS.iter().cycle());
        let bodies = bodies.map(|((body, look), colour)| draw(body, look, *colour)).collect();
        let playback_speed = pace::playback_speed(plan.grid.end() - plan.grid.time(0));
        let fastest = looks.iter().map(|look| look.largest[0]).fold(0.0, f64::max);
        let stride = pace::stride(plan.grid.mean_interval(), playback_speed, fastest);
        Ok(Self { stride, playback_speed, last, eye, target, bodies })
    }
}

fn look(body: &PlannedBody, times: &[f64]) -> Result<Look, PropagationError> {
    let channels = QUANTITIES.map(|(quantity, ..)| quantity.channels().0);
    let mut watched = channels.to_vec();
    watched.push(Channel::Position);
    watched.sort_unstable();
    let samples = body.sample(&watched, times)?;
    let vectors = |channel: Channel| vectors(&samples, channel);
    let largest = channels.map(|channel| vectors(channel).map(|vector| vector.norm()).fold(0.0, f64::max));
    let start = body.problem.initial.position;
    Ok(Look {
        largest,
        lowest: vectors(Channel::Position).fold(start, |lowest, position| lowest.inf(&position)),
        highest: vectors(Channel::Position).fold(start, |highest, position| highest.sup(&position)),
        extent: body.surfaces.iter().map(crate::body::Surface::extent).fold(0.0, f64::max),
    })
}

fn vectors(samples: &BodySamples, channel: Channel) -> impl Iterator<Item = Vector3<f64>> {
    let columns = samples.channel(channel).unwrap_or_default();
    let count = columns.first().map_or(0, Vec::len);
    (0..count).map(move |index| Vector3::from_fn(|row, _| columns[row][index]))
}

fn draw(body: &PlannedBody, look: &Look, colour: [u8; 4]) -> BodyPicture {
    let arrows = QUANTITIES.iter().zip(look.largest).filter(|((quantity, ..), largest)| {
        quantity.is_recorded(&body.channels) && *largest > 0.0 && largest.is_finite()
    });
    let arrow = |((quantity, length, colour), largest): (&(Quantity, f64, [u8; 3]), f64)| {
        let (label, metres_per_unit) = scale::choose(*quantity, length * look.extent, largest);
        Arrow { quantity: *quantity, label, colour: *colour, metres_per_unit }
    };
    BodyPicture {
        colour,
        extent: look.extent,
        arrows: arrows.map(arrow).collect(),
        spin_axis: spin_axis(body),
        position: body.problem.initial.position,
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
