/// A result on a [`Tape`](super::Tape), by its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Node(pub(super) usize);

/// One operation on results before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Operation {
    /// A number, taken as exact.
    Constant(f64),
    /// The input of this number.
    Input(usize),
    /// a + b.
    Sum(Node, Node),
    /// a − b.
    Difference(Node, Node),
    /// a b.
    Product(Node, Node),
    /// a / b.
    Quotient(Node, Node),
    /// −a.
    Negative(Node),
    /// √a.
    Root(Node),
    /// eᵃ.
    Exponential(Node),
    /// ln a.
    Logarithm(Node),
    /// sin of an angle; the node of its cosine comes after it.
    Sine(Node),
    /// cos of an angle; the node of its sine comes before it.
    Cosine(Node),
    /// arctan a, with the node of 1 + a².
    Arctangent(Node, Node),
    /// |a|.
    Magnitude(Node),
    /// The larger of a and b.
    Larger(Node, Node),
    /// The smaller of a and b.
    Smaller(Node, Node),
}

impl Operation {
    /// What it works on.
    pub(super) fn operands(self) -> [Option<Node>; 2] {
        match self {
            Self::Constant(_) | Self::Input(_) => [None, None],
            Self::Negative(a)
            | Self::Root(a)
            | Self::Exponential(a)
            | Self::Logarithm(a)
            | Self::Sine(a)
            | Self::Cosine(a)
            | Self::Magnitude(a) => [Some(a), None],
            Self::Sum(a, b)
            | Self::Difference(a, b)
            | Self::Product(a, b)
            | Self::Quotient(a, b)
            | Self::Arctangent(a, b)
            | Self::Larger(a, b)
            | Self::Smaller(a, b) => [Some(a), Some(b)],
        }
    }

    /// Whether it is made of two branches.
    pub(super) fn has_branches(self) -> bool {
        matches!(self, Self::Magnitude(_) | Self::Larger(..) | Self::Smaller(..))
    }

    /// What must not change by much within a step, or the series would know nothing of what comes.
    pub(super) fn argument(self) -> Option<Node> {
        match self {
            Self::Exponential(a) | Self::Sine(a) => Some(a),
            _ => None,
        }
    }
}
