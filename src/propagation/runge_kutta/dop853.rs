use super::dormand_prince::{DENSE_NODES, DENSE_STAGES, DENSE_WEIGHTS, DORMAND_PRINCE_8, ERROR_3, ERROR_5};
use super::tableau::{combine, weighted};
use crate::dynamics::{Problem, TorqueModel};
use crate::propagation::equations::{ATTITUDE, Equations, POSITION, RATES, VELOCITY, Values, normalise};
use crate::propagation::sampling::check_times;
use crate::propagation::{Effort, PropagationError, Propagator, States};

/// The method of Dormand and Prince of order 8, adaptive, with dense output of order 7 `[HNW93]` §II.10.
///
/// Its steps stop exactly where a load starts or ends, and do not depend on the sample times.
pub struct Dop853 {
    equations: Equations,
    tolerance: f64,
    /// End of the last step, s.
    time: f64,
    /// At `time`.
    values: Values,
    /// Derivative at `time`, unless the loads have changed since.
    derivative: Option<Values>,
    /// The step to try next, s.
    next_step: Option<f64>,
    last: Option<Step>,
    latest: f64,
    /// Evaluations are counted by the equations.
    effort: Effort,
}

/// The last step taken, for dense output.
struct Step {
    start: f64,
    length: f64,
    values: Values,
    /// The twelve stages, the end, and the three stages for dense output.
    derivatives: [Values; 16],
    /// The eight coefficients of the interpolant, once a sample has asked for them.
    interpolant: Option<[Values; 7]>,
}

impl Dop853 {
    /// Shorter steps than this tolerance asks for only collect rounding.
    const TIGHTEST: f64 = 1e-15;
    /// Factors by which the step may change at once, and what keeps it from being refused `[HNW93]` §II.4.
    const SHRINK: f64 = 1.0 / 3.0;
    const GROW: f64 = 6.0;
    const SAFETY: f64 = 0.9;
    /// s: as good as infinite, and its square is still a number.
    const LONGEST_STEP: f64 = 1e100;

    /// From a problem and the error allowed per step: rad of attitude, relative in the rest.
    ///
    /// # Errors
    /// [`PropagationError::NotCovered`] if the tolerance is not between 1e-15 and 1, a force moves a body of unknown
    /// mass, or two orbits act at once.
    pub fn new(problem: &Problem, tolerance: f64) -> Result<Self, PropagationError> {
        Self::build(problem, None, tolerance)
    }

    /// The same with a moment of the caller's own beside the problem's loads; it should be smooth in time.
    ///
    /// # Errors
    /// As for [`Self::new`].
    pub fn with_model(
        problem: &Problem,
        model: Box<dyn TorqueModel + Send>,
        tolerance: f64,
    ) -> Result<Self, PropagationError> {
        Self::build(problem, Some(model), tolerance)
    }

    fn build(
        problem: &Problem,
        model: Option<Box<dyn TorqueModel + Send>>,
        tolerance: f64,
    ) -> Result<Self, PropagationError> {
        let not_covered = |rule| PropagationError::NotCovered { method: "DOP853", rule };
        if !(Self::TIGHTEST..1.0).contains(&tolerance) {
            return Err(not_covered("its tolerance must lie between 1e-15 and 1"));
        }
        let equations = Equations::new(problem, model).map_err(|error| not_covered(error.rule()))?;
        Ok(Self {
            values: equations.initial(),
            equations,
            tolerance,
            time: 0.0,
            derivative: None,
            next_step: None,
            last: None,
            latest: 0.0,
            effort: Effort::default(),
        })
    }

    /// Goes on towards `time`, s, by so many steps at most; how far it has come, s. Earlier times are then past.
    ///
    /// # Errors
    /// If the state ceases to be finite or a step cannot be made small enough.
    pub fn reach(&mut self, time: f64, steps: u64) -> Result<f64, PropagationError> {
        let limit = self.effort.steps.saturating_add(steps);
        while self.time < time && self.effort.steps < limit {
            self.advance()?;
        }
        self.latest = self.latest.max(self.time.min(time));
        Ok(self.latest)
    }

    /// Makes one step, trying until its error is small enough.
    fn advance(&mut self) -> Result<(), PropagationError> {
        if self.time >= self.equations.span().end {
            self.equations.next_span();
            (self.derivative, self.next_step) = (None, None);
        }
        let (time, remaining) = (self.time, self.equations.span().end - self.time);
        let first = self.derivative.unwrap_or_else(|| self.equations.derivative(time, &self.values));
        self.derivative = Some(first);
        let mut step = self.next_step.unwrap_or_else(|| first_step(&self.values, &first, self.tolerance));
        let mut most_growth = Self::GROW;
        loop {
            step = step.min(Self::LONGEST_STEP).min(remaining);
            if time + step <= time {
                return Err(PropagationError::StepTooSmall { time, step });
            }
            let stages = DORMAND_PRINCE_8.derivatives(&mut self.equations, time, step, &self.values, first);
            let mut end = combine(&self.values, step, &DORMAND_PRINCE_8.weights, &stages);
            let error = self.error(step, &stages, &end);
            let factor = if error > 0.0 { Self::SAFETY * libm::pow(error, -1.0 / 8.0) } else { Self::GROW };
            if error <= 1.0 {
                normalise(&mut end);
                self.accept(step, remaining, &stages, end);
                self.next_step = Some(step * factor.clamp(Self::SHRINK, most_growth));
                return Ok(());
            }
            self.effort.rejections += 1;
            most_growth = 1.0;
            if error.is_finite() {
                step *= factor.max(Self::SHRINK);
            } else if first.iter().chain(&self.values).all(|value| value.is_finite()) && time + 0.1 * step > time {
                step *= 0.1;
            } else {
                return Err(PropagationError::NotFinite { time });
            }
        }
    }

