use std::ops::Range;

use nalgebra::Vector3;

use super::envelope::Envelope;
use super::group::charts;
use super::herpolhode::Herpolhode;
use super::inertia::InertiaFit;
use super::polhode::{axis_path, polhode};
use super::trail::Trail;
use super::wanted::Wanted;
use crate::body::MassProperties;
use crate::dynamics::Torque;
use crate::plot::{Drawing, Mark};
use crate::recording::RecordedBody;
use crate::recording::picture::{Quantity, attitude};
use crate::scenario::{EventKind, Plan, PlannedBody};
use crate::telemetry::{BodySamples, Channel};

/// One body's motion, thinned.
#[derive(Debug, Clone)]
pub struct BodyMotion {
    /// Its number in the recording.
    pub index: usize,
    /// Its name.
    pub name: String,
    /// Each channel recorded, with its columns.
    curves: Vec<(Channel, Vec<Envelope>)>,
    /// Directions of ω in body axes.
    directions: Trail,
    herpolhode: Herpolhode,
    /// Of the axis that it follows, world axes.
    axis_path: Trail,
    axis: Vector3<f64>,
    fit: InertiaFit,
    /// From the scene.
    properties: Option<MassProperties>,
    is_free: Option<bool>,
    marks: Vec<Mark>,
    wanted: Vec<Wanted>,
}

impl BodyMotion {
    /// Of a body of which nothing is read yet.
    pub fn new(index: usize, recorded: &RecordedBody, plan: Option<&Plan>, wanted: &[Wanted]) -> Self {
        let planned = plan.and_then(|plan| plan.bodies.get(index));
        let curve = |channel: &Channel| (*channel, vec![Envelope::default(); channel.width()]);
        Self {
            index,
            name: recorded.name.clone(),
            curves: recorded.channels.iter().map(curve).collect(),
            directions: Trail::new(1.0),
            herpolhode: Herpolhode::default(),
            axis_path: Trail::new(1.0),
            axis: planned.map_or_else(Vector3::z, followed),
            fit: InertiaFit::default(),
            properties: planned.map(|body| body.properties.clone()),
            is_free: planned.map(|body| body.problem.loads.is_empty()),
            marks: plan.map(|plan| marks(plan, index)).unwrap_or_default(),
            wanted: wanted.to_vec(),
        }
    }

    /// What is recorded of it.
    pub fn recorded(&self) -> impl Iterator<Item = Channel> {
        self.curves.iter().map(|(channel, _)| *channel)
    }

    /// Whether its columns give this panel.
    pub fn can_show(&self, wanted: Wanted) -> bool {
        let has = |channel: Channel| self.recorded().any(|recorded| recorded == channel);
        let channels: Vec<_> = self.recorded().collect();
        match wanted {
            Wanted::Channel(channel) => has(channel),
            Wanted::Polhode => {
                has(Channel::AngularVelocity) || has(Channel::AngularVelocityWorld) && has(Channel::Attitude)
            }
            Wanted::Herpolhode => {
                let vectors = [Quantity::AngularVelocity, Quantity::AngularMomentum];
                vectors.iter().all(|quantity| quantity.is_recorded(&channels))
            }
            Wanted::AxisPath => has(Channel::Attitude),
        }
    }

    /// The samples in `range`.
    pub fn add(&mut self, times_s: &[f64], samples: &BodySamples, range: Range<usize>) {
        for (channel, envelopes) in &mut self.curves {
            let columns = samples.channel(*channel).unwrap_or_default();
            for (envelope, column) in envelopes.iter_mut().zip(columns) {
                range.clone().for_each(|index| envelope.push(times_s[index], column[index]));
            }
        }
        for index in range {
            let time_s = times_s[index];
            let attitude = attitude(samples, index);
            let in_body = |quantity: Quantity| {
                let (world, body) = quantity.channels();
                let read = |columns: &[Vec<f64>]| Vector3::from_fn(|row, _| columns[row][index]);
                let told = body.and_then(|body| samples.channel(body)).map(read);
                told.or_else(|| Some(attitude?.inverse() * read(samples.channel(world)?)))
            };
            if let Some(omega) = in_body(Quantity::AngularVelocity) {
                self.directions.push(time_s, omega / omega.norm());
                if let (None, Some(momentum)) = (&self.properties, in_body(Quantity::AngularMomentum)) {
                    self.fit.push(&omega, &momentum);
                }
            }
            let in_world = |quantity: Quantity| quantity.in_world(samples, index);
            if let (Some(omega), Some(momentum)) =
                (in_world(Quantity::AngularVelocity), in_world(Quantity::AngularMomentum))
            {
                self.herpolhode.push(time_s, &omega, &momentum);
            }
            if let Some(attitude) = attitude {
                self.axis_path.push(time_s, attitude * self.axis);
            }
        }
    }

