use super::carried::Carried;
use super::dense::{LANES, Polynomials, normalise};
use super::series::{Rows, Series};
use super::step_size::{LONGEST_STEP, order_for, power_of_two, step_ratio};
use super::stretch::Stretch;
use super::sums::{Instant, Sums};
use super::terms::Terms;
use crate::dynamics::{DynamicsError, EulerEquations, Problem, Schedule};
use crate::numerics::vectorised;
use crate::propagation::sampling::check_times;
use crate::propagation::{Effort, PropagationError, Propagator, States};

/// The motion is the same however long q is, and samples are brought to unit length anyway: q need only stay near it.
const STEPS_BETWEEN_NORMALISATIONS: u64 = 16;

/// Motion under loads whose equations are bilinear: see [`Taylor`](super::Taylor). The state is carried in compensated sums.
#[derive(Debug, Clone)]
pub(super) struct Bilinear {
    euler: EulerEquations,
    schedule: Schedule,
    /// The current span's number, and what its series needs.
    current: usize,
    stretch: Stretch,
    with_attitude: bool,
    order: usize,
    tolerance: f64,
    wants_attitude: bool,
    wants_translation: bool,
    /// The motion from `start` to `end`; no time passes between them before the first step.
    series: Series,
    terms: Terms,
    start: Carried,
    end: Carried,
    /// The series' unit of time for the next step, s.
    unit: f64,
    latest: f64,
    effort: Effort,
}

impl Bilinear {
    /// From a problem and the error allowed per step, between 0 and 1.
    pub fn new(problem: &Problem, tolerance: f64) -> Result<Self, DynamicsError> {
        let schedule = Schedule::new(problem)?;
        let with_attitude = problem.wants_attitude || schedule.needs_attitude();
        let euler = EulerEquations::new(problem.moments);
        let stretch = Stretch::new(&euler, &schedule.span(0), with_attitude, problem.wants_translation);
        let start = Carried::new(&problem.initial);
        let unit = stretch.unit_at(&start);
        Ok(Self {
            euler,
            schedule,
            current: 0,
            with_attitude,
            order: order_for(tolerance),
            tolerance,
            wants_attitude: problem.wants_attitude,
            wants_translation: problem.wants_translation,
            series: Series::new(),
            terms: stretch.terms_in(unit),
            stretch,
            start,
            end: start,
            unit,
            latest: 0.0,
            effort: Effort::default(),
        })
    }

    pub fn order(&self) -> usize {
        self.order
    }

    /// Goes on towards `time`, s, by so many steps at most; how far it has come, s. Earlier times are then past.
    pub fn reach(&mut self, time: f64, steps: u64) -> Result<f64, PropagationError> {
        let limit = self.effort.steps.saturating_add(steps);
        while self.end.time.until(time) > 0.0 && self.effort.steps < limit {
            self.advance()?;
        }
        self.latest = self.latest.max(self.end.time.high.min(time));
        Ok(self.latest)
    }

    /// Makes one step.
    fn advance(&mut self) -> Result<(), PropagationError> {
        if self.end.time.until(self.stretch.end) <= 0.0 {
            // The last span ends at infinity, so there is a next one.
            self.current += 1;
            let span = self.schedule.span(self.current);
            self.stretch = Stretch::new(&self.euler, &span, self.with_attitude, self.wants_translation);
            self.series = Series::new();
            self.unit = self.stretch.unit_at(&self.end);
            self.terms = self.stretch.terms_in(self.unit);
        }
        let stretch = &self.stretch;
        if self.unit != self.terms.unit {
            self.terms = stretch.terms_in(self.unit);
        }
        stretch.expand(&self.end, &self.terms, &mut self.series, self.order);
        self.effort.evaluations += 1;
        self.start = self.end;
        let ends_at = stretch.end;
        let step = vectorised(
            #[inline(always)]
            || self.leap(ends_at),
        );
        let time = self.start.time.high;
        let finite = self.end.is_finite();
        // The sums could count on, but no f64 sample time could tell such steps apart.
        let stuck = time + step == time && self.end.time.high != ends_at;
        if stuck || !finite {
            // What is asked for again must not come from a series that went nowhere.
            self.series = Series::new();
            self.end = self.start;
            let too_small = PropagationError::StepTooSmall { time, step };
            return Err(if finite { too_small } else { PropagationError::NotFinite { time } });
        }
        self.unit = power_of_two(step);
        self.effort.include_step(step);
        Ok(())
    }