    fn accept(&mut self, step: f64, remaining: f64, stages: &[Values; 12], end: Values) {
        let start = self.time;
        self.time = if step == remaining { self.equations.span().end } else { start + step };
        // The last derivative of this step is the first of the next, if the loads stay.
        let last = self.equations.derivative(self.time, &end);
        let mut derivatives = [last; 16];
        derivatives[..12].copy_from_slice(stages);
        self.last = Some(Step { start, length: step, values: self.values, derivatives, interpolant: None });
        (self.values, self.derivative) = (end, Some(last));
        self.effort.include_step(step);
    }

    /// The error of a step in units of what is allowed: estimates of order 5 and 3 combined as in the authors' code.
    fn error(&self, step: f64, stages: &[Values; 12], end: &Values) -> f64 {
        let (fifth, third) = (weighted(&ERROR_5, stages), weighted(&ERROR_3, stages));
        let (mut fifth_sum, mut third_sum, mut count) = (0.0, 0.0, 0.0);
        for range in [RATES, ATTITUDE, POSITION, VELOCITY] {
            let size = largest(&self.values[range.clone()]).max(largest(&end[range.clone()]));
            if size > 0.0 {
                let allowed = self.tolerance * size;
                fifth_sum +=
                    fifth[range.clone()].iter().map(|error| (error / allowed) * (error / allowed)).sum::<f64>();
                third_sum +=
                    third[range.clone()].iter().map(|error| (error / allowed) * (error / allowed)).sum::<f64>();
                count += fifth[range].iter().map(|_| 1.0).sum::<f64>();
            }
        }
        let sum = fifth_sum + 0.01 * third_sum;
        if sum == 0.0 { 0.0 } else { step * fifth_sum / (count * sum).sqrt() }
    }

    /// The values at a time within the last step.
    fn within(&mut self, time: f64) -> Values {
        let end = self.values;
        let Some(step) = self.last.as_mut().filter(|_| time < self.time) else { return end };
        let interpolant = step.interpolant.unwrap_or_else(|| interpolant(&mut self.equations, step, &end));
        step.interpolant = Some(interpolant);
        let theta = (time - step.start) / step.length;
        let mut sum = Values::default();
        for (power, coefficient) in interpolant.iter().enumerate().rev() {
            let factor = if power % 2 == 0 { theta } else { 1.0 - theta };
            sum = std::array::from_fn(|i| (sum[i] + coefficient[i]) * factor);
        }
        let mut values = std::array::from_fn(|i| step.values[i] + sum[i]);
        normalise(&mut values);
        values
    }
}

/// The coefficients of the interpolant, at the price of three more derivatives `[HNW93]` §II.10.
fn interpolant(equations: &mut Equations, step: &mut Step, end: &Values) -> [Values; 7] {
    let Step { start, length, values, derivatives, .. } = step;
    for (stage, (weights, node)) in DENSE_STAGES.iter().zip(DENSE_NODES).enumerate() {
        let moved = combine(values, *length, weights, &derivatives[..]);
        derivatives[13 + stage] = equations.derivative(*start + node * *length, &moved);
    }
    let (first, last) = (derivatives[0], derivatives[12]);
    let mut coefficients = [Values::default(); 7];
    for i in 0..end.len() {
        let change = end[i] - values[i];
        coefficients[0][i] = change;
        coefficients[1][i] = *length * first[i] - change;
        coefficients[2][i] = 2.0 * change - *length * (first[i] + last[i]);
    }
    for (coefficient, weights) in coefficients[3..].iter_mut().zip(&DENSE_WEIGHTS) {
        *coefficient = weighted(weights, &derivatives[..]).map(|value| *length * value);
    }
    coefficients
}

/// A first step to try: such that the body turns by the eighth root of the tolerance, in rad.
fn first_step(values: &Values, derivative: &Values, tolerance: f64) -> f64 {
    let rate = largest(&values[RATES]).max(largest(&derivative[RATES]).sqrt());
    if rate > 0.0 { libm::pow(tolerance, 1.0 / 8.0) / rate } else { 1.0 }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| value.abs().max(most))
}

impl Propagator for Dop853 {
    fn fill(&mut self, times: &[f64], states: &mut States) -> Result<(), PropagationError> {
        check_times(times, self.latest)?;
        self.equations.reset(states, times.len());
        for (row, &time) in times.iter().enumerate() {
            while time > self.time {
                self.advance()?;
            }
            let values = self.within(time);
            self.equations.write(&values, states, row);
            self.latest = time;
        }
        Ok(())
    }

    fn effort(&self) -> Effort {
        Effort { evaluations: self.equations.evaluations, ..self.effort }
    }
}
