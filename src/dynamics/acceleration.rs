use nalgebra::Vector3;

use super::torque::radial_direction;
use super::{EulerEquations, Problem, Torque};
use crate::body::State;

impl Problem {
    /// ω̇ at `time` in s, rad/s², principal axes; `inner` is σ of a sphere inside the body, if there is one.
    ///
    /// I ω̇ = (I ω) × ω + τ of all loads, rotors among them; of a body with a sphere inside, that of the shell: I less the
    /// sphere's moment, and c σ beside τ.
    #[must_use]
    pub fn angular_acceleration(&self, time: f64, state: &State, inner: &Vector3<f64>) -> Vector3<f64> {
        let moment = self.loads.iter().map(|load| load.moment(self.moments, time, state)).sum::<Vector3<f64>>();
        let omega = state.angular_velocity.in_body();
        match self.inner_sphere() {
            None => EulerEquations::new(self.moments).acceleration(&omega, &moment),
            Some(sphere) => EulerEquations::around(sphere.inertia, self.moments)
                .acceleration(&omega, &(moment + sphere.coefficient * inner)),
        }
    }

    /// What the loads give the reference point of a free body at `time` in s beside gravity, m/s², world axes: its
    /// specific force.
    #[must_use]
    pub fn load_acceleration(&self, time: f64, state: &State) -> Vector3<f64> {
        let force = self.loads.iter().map(|load| load.force(time, state)).sum::<Vector3<f64>>();
        // Without a mass there is no force.
        self.mass.map_or(force, |mass| force / mass)
    }

    /// By how much gravity is stronger at `arm` from the reference point than there, at `time` in s, m/s²; all in principal
    /// axes. Of a body in orbit n² (3 r̂ (r̂·ρ) − ρ); uniform gravity has no such gradient.
    #[must_use]
    pub fn gravity_difference(&self, time: f64, state: &State, arm: &Vector3<f64>) -> Vector3<f64> {
        let acting = self.loads.iter().filter(|load| load.window.contains(time));
        let difference = |torque: &Torque| match *torque {
            Torque::GravityGradient { mean_motion } => {
                let radial = state.attitude.to_body(&radial_direction(mean_motion, time));
                mean_motion * mean_motion * (3.0 * radial.dot(arm) * radial - arm)
            }
            _ => Vector3::zeros(),
        };
        acting.map(|load| difference(&load.torque)).sum()
    }
}
