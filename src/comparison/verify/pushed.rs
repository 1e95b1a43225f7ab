use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};

use super::interpolation::Stencil;
use crate::body::{Moment, State};
use crate::dynamics::TorqueModel;
use crate::recording::{Axes, Observed};

/// The moment that a file says acts on a body, where no scene says what does.
#[derive(Debug)]
pub(super) struct Pushed {
    times: Vec<f64>,
    /// In the file's axes, turned from body axes to principal axes where they are the body's; N m.
    moments: Vec<Vector3<f64>>,
    axes: Axes,
}

impl Pushed {
    /// Of a file that records a moment other than zero and tells its axes.
    pub fn of(observed: &Observed, body_from_principal: &UnitQuaternion<f64>) -> Option<Arc<Self>> {
        let track = observed.moment.as_ref()?;
        let axes = track.axes?;
        let row = |k: usize| Vector3::from(track.columns.each_ref().map(|column| column[k]));
        let turned = |moment: Vector3<f64>| match axes {
            Axes::Body => body_from_principal.inverse_transform_vector(&moment),
            Axes::World => moment,
        };
        let moments: Vec<_> = (0..track.times_s.len()).map(|k| turned(row(k))).collect();
        let is_one = moments.iter().any(|moment| *moment != Vector3::zeros()) && moments.len() > 1;
        is_one.then(|| Arc::new(Self { times: track.times_s.clone(), moments, axes }))
    }

    /// Through so many neighbours, in principal axes for a state in them, N m.
    pub fn at(&self, time: f64, state: &State, width: usize) -> Vector3<f64> {
        let near = self.times.partition_point(|own| *own <= time).saturating_sub(1);
        let moment = Stencil::between(&self.times, near, width).vector(&self.moments, time);
        match self.axes {
            Axes::Body => moment,
            Axes::World => state.attitude.to_body(&moment),
        }
    }
}

/// The same, with the time counted from a start of its own, s.
pub(super) struct PushedSince(pub Arc<Pushed>, pub f64);

impl TorqueModel for PushedSince {
    fn moment(&self, time: f64, state: &State) -> Moment {
        Moment::from_vector(self.0.at(self.1 + time, state, WIDTH))
    }
}

/// Neighbours on both sides through which a moment's polynomial goes.
pub(super) const WIDTH: usize = 4;
