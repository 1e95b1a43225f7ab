use crate::dynamics::SpringCloud;
use crate::numerics::{Node, Tape};

/// Where the inputs of the tape stand: position and velocity of each particle, then of each spring q = ℓ² − ℓ₀² and what
/// d·ḋ lacks in the scalar's digits, which does not change over a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Places {
    pub particles: usize,
    pub springs: usize,
}

impl Places {
    pub fn of(cloud: &SpringCloud) -> Self {
        let particles = cloud.masses().len();
        Self { particles, springs: particles * (particles - 1) / 2 }
    }

    /// Of particle i, the first of three.
    pub fn position(particle: usize) -> usize {
        3 * particle
    }

    pub fn velocity(self, particle: usize) -> usize {
        3 * (self.particles + particle)
    }

    pub fn stretch(self, spring: usize) -> usize {
        6 * self.particles + spring
    }

    pub fn lack(self, spring: usize) -> usize {
        6 * self.particles + self.springs + spring
    }

    fn inputs(self) -> usize {
        6 * self.particles + 2 * self.springs
    }
}

/// The accelerations of all particles, 3N, then q̇ of all springs. `squares` are ℓ₀² of the springs, m².
///
/// Of a spring, with d from its first particle to its second, the force on the first is (k q / (ℓ (ℓ + ℓ₀)) + c d·ḋ/ℓ²) d,
/// ℓ² = ℓ₀² + q: the same as (k (ℓ − ℓ₀) + c dℓ/dt) d/ℓ, without the difference.
pub(super) fn equations(cloud: &SpringCloud, squares: &[f64]) -> Tape {
    let places = Places::of(cloud);
    let mut tape = Tape::new(places.inputs());
    let springs = cloud.springs();
    let (stiffness, damping) = (tape.constant(springs.stiffness), tape.constant(springs.damping));
    let (zero, two) = (tape.constant(0.0), tape.constant(2.0));
    let three = |tape: &Tape, first: usize| [0, 1, 2].map(|axis| tape.input(first + axis));
    let mut forces = vec![[zero; 3]; places.particles];
    let mut rates = Vec::with_capacity(places.springs);
    for (spring, ([first, second], square)) in cloud.pairs().zip(squares).enumerate() {
        let apart = |tape: &mut Tape, of: &dyn Fn(usize) -> usize| {
            let (from, to) = (three(tape, of(first)), three(tape, of(second)));
            tape.differences(to, from)
        };
        let between = apart(&mut tape, &Places::position);
        let parting = apart(&mut tape, &|particle| places.velocity(particle));
        let (stretch, lack) = (tape.input(places.stretch(spring)), tape.input(places.lack(spring)));
        let rounded = tape.dot(between, parting);
        let half_rate = tape.sum(rounded, lack);
        rates.push(tape.product(two, half_rate));
        let (rest_square, rest) = (tape.constant(*square), tape.constant(square.sqrt()));
        let length_square = tape.sum(rest_square, stretch);
        let length = tape.root(length_square);
        let (pulled, across) = (tape.product(stiffness, stretch), tape.product(rest, length));
        let whole = tape.sum(length_square, across);
        let pull = tape.quotient(pulled, whole);
        let (braked, zero_damping) = (tape.product(damping, half_rate), springs.damping == 0.0);
        let brake = if zero_damping { zero } else { tape.quotient(braked, length_square) };
        let factor = tape.sum(pull, brake);
        let force = tape.scaled(factor, between);
        forces[first] = tape.sums(forces[first], force);
        forces[second] = tape.differences(forces[second], force);
    }
    let accelerations: Vec<Node> = forces
        .iter()
        .zip(cloud.masses())
        .flat_map(|(force, mass)| {
            let mass = tape.constant(*mass);
            force.map(|component| tape.quotient(component, mass))
        })
        .collect();
    for node in accelerations.into_iter().chain(rates) {
        tape.want(node);
    }
    tape
}
