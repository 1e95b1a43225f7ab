use super::recurrence::{Rows, exact};
use super::sign::{first_below, sign_ahead};
use super::{Node, Operation, Scalar, Tape};

/// The Taylor coefficients of all results of a tape, in σ = (t − start) / unit.
#[derive(Debug, Clone)]
pub struct Expansion<F> {
    rows: Rows<F>,
    order: usize,
    /// What has to be worked out: all that the results wanted are made of, but for inputs and constants.
    live: Vec<Node>,
    /// Of operations with branches: the node, and whether it is on the branch where its guard is not negative.
    branches: Vec<(Node, bool)>,
}

impl<F: Scalar> Expansion<F> {
    /// How often branches are chosen anew at one place before they are taken as they are.
    const MOST_CHOICES: usize = 8;

    /// Room for coefficients up to `order`; all inputs are zero.
    #[must_use]
    pub fn new(tape: &Tape, order: usize) -> Self {
        let needed = tape.needed();
        let live = (0..tape.len()).map(Node).filter(|node| needed[node.0] && !tape.is_constant(*node));
        let mut expansion =
            Self { live: live.collect(), rows: Rows::new(tape.len(), order), order, branches: Vec::new() };
        let branching = (0..tape.len()).map(Node).filter(|node| tape.operations()[node.0].has_branches());
        expansion.branches = branching.filter(|node| needed[node.0]).map(|node| (node, true)).collect();
        for node in (0..tape.len()).map(Node).filter(|node| tape.is_constant(*node)) {
            expansion.choose(tape, node);
            expansion.work_out(tape, node, 0);
        }
        expansion
    }

    /// Sets coefficient `k` of an input.
    pub fn set(&mut self, input: usize, k: usize, value: F) {
        self.rows.set(Node(input), k, value);
    }

    /// The coefficients of an input.
    #[must_use]
    pub fn input(&self, input: usize) -> &[F] {
        self.rows.of(Node(input))
    }

    /// The coefficients of the result that was wanted in this place.
    #[must_use]
    pub fn output(&self, tape: &Tape, number: usize) -> &[F] {
        self.rows.of(tape.wanted()[number])
    }

    /// Works out all coefficients up to `order` from those of the inputs, which are known as far.
    pub fn expand(&mut self, tape: &Tape, order: usize) {
        self.integrate(tape, order, |_, _| {});
    }

    /// Works out all coefficients up to `order`. `next` is told each order as soon as it is known, and may set the
    /// inputs' coefficients of the next one: so differential equations are solved.
    ///
    /// Branches are those that the results are on right after σ = 0: found from the signs of the guards, and tried again
    /// where one was zero and its series goes the other way.
    pub fn integrate(&mut self, tape: &Tape, order: usize, next: impl Fn(&mut Self, usize)) {
        let order = order.min(self.order);
        for choice in 0..Self::MOST_CHOICES {
            for k in 0..=order {
                self.order_of(tape, k, choice == 0);
                next(self, k);
            }
            if !self.choose_again(tape, order) {
                return;
            }
        }
    }

    /// Coefficient k of every result.
    fn order_of(&mut self, tape: &Tape, k: usize, chooses: bool) {
        for place in 0..self.live.len() {
            let node = self.live[place];
            if k == 0 && chooses {
                self.choose(tape, node);
            }
            self.work_out(tape, node, k);
        }
    }

    /// Takes the branch of the values themselves.
    fn choose(&mut self, tape: &Tape, node: Node) {
        let above = self.guard(tape.operations()[node.0], 0) >= F::from(0.0);
        if let Some(branch) = self.branches.iter_mut().find(|(other, _)| *other == node) {
            branch.1 = above;
        }
    }

    fn work_out(&mut self, tape: &Tape, node: Node, k: usize) {
        let rows = &self.rows;
        let at = |node: Node| rows.of(node)[k];
        let value = match tape.operations()[node.0] {
            Operation::Input(_) => return,
            Operation::Constant(value) => F::from(if k == 0 { value } else { 0.0 }),
            Operation::Sum(a, b) => at(a) + at(b),
            Operation::Difference(a, b) => at(a) - at(b),
            Operation::Product(a, b) if tape.is_constant(a) => rows.of(a)[0] * at(b),
            Operation::Product(a, b) if tape.is_constant(b) => at(a) * rows.of(b)[0],
            Operation::Product(a, b) => rows.product(a, b, k),
            Operation::Quotient(a, b) if tape.is_constant(b) => at(a) / rows.of(b)[0],
            Operation::Quotient(a, b) => rows.quotient(node, a, b, k),
            Operation::Negative(a) => -at(a),
            Operation::Root(a) => rows.root(node, a, k),
            Operation::Exponential(a) => rows.exponential(node, a, k),
            Operation::Logarithm(a) => rows.logarithm(node, a, k),
            Operation::Sine(a) => rows.sine(node, a, k),
            Operation::Cosine(a) => rows.cosine(node, a, k),
            Operation::Arctangent(a, slope) => rows.arctangent(node, a, slope, k),
            Operation::Magnitude(a) => {
                if self.is_above(node) {
                    at(a)
                } else {
                    -at(a)
                }
            }
            Operation::Larger(a, b) => self.one_of(node, [a, b], k),
            Operation::Smaller(a, b) => self.one_of(node, [b, a], k),
        };
        self.rows.set(node, k, value);
    }

