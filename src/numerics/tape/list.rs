use super::{Node, Operation};

/// A list of operations, and which of their results are wanted.
///
/// ```
/// use polhode::numerics::{Expansion, Tape};
/// let mut tape = Tape::new(1);
/// let t = tape.input(0);
/// let (sine, _) = tape.sine_cosine(t);
/// tape.want(sine);
/// let mut expansion = Expansion::<f64>::new(&tape, 3);
/// expansion.set(0, 1, 1.0); // t = 0 + σ
/// expansion.expand(&tape, 3);
/// assert_eq!(expansion.output(&tape, 0), [0.0, 1.0, 0.0, -1.0 / 6.0]);
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tape {
    inputs: usize,
    operations: Vec<Operation>,
    /// Whether a result depends on no input.
    constant: Vec<bool>,
    wanted: Vec<Node>,
}

impl Tape {
    /// Without operations yet, on so many inputs.
    #[must_use]
    pub fn new(inputs: usize) -> Self {
        let mut tape = Self { inputs, ..Self::default() };
        for input in 0..inputs {
            tape.push(Operation::Input(input));
        }
        tape
    }

    /// How many operations, inputs among them.
    #[must_use]
    pub fn len(&self) -> usize {
        self.operations.len()
    }

    /// Whether there is neither an input nor an operation.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.operations.is_empty()
    }

    /// How many inputs.
    #[must_use]
    pub fn inputs(&self) -> usize {
        self.inputs
    }

    /// The results wanted, in order.
    #[must_use]
    pub fn wanted(&self) -> &[Node] {
        &self.wanted
    }

    pub(super) fn operations(&self) -> &[Operation] {
        &self.operations
    }

    pub(super) fn is_constant(&self, node: Node) -> bool {
        self.constant[node.0]
    }

    /// Of each result, whether those wanted are made of it.
    pub(super) fn needed(&self) -> Vec<bool> {
        let mut needed = vec![false; self.len()];
        for node in &self.wanted {
            needed[node.0] = true;
        }
        for (place, operation) in self.operations.iter().enumerate().rev() {
            match operation {
                // They need each other; the cosine comes after its sine.
                Operation::Cosine(_) if needed[place] => needed[place - 1] = true,
                Operation::Sine(_) if needed[place] => needed[place + 1] = true,
                _ => {}
            }
            if needed[place] {
                operation.operands().into_iter().flatten().for_each(|node| needed[node.0] = true);
            }
        }
        needed
    }

    /// Adds an operation, or finds it where it stands already.
    fn push(&mut self, operation: Operation) -> Node {
        // Tapes are short: to look for it costs less than a table of hashes.
        let paired = matches!(operation, Operation::Cosine(_));
        if let Some(place) = self.operations.iter().position(|other| *other == operation).filter(|_| !paired) {
            return Node(place);
        }
        let is_constant = match operation {
            Operation::Input(_) => false,
            _ => operation.operands().into_iter().flatten().all(|node| self.constant[node.0]),
        };
        self.operations.push(operation);
        self.constant.push(is_constant);
        Node(self.operations.len() - 1)
    }

    /// The number, if the node is one.
    fn number(&self, node: Node) -> Option<f64> {
        match self.operations[node.0] {
            Operation::Constant(value) => Some(value),
            _ => None,
        }
    }

    /// Adds a result to those wanted.
    pub fn want(&mut self, node: Node) {
        self.wanted.push(node);
    }

    /// The input of this number, below that of inputs.
    #[must_use]
    pub fn input(&self, number: usize) -> Node {
        debug_assert!(number < self.inputs, "the tape has {} inputs", self.inputs);
        Node(number)
    }

    /// A number, taken as exact.
    pub fn constant(&mut self, value: f64) -> Node {
        self.push(Operation::Constant(value))
    }

    /// a + b.
    pub fn sum(&mut self, a: Node, b: Node) -> Node {
        match (self.number(a), self.number(b)) {
            (Some(0.0), _) => b,
            (_, Some(0.0)) => a,
            _ => self.push(Operation::Sum(a, b)),
        }
    }

    /// a − b.
    pub fn difference(&mut self, a: Node, b: Node) -> Node {
        match (self.number(a), self.number(b)) {
            (Some(0.0), _) => self.negative(b),
            (_, Some(0.0)) => a,
            _ => self.push(Operation::Difference(a, b)),
        }
    }

    /// a b; an exact 0 makes 0, whatever the other is.
    pub fn product(&mut self, a: Node, b: Node) -> Node {
        match (self.number(a), self.number(b)) {
            (Some(0.0), _) | (_, Some(1.0)) => a,
            (_, Some(0.0)) | (Some(1.0), _) => b,
            _ => self.push(Operation::Product(a, b)),
        }
    }

    /// a / b.
    pub fn quotient(&mut self, a: Node, b: Node) -> Node {
        if self.number(b) == Some(1.0) { a } else { self.push(Operation::Quotient(a, b)) }
    }

    /// −a.
    pub fn negative(&mut self, a: Node) -> Node {
        match self.number(a) {
            Some(value) => self.constant(-value),
            None => self.push(Operation::Negative(a)),
        }
    }

    /// √a.
    pub fn root(&mut self, a: Node) -> Node {
        self.push(Operation::Root(a))
    }

    /// eᵃ.
    pub fn exponential(&mut self, a: Node) -> Node {
        self.push(Operation::Exponential(a))
    }

    /// ln a.
    pub fn logarithm(&mut self, a: Node) -> Node {
        self.push(Operation::Logarithm(a))
    }

    /// sin a and cos a, which need each other.
    pub fn sine_cosine(&mut self, a: Node) -> (Node, Node) {
        let sine = self.push(Operation::Sine(a));
        if sine.0 + 1 == self.operations.len() {
            self.push(Operation::Cosine(a));
        }
        (sine, Node(sine.0 + 1))
    }

    /// arctan a.
    pub fn arctangent(&mut self, a: Node) -> Node {
        let (one, square) = (self.constant(1.0), self.product(a, a));
        let slope = self.sum(one, square);
        self.push(Operation::Arctangent(a, slope))
    }

    /// |a|.
    pub fn magnitude(&mut self, a: Node) -> Node {
        self.push(Operation::Magnitude(a))
    }

    /// The larger of a and b.
    pub fn larger(&mut self, a: Node, b: Node) -> Node {
        self.push(Operation::Larger(a, b))
    }

    /// The smaller of a and b.
    pub fn smaller(&mut self, a: Node, b: Node) -> Node {
        self.push(Operation::Smaller(a, b))
    }

    /// a to a whole power, by squaring.
    pub fn power(&mut self, a: Node, exponent: u32) -> Node {
        let mut result = self.constant(1.0);
        for bit in (0..u32::BITS - exponent.leading_zeros()).rev() {
            result = self.product(result, result);
            if exponent >> bit & 1 == 1 {
                result = self.product(result, a);
            }
        }
        result
    }

    /// a · b of two vectors.
    pub fn dot(&mut self, a: [Node; 3], b: [Node; 3]) -> Node {
        let [x, y, z] = [0, 1, 2].map(|i| self.product(a[i], b[i]));
        let sum = self.sum(x, y);
        self.sum(sum, z)
    }

    /// a × b.
    pub fn cross(&mut self, a: [Node; 3], b: [Node; 3]) -> [Node; 3] {
        [(1, 2), (2, 0), (0, 1)].map(|(j, k)| {
            let (plus, minus) = (self.product(a[j], b[k]), self.product(a[k], b[j]));
            self.difference(plus, minus)
        })
    }

    /// Three numbers.
    pub fn vector(&mut self, values: impl Into<[f64; 3]>) -> [Node; 3] {
        values.into().map(|value| self.constant(value))
    }

    /// a + b, component by component.
    pub fn sums(&mut self, a: [Node; 3], b: [Node; 3]) -> [Node; 3] {
        [0, 1, 2].map(|i| self.sum(a[i], b[i]))
    }

    /// a − b, component by component.
    pub fn differences(&mut self, a: [Node; 3], b: [Node; 3]) -> [Node; 3] {
        [0, 1, 2].map(|i| self.difference(a[i], b[i]))
    }

    /// factor times a.
    pub fn scaled(&mut self, factor: Node, a: [Node; 3]) -> [Node; 3] {
        a.map(|component| self.product(factor, component))
    }
}
