//! Parts of a motion, in memory: 4096 samples over 41 s.

use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};
use polhode::dynamics::formula::Expression;
use polhode::dynamics::{FormulaLoad, FormulaPlace, General, GeneralLoad, Load, Problem, Torque, Window};
use polhode::propagation::{FreeRotation, Propagator, States, Taylor};
use polhode::telemetry::{BodySamples, Channel, Derivation};

use super::problems::{MOMENTS, RATES, free, pushed, times};
use super::{Pair, Work};

const COUNT: u32 = 4096;

pub fn pairs() -> Vec<Pair> {
    let body = || free(MOMENTS, RATES);
    let rates = |problem: Problem| Problem { wants_attitude: false, ..problem };
    let moving = |problem: Problem| Problem { wants_translation: true, ..problem };
    let turned = UnitQuaternion::from_scaled_axis(Vector3::new(0.3, 0.2, 0.1));
    let aligned = UnitQuaternion::identity();
    let pair = |left_out, of, with, without| Pair { left_out, of, with, without };
    let (plain, six) = (&SIX[..2], &SIX[..]);
    vec![
        pair("attitude", "closed form", closed_form(body()), closed_form(rates(body()))),
        pair("attitude", "Taylor, moment in the body", taylor(pushed()), taylor(rates(pushed()))),
        pair("translation", "Taylor, moment in the body", taylor(moving(pushed())), taylor(pushed())),
        pair("steps: nothing acts", "Taylor, torque-free", taylor(body()), closed_form(body())),
        pair("torque code: nothing acts", "Taylor, force in the world", taylor(nudged(1.0)), taylor(body())),
        pair("torque code outside its window", "Taylor, a tenth inside", taylor(nudged(1.0)), taylor(nudged(0.1))),
        pair("operations that a recurrence knows", "Taylor, a moment as formula", taylor(told()), taylor(pushed())),
        pair("turning back", "attitude and ω from principal axes", derive(turned, plain), derive(aligned, plain)),
        pair("four of six channels", "columns from states", derive(aligned, six), derive(aligned, plain)),
    ]
}

const SIX: [Channel; 6] = [
    Channel::Attitude,
    Channel::AngularVelocity,
    Channel::AngularMomentumWorld,
    Channel::RotationalEnergy,
    Channel::EnergyDrift,
    Channel::MomentumDrift,
];

/// The moment of [`pushed`] as a formula.
fn told() -> Problem {
    let mut problem = pushed();
    for load in &mut problem.loads {
        if let Torque::ConstantBody { moment } = load.torque {
            let component = |value: f64| Expression::read(&format!("{value}")).expect("a number");
            let formula = FormulaLoad {
                components: <[f64; 3]>::from(moment).map(component),
                in_world: false,
                place: FormulaPlace::Moment,
                body_from_principal: UnitQuaternion::identity(),
            };
            load.torque = Torque::General(Arc::new(GeneralLoad::new(General::Formula(formula))));
        }
    }
    problem
}

/// A force too small to be felt, for a share of the run: the motion and its steps are those of the free body.
fn nudged(share: f64) -> Problem {
    let torque = Torque::ForceWorld { force: Vector3::new(0.0, 0.0, -1e-30), arm: Vector3::new(0.1, 0.2, 0.3) };
    let end = if share < 1.0 { share * 0.01 * f64::from(COUNT) } else { f64::INFINITY };
    let mut problem = free(MOMENTS, RATES);
    problem.loads.push(Load { torque, window: Window { start: f64::NEG_INFINITY, end } });
    problem
}

fn closed_form(problem: Problem) -> Work {
    filled(problem, |problem| Box::new(FreeRotation::new(problem).expect("nothing acts")))
}

fn taylor(problem: Problem) -> Work {
    filled(problem, |problem| Box::new(Taylor::new(problem, 1e-16).expect("it is covered")))
}

fn filled(problem: Problem, fresh: fn(&Problem) -> Box<dyn Propagator>) -> Work {
    let (times, mut states) = (times(COUNT), States::default());
    Box::new(move || fresh(&problem).fill(&times, &mut states).expect("a finite motion"))
}

fn derive(body_from_principal: UnitQuaternion<f64>, channels: &[Channel]) -> Work {
    let problem = free(MOMENTS, RATES);
    let (times, mut states, mut samples) = (times(COUNT), States::default(), BodySamples::new(channels));
    FreeRotation::new(&problem).expect("nothing acts").fill(&times, &mut states).expect("a finite motion");
    let derivation = Derivation::new(&problem, body_from_principal);
    Box::new(move || derivation.derive(&times, &states, &mut samples))
}
