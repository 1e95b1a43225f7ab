//! What two motions are apart, and how far a rounding of the start moves one.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use polhode::body::{AngularVelocity, Attitude, PrincipalMoments, State};
use polhode::dynamics::Problem;
use polhode::numerics::DoubleDouble;
use polhode::propagation::{FreeRotation, PreciseTaylor, Propagator};

use crate::motions::{run, state};

/// How far apart, rad and rad/s.
#[derive(Debug, Clone, Copy)]
pub struct Apart {
    pub angle: f64,
    pub rate: f64,
}

impl Apart {
    pub fn of(left: &State, right: &State) -> Self {
        let rate = left.angular_velocity.in_body() - right.angular_velocity.in_body();
        Self { angle: left.attitude.angle_to(right.attitude), rate: rate.norm() }
    }

    /// Whether it is within `angle` and, of a body that turns at `speed`, the same part of that.
    pub fn is_within(self, angle: f64, speed: f64) -> bool {
        self.angle <= angle && self.rate <= angle * speed
    }
}

/// |ω| at the start, rad/s.
pub fn speed(problem: &Problem) -> f64 {
    problem.initial.angular_velocity.in_body().norm()
}

/// The torque-free state at `time`, s.
pub fn free_state(problem: &Problem, time: f64) -> State {
    at(FreeRotation::new(problem).expect("nothing acts"), time)
}

/// The state at `time`, s.
pub fn at(propagator: impl Propagator, time: f64) -> State {
    state(&run(propagator, &[time]), 0)
}

/// The same problem from another state.
pub fn from(problem: &Problem, state: State) -> Problem {
    Problem { initial: state, ..problem.clone() }
}

/// The same problem with one number off by a rounding: a rate, a moment or a part of the quaternion.
fn nudged(problem: &Problem, which: usize) -> Option<Problem> {
    let mut problem = problem.clone();
    match which {
        0..3 => {
            let mut rates = problem.initial.angular_velocity.in_body();
            rates[which] *= 1.0 + f64::EPSILON;
            problem.initial.angular_velocity = AngularVelocity::from_vector(rates);
        }
        3..6 => {
            // Moments that are equal stay so: of a top they must be.
            let moments = problem.moments.vector();
            let one = moments[which - 3];
            let off = |moment: f64| if moment == one { one * (1.0 + f64::EPSILON) } else { moment };
            problem.moments = PrincipalMoments::new(moments.map(off).into()).ok()?;
        }
        _ => {
            let turn = Vector3::ith(which - 6, f64::EPSILON);
            let attitude = UnitQuaternion::from_scaled_axis(turn) * problem.initial.attitude.world_from_body();
            problem.initial.attitude = Attitude::from_world_from_body(attitude);
        }
    }
    Some(problem)
}

/// How far roundings of the start and of the moments move a state: the sum over what a rounding of each moves it.
pub fn sensitivity(problem: &Problem, motion: impl Fn(&Problem) -> State) -> Apart {
    let exact = motion(problem);
    let moved = (0..9).filter_map(|which| nudged(problem, which)).map(|near| Apart::of(&exact, &motion(&near)));
    moved.fold(Apart { angle: 0.0, rate: 0.0 }, |sum, apart| Apart {
        angle: sum.angle + apart.angle,
        rate: sum.rate + apart.rate,
    })
}

/// The rate at which motions near the saddle of this energy part at most, or the spin where that is more, 1/s.
pub fn parting(problem: &Problem) -> f64 {
    let mut moments: [f64; 3] = problem.moments.vector().into();
    moments.sort_by(f64::total_cmp);
    let [low, middle, high] = moments;
    // The energy on the middle axis.
    let spin = (2.0 * energy(problem, &problem.initial) / middle).sqrt();
    (spin * ((high - middle) * (middle - low) / (low * high)).sqrt()).max(speed(problem))
}

/// The state at `time` in double-double, rounded; `None` if that takes too long.
pub fn precise(problem: &Problem, time: f64) -> Option<State> {
    let mut motion = PreciseTaylor::new(problem).expect("covered").limited_to(400);
    let state = motion.at(time).expect("a motion that goes on")?;
    let [w, x, y, z] = state.attitude.map(DoubleDouble::hi);
    Some(State {
        attitude: Attitude::from_world_from_body(UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z))),
        angular_velocity: AngularVelocity::from_vector(Vector3::from(state.angular_velocity.map(DoubleDouble::hi))),
        ..problem.initial
    })
}

/// R I ω, world axes.
pub fn momentum(problem: &Problem, state: &State) -> Vector3<f64> {
    state.angular_velocity.momentum(problem.moments).in_world(state.attitude)
}

/// ½ ω·Iω.
pub fn energy(problem: &Problem, state: &State) -> f64 {
    polhode::dynamics::rotational_energy(problem.moments, state)
}
