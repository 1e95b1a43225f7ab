use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};

use super::pushed::{Pushed, PushedSince, WIDTH};
use super::series::Series;
use crate::body::{AngularVelocity, Attitude, State};
use crate::dynamics::{Problem, Torque, Window, momentum_in_world, rotational_energy};
use crate::propagation::{Dop853, FreeRotation, PropagationError, Propagator, States, Taylor};
use crate::scenario::{Method, PlannedBody, ScenarioError};

/// The body that a file is held against, and the file's states in its principal axes.
pub(super) struct Subject<'a> {
    pub body: &'a PlannedBody,
    /// World from principal axes; empty where no attitude was recorded.
    pub attitude: Vec<UnitQuaternion<f64>>,
    /// Principal axes, rad/s.
    pub omega: Vec<Vector3<f64>>,
    /// What the file says acts, beside the body's own loads.
    pub pushed: Option<Arc<Pushed>>,
}

/// World from principal axes, and ω in them, rad/s.
pub(super) type Place = (UnitQuaternion<f64>, Vector3<f64>);

/// Per step, rad: below it nothing is gained.
const TIGHTEST: f64 = 1e-17;
/// The same under a recorded moment, whose polynomials do not fit each other closer.
const PUSHED: f64 = 1e-12;

impl<'a> Subject<'a> {
    pub fn new(body: &'a PlannedBody, series: &Series, pushed: Option<&Arc<Pushed>>) -> Self {
        let principal = body.properties.body_from_principal;
        Self {
            body,
            attitude: series.attitude.iter().map(|q| q * principal).collect(),
            omega: series.omega.iter().map(|rate| principal.inverse_transform_vector(rate)).collect(),
            pushed: pushed.map(Arc::clone),
        }
    }

    pub fn problem(&self) -> &Problem {
        &self.body.problem
    }

    pub fn is_free(&self) -> bool {
        self.problem().loads.is_empty() && self.pushed.is_none()
    }

    /// All that turns the body at a time, principal axes, N m.
    pub fn moment(&self, time: f64, state: &State) -> Vector3<f64> {
        let pushed = self.pushed.as_ref().map_or_else(Vector3::zeros, |pushed| pushed.at(time, state, WIDTH));
        self.problem().moment(time, state) + pushed
    }

    /// Sample `k` as a state; without attitudes: as if body axes lay along world axes.
    pub fn state(&self, k: usize) -> State {
        state(self.attitude.get(k).copied().unwrap_or_default(), self.omega[k])
    }

    /// L in world axes, N m s.
    pub fn momentum(&self, k: usize) -> Vector3<f64> {
        momentum_in_world(self.problem().moments, &self.state(k))
    }

    /// J.
    pub fn energy(&self, k: usize) -> f64 {
        rotational_energy(self.problem().moments, &self.state(k))
    }

    /// Where exact motion leads from `state` at `time` within `duration`, s.
    pub fn carried(&self, state: State, time: f64, duration: f64) -> Result<State, PropagationError> {
        let (problem, world_from_turned) = self.problem_from(state, time);
        let mut states = States::default();
        if let Some(pushed) = &self.pushed {
            let model = Box::new(PushedSince(Arc::clone(pushed), time));
            Dop853::with_model(&problem, model, PUSHED)?.fill(&[duration], &mut states)?;
        } else if problem.loads.is_empty() {
            FreeRotation::new(&problem)?.fill(&[duration], &mut states)?;
        } else {
            Taylor::new(&problem, TIGHTEST)?.fill(&[duration], &mut states)?;
        }
        let (q, omega) = row(&states, 0);
        Ok(self::state(world_from_turned * q, omega))
    }

    /// Attitudes and ω of the exact motion from `state`, at `times` of which the first is the state's own.
    pub fn trajectory(&self, state: State, times: &[f64]) -> Result<Vec<Place>, ScenarioError> {
        let Some(&start) = times.first() else { return Ok(Vec::new()) };
        let (problem, world_from_turned) = self.problem_from(state, start);
        let since: Vec<f64> = times.iter().map(|time| time - start).collect();
        let mut states = States::default();
        if let Some(pushed) = &self.pushed {
            let model = Box::new(PushedSince(Arc::clone(pushed), start));
            Dop853::with_model(&problem, model, PUSHED)?.fill(&since, &mut states)?;
        } else {
            let body = PlannedBody { problem, moves: false, ..self.body.clone() }.by(Method::Auto, None)?;
            body.propagator()?.fill(&since, &mut states)?;
        }
        let turned_back = |k| {
            let (q, omega) = row(&states, k);
            (world_from_turned * q, omega)
        };
        Ok((0..times.len()).map(turned_back).collect())
    }

    /// The same body from another state at another time: windows shifted, and the world turned with an orbit, so that the
    /// attracting centre lies where it does at t = 0.
    fn problem_from(&self, state: State, time: f64) -> (Problem, UnitQuaternion<f64>) {
        let mut problem = self.problem().clone();
        problem.wants_attitude = true;
        problem.wants_translation = false;
        let orbit = problem.loads.iter().find_map(|load| match load.torque {
            Torque::GravityGradient { mean_motion } => Some(mean_motion),
            _ => None,
        });
        let angle = orbit.unwrap_or(0.0) * time;
        let world_from_turned = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), angle);
        for load in &mut problem.loads {
            load.window = Window { start: load.window.start - time, end: load.window.end - time };
            if let Some(profile) = load.torque.profile_mut() {
                *profile = Arc::new(profile.earlier_by(time));
            }
            let back = world_from_turned.inverse();
            match &mut load.torque {
                Torque::ProfileWorld { moment: vector } | Torque::ForceProfileWorld { force: vector, .. } => {
                    *vector = Arc::new(vector.transformed(back.to_rotation_matrix().matrix()));
                }
                Torque::ConstantWorld { moment } => *moment = world_from_turned.inverse() * *moment,
                Torque::MagneticDipole { field: force, .. } | Torque::ForceWorld { force, .. } => {
                    *force = world_from_turned.inverse() * *force;
                }
                _ => {}
            }
        }
        let attitude = world_from_turned.inverse() * state.attitude.world_from_body();
        problem.initial = self::state(attitude, state.angular_velocity.in_body());
        (problem, world_from_turned)
    }
}

pub(super) fn state(attitude: UnitQuaternion<f64>, omega: Vector3<f64>) -> State {
    State {
        attitude: Attitude::from_world_from_body(attitude),
        angular_velocity: AngularVelocity::from_vector(omega),
        position: Vector3::zeros(),
        velocity: Vector3::zeros(),
    }
}

fn row(states: &States, k: usize) -> (UnitQuaternion<f64>, Vector3<f64>) {
    let [w, x, y, z] = states.attitude.each_ref().map(|column| column[k]);
    let q = UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(w, x, y, z));
    (q, Vector3::from(states.angular_velocity.each_ref().map(|column| column[k])))
}
