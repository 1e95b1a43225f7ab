use nalgebra::Vector3;

use super::carried::Carried;
use super::recurrence::{Recurrence, fall, recurrence_for, thrust};
use super::series::{Row, Series};
use super::step_size::power_of_two;
use super::terms::Terms;
use crate::dynamics::{EulerEquations, Gradient, Span};

/// A span of the schedule, with the code and the constants that its series needs: nothing is decided later.
#[derive(Debug, Clone)]
pub(super) struct Stretch {
    /// Its end, s.
    pub end: f64,
    terms: Terms,
    /// World vectors of the couples.
    vectors: Vec<Vector3<f64>>,
    gradient: Option<Gradient>,
    recurrence: Recurrence,
    translation: Translation,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Translation {
    Unwanted,
    /// Under world forces only: a parabola.
    Fall,
    /// With a force that turns with the body.
    Thrust,
}

impl Stretch {
    pub fn new(euler: &EulerEquations, span: &Span, with_attitude: bool, with_translation: bool) -> Self {
        let loads = &span.loads;
        let translation = match (with_translation, loads.body_acceleration == Vector3::zeros()) {
            (false, _) => Translation::Unwanted,
            (true, true) => Translation::Fall,
            (true, false) => Translation::Thrust,
        };
        Self {
            end: span.end,
            terms: Terms::new(euler, loads),
            vectors: loads.couples.iter().map(|couple| couple.vector).collect(),
            gradient: loads.gradient,
            recurrence: recurrence_for(loads, with_attitude),
            translation,
        }
    }

    /// The constants with time in `unit` seconds.
    pub fn terms_in(&self, unit: f64) -> Terms {
        self.terms.in_unit(unit)
    }

    /// Overwrites the series with that of the motion from a state on, to an order; its unit is that of the terms.
    pub fn expand(&self, state: &Carried, terms: &Terms, series: &mut Series, order: usize) {
        series.attitude[0] = state.attitude.high;
        series.rates[0] = row(Vector3::from(state.rates.high) * terms.unit);
        for (image, vector) in series.images.iter_mut().zip(&self.vectors) {
            image[0] = row(state.to_body(vector));
        }
        if let Some(gradient) = self.gradient {
            let Carried { time, .. } = state;
            series.radial[0] = row(state.to_body(&gradient.radial_at(time.high[0], time.low[0])));
            series.pole[0] = row(state.to_body(&Vector3::z()));
        }
        (self.recurrence)(terms, series, order);
        if self.translation != Translation::Unwanted {
            series.position[0] = row(Vector3::from(state.position.high));
            series.velocity[0] = row(Vector3::from(state.velocity.high) * terms.unit);
        }
        match self.translation {
            Translation::Unwanted => {}
            Translation::Fall => fall(terms, series),
            Translation::Thrust => thrust(terms, series, order),
        }
    }

    /// A unit of time near the first step's length, from how fast things happen in a state.
    pub fn unit_at(&self, state: &Carried) -> f64 {
        let (terms, mut series) = (self.terms, Series::new());
        self.expand(state, &terms, &mut series, 1);
        let turning = largest(&series.rates[0]).max(largest(&series.rates[1]).sqrt());
        let fading = largest(&terms.damping);
        power_of_two(1.0 / turning.max(fading).max(terms.mean_motion.abs()))
    }
}

fn row(vector: Vector3<f64>) -> Row {
    [vector.x, vector.y, vector.z, 0.0]
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| value.abs().max(most))
}
