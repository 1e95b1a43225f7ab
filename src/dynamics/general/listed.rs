use super::{Push, Symbols};
use crate::body::PrincipalMoments;
use crate::dynamics::{Profile, Torque};
use crate::numerics::{Node, Tape};

impl Torque {
    /// The same load as operations: what [`Self::moment`] and [`Self::force`] say, term by term, of a function of time
    /// from `time` in s until its next knot.
    pub fn lay_out(&self, tape: &mut Tape, symbols: &Symbols, moments: PrincipalMoments, time: f64) -> Push {
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
            Self::ProfileBody { ref moment } => {
                let [moment, _] = cubic(tape, symbols, moment, time);
                Push::moment(tape, moment)
            }
            Self::ProfileWorld { ref moment } => {
                let [in_world, _] = cubic(tape, symbols, moment, time);
                let moment = symbols.to_body(tape, in_world);
                Push::moment(tape, moment)
            }
            Self::ForceProfileBody { ref force, arm } => {
                let [in_body, _] = cubic(tape, symbols, force, time);
                let (arm, force) = (tape.vector(arm), symbols.to_world(tape, in_body));
                Push { moment: tape.cross(arm, in_body), force }
            }
            Self::ForceProfileWorld { ref force, arm } => {
                let [force, _] = cubic(tape, symbols, force, time);
                Push::force(tape, symbols, force, arm)
            }
            Self::Rotor { ref momentum } => {
                let [momentum, driven] = cubic(tape, symbols, momentum, time);
                let turned = tape.cross(momentum, symbols.rates);
                let moment = tape.differences(turned, driven);
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

/// A function of time and its derivative, by the cubic that holds at `time`, s.
fn cubic(tape: &mut Tape, symbols: &Symbols, profile: &Profile, time: f64) -> [[Node; 3]; 2] {
    let (knot, cubic) = profile.piece(time);
    let knot = tape.constant(knot);
    let passed = tape.difference(symbols.time, knot);
    let [first, second, third, fourth] = cubic.map(|coefficients| tape.vector(coefficients));
    let [two, three] = [2.0, 3.0].map(|factor| tape.constant(factor));
    let horner = |tape: &mut Tape, sum: [Node; 3], next: [Node; 3]| {
        let raised = tape.scaled(passed, sum);
        tape.sums(raised, next)
    };
    let (twice, thrice) = (tape.scaled(two, third), tape.scaled(three, fourth));
    let [bend, slope] = [(fourth, third), (thrice, twice)].map(|(high, low)| horner(tape, high, low));
    let rising = horner(tape, bend, second);
    [horner(tape, rising, first), horner(tape, slope, second)]
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
