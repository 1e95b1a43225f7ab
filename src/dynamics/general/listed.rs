use super::{Push, Symbols};
use crate::body::PrincipalMoments;
use crate::dynamics::Torque;
use crate::numerics::{Node, Tape};

impl Torque {
    /// The same load as operations: what [`Self::moment`] and [`Self::force`] say, term by term.
    pub fn lay_out(&self, tape: &mut Tape, symbols: &Symbols, moments: PrincipalMoments) -> Push {
        match *self {
            Self::ConstantBody { moment } => {
                let moment = tape.vector(moment);
                Push::moment(tape, moment)
            }
            Self::ConstantWorld { moment } => {
                let in_world = tape.vector(moment);
                let moment = symbols.to_body(tape, in_world);
                Push::moment(tape, moment)
            }
            Self::LinearDamping { coefficient } => {
                let opposite = tape.constant(-coefficient);
                let moment = tape.scaled(opposite, symbols.rates);
                Push::moment(tape, moment)
            }
            Self::MomentumBrake { rate } => {
                let (opposite, inertia) = (tape.constant(-rate), tape.vector(moments.vector()));
                let momentum = [0, 1, 2].map(|i| tape.product(inertia[i], symbols.rates[i]));
                let moment = tape.scaled(opposite, momentum);
                Push::moment(tape, moment)
            }
            Self::ForceBody { force, arm } => {
                let in_body = tape.vector(force);
                let (arm, force) = (tape.vector(arm), symbols.to_world(tape, in_body));
                Push { moment: tape.cross(arm, in_body), force }
            }
            Self::ForceWorld { force, arm } => {
                let force = tape.vector(force);
                Push::force(tape, symbols, force, arm)
            }
            Self::MagneticDipole { dipole, field } => {
                let (dipole, field) = (tape.vector(dipole), tape.vector(field));
                let in_body = symbols.to_body(tape, field);
                let moment = tape.cross(dipole, in_body);
                Push::moment(tape, moment)
            }
            Self::GravityGradient { mean_motion } => {
                let moment = gradient(tape, symbols, moments, mean_motion);
                Push::moment(tape, moment)
            }
            Self::General(ref load) => load.kind.lay_out(tape, symbols),
        }
    }
}

/// 3 n² r × I r, r = Rᵀ (cos nt, sin nt, 0).
fn gradient(tape: &mut Tape, symbols: &Symbols, moments: PrincipalMoments, mean_motion: f64) -> [Node; 3] {
    let (rate, three, zero) = (tape.constant(mean_motion), tape.constant(3.0), tape.constant(0.0));
    let (phase, square) = (tape.product(rate, symbols.time), tape.product(rate, rate));
    let (strength, (sine, cosine)) = (tape.product(three, square), tape.sine_cosine(phase));
    let (radial, inertia) = (symbols.to_body(tape, [cosine, sine, zero]), tape.vector(moments.vector()));
    [(1, 2), (2, 0), (0, 1)].map(|(j, k)| {
        let (difference, product) = (tape.difference(inertia[k], inertia[j]), tape.product(radial[j], radial[k]));
        let factor = tape.product(strength, difference);
        tape.product(factor, product)
    })
}
