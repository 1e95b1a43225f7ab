use nalgebra::{UnitQuaternion, Vector3};

use super::axes::{conjugate_times, rotated, times_inverse};
use super::{Push, Symbols};
use crate::numerics::{Node, Tape};

/// Quaternion feedback `[Wie08]`: u = −k s e − d ω, e the vector part of the quaternion from the target to the body
/// and s = ±1 the way round; each component, in body axes, passes a dead band and a limit. Both are continuous.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QuaternionFeedback {
    /// World from body.
    pub target: UnitQuaternion<f64>,
    /// k, N m.
    pub stiffness: f64,
    /// d, N m s.
    pub damping: f64,
    /// Largest moment about each body axis, N m; infinity for none.
    pub limit: f64,
    /// What is taken off each component, and below which it is zero, N m.
    pub dead_band: f64,
    /// s: 1, or −1 where the body is more than half a turn from the target by e alone at t = 0.
    pub way: f64,
    /// The body axes.
    pub body_from_principal: UnitQuaternion<f64>,
}

impl QuaternionFeedback {
    pub(super) fn lay_out(&self, tape: &mut Tape, symbols: &Symbols) -> Push {
        let turn = self.body_from_principal;
        let attitude = times_inverse(tape, symbols.attitude, turn);
        let error = conjugate_times(tape, self.target, attitude);
        let rates = rotated(tape, turn, symbols.rates);
        let (stiffness, damping) = (tape.constant(-self.stiffness * self.way), tape.constant(-self.damping));
        let (pull, brake) = (tape.scaled(stiffness, error), tape.scaled(damping, rates));
        let asked = tape.sums(pull, brake);
        let given = asked.map(|u| {
            let u = beyond(tape, u, self.dead_band);
            within(tape, u, self.limit)
        });
        let moment = rotated(tape, turn.inverse(), given);
        Push::moment(tape, moment)
    }
}

/// Rate feedback: u = −d ω, each component in body axes within a limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RateFeedback {
    /// d, N m s.
    pub gain: f64,
    /// Largest moment about each body axis, N m; infinity for none.
    pub limit: f64,
    /// The body axes.
    pub body_from_principal: UnitQuaternion<f64>,
}

impl RateFeedback {
    pub(super) fn lay_out(&self, tape: &mut Tape, symbols: &Symbols) -> Push {
        let turn = self.body_from_principal;
        let (rates, gain) = (rotated(tape, turn, symbols.rates), tape.constant(-self.gain));
        let asked = tape.scaled(gain, rates);
        let given = asked.map(|u| within(tape, u, self.limit));
        let moment = rotated(tape, turn.inverse(), given);
        Push::moment(tape, moment)
    }
}

/// B-dot: coils along the body axes with moments m = −k dB/dt, each within a limit, in a field that the world has; τ = m × B.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BDot {
    /// k, A m² s/T.
    pub gain: f64,
    /// Largest moment of each coil, A m²; infinity for none.
    pub limit: f64,
    /// B at t = 0, world axes, T.
    pub field: Vector3<f64>,
    /// How the field turns in the world, world axes, rad/s.
    pub turning: Vector3<f64>,
    /// The body axes.
    pub body_from_principal: UnitQuaternion<f64>,
}

impl BDot {
    pub(super) fn lay_out(&self, tape: &mut Tape, symbols: &Symbols) -> Push {
        let turn = self.body_from_principal;
        let in_world = self.field_at(tape, symbols.time);
        let turning = tape.vector(self.turning);
        let change_in_world = tape.cross(turning, in_world);
        let (field, change) = (symbols.to_body(tape, in_world), symbols.to_body(tape, change_in_world));
        let dragged = tape.cross(symbols.rates, field);
        let change = tape.differences(change, dragged);
        let (change, gain) = (rotated(tape, turn, change), tape.constant(-self.gain));
        let asked = tape.scaled(gain, change);
        let given = asked.map(|m| within(tape, m, self.limit));
        let dipole = rotated(tape, turn.inverse(), given);
        let moment = tape.cross(dipole, field);
        Push::moment(tape, moment)
    }

    /// B, turned about n by Ωt: B₁ + B₂ cos Ωt + n × B sin Ωt, B₁ along n and B₂ across.
    fn field_at(&self, tape: &mut Tape, time: Node) -> [Node; 3] {
        let rate = self.turning.norm();
        if rate == 0.0 {
            return tape.vector(self.field);
        }
        let axis = self.turning / rate;
        let along = axis * axis.dot(&self.field);
        let [still, swung, ahead] = [along, self.field - along, axis.cross(&self.field)].map(|v| tape.vector(v));
        let factor = tape.constant(rate);
        let phase = tape.product(factor, time);
        let (sine, cosine) = tape.sine_cosine(phase);
        let (swung, ahead) = (tape.scaled(cosine, swung), tape.scaled(sine, ahead));
        let turned = tape.sums(swung, ahead);
        tape.sums(still, turned)
    }
}

/// u between −limit and limit.
fn within(tape: &mut Tape, u: Node, limit: f64) -> Node {
    if limit == f64::INFINITY {
        return u;
    }
    let (most, least) = (tape.constant(limit), tape.constant(-limit));
    let below = tape.smaller(u, most);
    tape.larger(below, least)
}

/// What is beyond a band about zero: u − d above d, u + d below −d, and 0 between.
fn beyond(tape: &mut Tape, u: Node, band: f64) -> Node {
    if band == 0.0 {
        return u;
    }
    let inside = within(tape, u, band);
    tape.difference(u, inside)
}