    /// Coefficient k of the operand whose branch the result is on. Where the other is no number, or has no derivatives,
    /// nobody can say when it takes over: then this is no number either.
    fn one_of(&self, node: Node, [above, below]: [Node; 2], k: usize) -> F {
        let (taken, left) = if self.is_above(node) { (above, below) } else { (below, above) };
        let left = self.rows.of(left);
        let (value, coefficient) = (left[0].rounded(), left[k].rounded());
        if value.is_nan() || (value.is_finite() && !coefficient.is_finite()) {
            return F::from(f64::NAN);
        }
        self.rows.of(taken)[k]
    }

    fn is_above(&self, node: Node) -> bool {
        self.branches.iter().any(|(other, above)| *other == node && *above)
    }

    /// Coefficient k of what changes sign where the branch changes.
    fn guard(&self, operation: Operation, k: usize) -> F {
        match operation.operands() {
            [Some(a), Some(b)] => self.rows.of(a)[k] - self.rows.of(b)[k],
            [Some(a), None] => self.rows.of(a)[k],
            _ => F::from(0.0),
        }
    }

    /// Takes the branches that the series go on to; whether any of them is another than before.
    fn choose_again(&mut self, tape: &Tape, order: usize) -> bool {
        let mut changed = false;
        for switch in 0..self.branches.len() {
            let (node, above) = self.branches[switch];
            let guard = self.guard_series(tape.operations()[node.0], order);
            let ahead = sign_ahead(&guard).unwrap_or(above);
            changed |= ahead != above;
            self.branches[switch].1 = ahead;
        }
        changed
    }

    fn guard_series(&self, operation: Operation, order: usize) -> Vec<f64> {
        (0..=order).map(|k| self.guard(operation, k).rounded()).collect()
    }

    /// The largest σ at which the last two coefficients of no guard add more than `tolerance` of its size: as far as the
    /// series say where branches change, whether the results depend on the guards now or not.
    #[must_use]
    pub fn reach_of_guards(&self, tape: &Tape, order: usize, tolerance: f64) -> f64 {
        self.branches.iter().fold(f64::INFINITY, |reach, (node, _)| {
            let guard = self.guard_series(tape.operations()[node.0], order);
            let size = guard.iter().fold(0.0, |size: f64, coefficient| coefficient.abs().max(size));
            let last = (order.max(1) - 1..=order).filter(|k| guard[*k] != 0.0);
            last.map(|k| libm::pow(tolerance * size / guard[k].abs(), 1.0 / exact(k.max(1)))).fold(reach, f64::min)
        })
    }

    /// The first σ up to `end` at which a result leaves its branch, by the series up to `order`.
    ///
    /// Bounds on the guards between the places looked at leave no crossing out, however short, above 1e-13 of a guard's size.
    #[must_use]
    pub fn first_switch(&self, tape: &Tape, order: usize, end: f64) -> Option<f64> {
        let mut first = None;
        for (node, above) in &self.branches {
            let mut guard = self.guard_series(tape.operations()[node.0], order);
            if !above {
                for coefficient in &mut guard {
                    *coefficient = -*coefficient;
                }
            }
            first = first_below(&guard, first.unwrap_or(end)).or(first);
        }
        first
    }

    /// The largest σ over which no argument of a sine, cosine or exponential changes by more than `change`; infinity where
    /// none does. A series of order n follows such a function no farther, and where it vanishes it does not say so.
    #[must_use]
    pub fn reach_of_arguments(&self, tape: &Tape, order: usize, change: f64) -> f64 {
        let arguments = self.live.iter().filter_map(|node| tape.operations()[node.0].argument());
        arguments.filter(|node| !tape.is_constant(*node)).fold(f64::INFINITY, |reach, node| {
            let row = &self.rows.of(node)[1..=order];
            let each = row.iter().enumerate().map(|(below, coefficient)| {
                let (size, k) = (coefficient.rounded().abs(), below + 1);
                // Each term may take its part, halved from one to the next.
                if size > 0.0 {
                    libm::pow(libm::ldexp(change, -i32::try_from(k).unwrap_or(0)) / size, 1.0 / exact(k))
                } else {
                    f64::INFINITY
                }
            });
            each.fold(reach, f64::min)
        })
    }
}