    /// Moves the end of the step as far as the series reaches, but not past `ends_at`; returns the step, s.
    #[inline(always)]
    fn leap(&mut self, ends_at: f64) -> f64 {
        let remaining = self.start.time.until(ends_at);
        let step = self.unit * step_ratio(&self.series, self.order, self.tolerance);
        let step = step.min(remaining).min(LONGEST_STEP);
        let sigma = step / self.terms.unit;
        let time = if step == remaining { Instant::new(ends_at) } else { self.start.time.after(step) };
        self.end.time = time;
        self.end.rates = self.rates().after(sigma);
        self.end.attitude = self.attitude().after(sigma);
        if self.effort.steps.is_multiple_of(STEPS_BETWEEN_NORMALISATIONS) {
            self.end.normalise();
        }
        if self.wants_translation {
            self.end.position = self.position().after(sigma);
            self.end.velocity = self.velocity().after(sigma);
        }
        step
    }

    /// Writes the states at times within the current step, from row `first` on.
    #[inline(always)]
    fn sample(&self, times: &[f64], first: usize, states: &mut States) {
        let mut rows = first..first;
        for times in times.chunks(LANES) {
            rows = rows.end..rows.end + times.len();
            let mut sigmas = [0.0; LANES];
            for (sigma, time) in sigmas.iter_mut().zip(times) {
                *sigma = self.start.time.until(*time) / self.terms.unit;
            }
            self.rates().write(&sigmas, &mut states.angular_velocity, &rows);
            if self.wants_attitude {
                self.attitude().write(&sigmas, &mut states.attitude, &rows);
                normalise(&mut states.attitude, rows.clone());
            }
            if self.wants_translation {
                self.position().write(&sigmas, &mut states.position, &rows);
                self.velocity().write(&sigmas, &mut states.velocity, &rows);
            }
        }
    }

    #[inline(always)]
    fn attitude(&self) -> Polynomials<'_> {
        self.polynomials(&self.start.attitude, &self.series.attitude, 1.0)
    }

    #[inline(always)]
    fn rates(&self) -> Polynomials<'_> {
        self.polynomials(&self.start.rates, &self.series.rates.rows, 1.0 / self.terms.unit)
    }

    #[inline(always)]
    fn position(&self) -> Polynomials<'_> {
        self.polynomials(&self.start.position, &self.series.position, 1.0)
    }

    #[inline(always)]
    fn velocity(&self) -> Polynomials<'_> {
        self.polynomials(&self.start.velocity, &self.series.velocity, 1.0 / self.terms.unit)
    }

    #[inline(always)]
    fn polynomials<'a>(&self, start: &'a Sums, rows: &'a Rows, factor: f64) -> Polynomials<'a> {
        Polynomials { start, rows, order: self.order, factor }
    }
}

impl Propagator for Bilinear {
    fn fill(&mut self, times: &[f64], states: &mut States) -> Result<(), PropagationError> {
        check_times(times, self.latest)?;
        states.reset(times.len(), self.wants_attitude, self.wants_translation);
        let mut done = 0;
        while let Some(&time) = times.get(done) {
            while self.end.time.until(time) > 0.0 {
                self.advance()?;
            }
            let within = times[done..].iter().take_while(|time| self.end.time.until(**time) <= 0.0).count();
            vectorised(
                #[inline(always)]
                || self.sample(&times[done..done + within], done, states),
            );
            done += within;
            self.latest = times[done - 1];
        }
        Ok(())
    }

    fn effort(&self) -> Effort {
        self.effort
    }
}