    /// Whether nothing was read.
    pub fn is_empty(&self) -> bool {
        self.curves.iter().flat_map(|(_, columns)| columns).all(|column| column.range().is_none())
    }

    /// What could not be drawn of what was asked for, or of what is drawn of a body whose scene is known.
    pub fn remarks(&self) -> Vec<String> {
        let mut remarks = Vec::new();
        let is_wanted = |wanted: Wanted| self.wanted.is_empty() || self.wanted.contains(&wanted);
        if is_wanted(Wanted::Polhode) && self.can_show(Wanted::Polhode) && self.inertia().is_none() {
            remarks.push(format!(
                "{}: no polhode: the recording tells no moments of inertia, neither by a scene nor by ω and L together",
                self.name
            ));
        }
        if self.wanted.contains(&Wanted::Herpolhode) && self.herpolhode.reason().is_some() {
            let reason = self.herpolhode.reason().unwrap_or_default();
            remarks.push(format!("{}: no herpolhode: {reason}", self.name));
        }
        remarks
    }

    /// Figures and charts, in the order in which they are looked at.
    pub fn panels(&self, chart: (f64, f64)) -> Vec<Drawing> {
        let is_wanted = |wanted: Wanted| self.can_show(wanted) && self.wanted.contains(&wanted);
        let by_default = self.wanted.is_empty();
        let turns = self.directions.first().is_some();
        let mut panels = Vec::new();
        if (by_default && turns && self.can_show(Wanted::Polhode)) || is_wanted(Wanted::Polhode) {
            let inertia = self.inertia();
            panels.extend(inertia.and_then(|inertia| polhode(&self.directions, &inertia, self.is_free)));
        }
        let herpolhode = (by_default || is_wanted(Wanted::Herpolhode)).then(|| self.herpolhode.panel()).flatten();
        let has_herpolhode = herpolhode.is_some();
        panels.extend(herpolhode);
        let has_path = by_default && !has_herpolhode && turns && self.can_show(Wanted::AxisPath);
        if has_path || is_wanted(Wanted::AxisPath) {
            panels.extend(axis_path(&self.axis_path, &self.axis));
        }
        panels.extend(charts(&self.curves, &self.wanted, &self.marks, chart));
        panels
    }

    fn inertia(&self) -> Option<MassProperties> {
        self.properties.clone().or_else(|| self.fit.properties())
    }
}

/// Of a body in a gravity gradient the axis of the least moment, which the gradient holds upright; else the principal axis
/// nearest to ω at t = 0, the third of a body at rest. Body axes.
fn followed(body: &PlannedBody) -> Vector3<f64> {
    let omega = body.problem.initial.angular_velocity.in_body();
    let is_upright = body.problem.loads.iter().any(|load| matches!(load.torque, Torque::GravityGradient { .. }));
    let axis = match omega {
        _ if is_upright => body.properties.moments.vector().imin(),
        omega if omega == Vector3::zeros() => 2,
        omega => omega.iamax(),
    };
    let sign = if omega[axis] < 0.0 { -1.0 } else { 1.0 };
    body.properties.body_from_principal * (sign * Vector3::ith(axis, 1.0))
}

fn marks(plan: &Plan, body: usize) -> Vec<Mark> {
    let events = plan.events.iter().filter(|event| event.body == body);
    let kinds = events.filter_map(|event| {
        let label = match event.kind {
            EventKind::Load => "load begins or ends",
            EventKind::Flip => "flip",
            EventKind::Passed | EventKind::Failed => return None,
        };
        Some(Mark { label: label.to_owned(), time_s: event.time_s })
    });
    kinds.collect()
}
