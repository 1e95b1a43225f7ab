use nalgebra::Vector3;

use super::carried::Carried;
use super::drive::Drive;
use super::recurrence::{Recurrence, recurrence_for};
use super::row::Row;
use super::series::Series;
use super::step_size::{LONGEST_STEP, power_of_two};
use super::terms::Terms;
use super::translation::{driven, fall, thrust};
use crate::dynamics::{Driven, EulerEquations, Gradient, Span};

/// A span of the schedule, with the code and the constants that its series needs: nothing is decided later.
#[derive(Debug, Clone)]
pub(super) struct Stretch {
    /// Its end, s.
    pub end: f64,
    terms: Terms,
    /// World vectors of the couples.
    vectors: Vec<Vector3<f64>>,
    gradient: Option<Gradient>,
    /// What changes with time, and what turns it into a series.
    driven: Option<(Box<Driven>, EulerEquations)>,
    /// The longest unit of time, s: beyond the span, polynomials of time need no meaning.
    longest_unit: f64,
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
            driven: loads.driven.clone().map(|driven| (driven, *euler)),
            longest_unit: if loads.driven.is_some() { span.end - span.start } else { f64::INFINITY }.min(LONGEST_STEP),
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
        series.rates.set(0, state.rates.high * Row::splat(terms.unit));
        for (image, vector) in series.images.iter_mut().zip(&self.vectors) {
            image.set(0, Row::from_vector(state.to_body(vector).into()));
        }
        if let Some(gradient) = self.gradient {
            let Carried { time, .. } = state;
            series.radial.set(0, Row::from_vector(state.to_body(&gradient.radial_at(time.high, time.low)).into()));
            series.pole.set(0, Row::from_vector(state.to_body(&Vector3::z()).into()));
        }
        if let Some((driven, euler)) = &self.driven {
            series.drive = Some(Box::new(Drive::new(driven, euler, state.time, terms.unit)));
        }
        (self.recurrence)(terms, series, order);
        if self.translation != Translation::Unwanted {
            series.position[0] = state.position.high;
            series.velocity[0] = state.velocity.high * Row::splat(terms.unit);
        }
        let is_driven = series.drive.as_ref().is_some_and(|drive| drive.moves());
        match self.translation {
            Translation::Unwanted => {}
            _ if is_driven => driven(terms, series, order),
            Translation::Fall => fall(terms, series),
            Translation::Thrust => thrust(terms, series, order),
        }
    }

    /// A unit of time near the first step's length, from how fast things happen in a state.
    pub fn unit_at(&self, state: &Carried) -> f64 {
        let (terms, mut series) = (self.terms, Series::new());
        self.expand(state, &terms, &mut series, 1);
        let turning = series.rates.rows[0].magnitude().max(series.rates.rows[1].magnitude().sqrt());
        let fading = terms.damping.magnitude();
        let rotor = series.drive.as_ref().map_or(0.0, |drive| drive.turning());
        let fastest = turning.max(fading).max(terms.mean_motion.abs()).max(rotor);
        power_of_two((1.0 / fastest).min(self.longest_unit))
    }
}
