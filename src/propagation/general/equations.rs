use crate::dynamics::{Load, Problem, Push, Symbols};
use crate::numerics::{Node, Tape};

/// The equations of motion from `time`, s, while the same loads act and no function of time has a knot: on the inputs of
/// [`Symbols`], the rates of all but time.
pub(super) fn equations(problem: &Problem, time: f64) -> Tape {
    let mut tape = Tape::new(Symbols::INPUTS);
    let symbols = Symbols::on(&mut tape);
    let mut push = Push::none(&mut tape);
    for Load { torque, .. } in problem.loads.iter().filter(|load| load.window.contains(time)) {
        let more = torque.lay_out(&mut tape, &symbols, problem.moments, time);
        push = push.and(&mut tape, more);
    }
    let attitude = attitude_rate(&mut tape, &symbols);
    let rates = acceleration(&mut tape, problem, &symbols, push.moment);
    let zero = tape.constant(0.0);
    let sphere = problem.inner_sphere();
    let inner = sphere.map_or([zero; 3], |sphere| sphere.relative_acceleration(&mut tape, &symbols, rates));
    let (mut position, mut velocity) = ([zero; 3], [zero; 3]);
    if problem.wants_translation {
        let mass = tape.constant(problem.mass.unwrap_or(1.0));
        let gravity = tape.vector(problem.gravity);
        let pushed = push.force.map(|force| if force == zero { zero } else { tape.quotient(force, mass) });
        (position, velocity) = (symbols.velocity, tape.sums(pushed, gravity));
    }
    for node in attitude.into_iter().chain(rates).chain(position).chain(velocity).chain(inner) {
        tape.want(node);
    }
    tape
}

/// Euler's equations of the body without a sphere inside it, with differences of moments: ω̇₁ = (I₂ − I₃)/I₁ · ω₂ω₃ + τ₁/I₁ and cyclic.
fn acceleration(tape: &mut Tape, problem: &Problem, symbols: &Symbols, moment: [Node; 3]) -> [Node; 3] {
    let mut inertia = tape.vector(problem.moments.vector());
    if let Some(sphere) = problem.inner_sphere() {
        let within = tape.constant(sphere.inertia);
        inertia = tape.differences(inertia, [within; 3]);
    }
    let rates = symbols.rates;
    [(0, 1, 2), (1, 2, 0), (2, 0, 1)].map(|(i, j, k)| {
        let (difference, product) = (tape.difference(inertia[j], inertia[k]), tape.product(rates[j], rates[k]));
        let coupling = tape.quotient(difference, inertia[i]);
        let (gyroscopic, pushed) = (tape.product(coupling, product), tape.quotient(moment[i], inertia[i]));
        tape.sum(gyroscopic, pushed)
    })
}

/// q̇ = ½ q (0, ω).
fn attitude_rate(tape: &mut Tape, symbols: &Symbols) -> [Node; 4] {
    let [w, x, y, z] = symbols.attitude;
    let half = tape.constant(0.5);
    let rates = tape.scaled(half, symbols.rates);
    let along = tape.dot([x, y, z], rates);
    let (turned, across) = (tape.scaled(w, rates), tape.cross([x, y, z], rates));
    let [i, j, k] = tape.sums(turned, across);
    [tape.negative(along), i, j, k]
}
