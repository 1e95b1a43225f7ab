use crate::numerics::{Node, Tape};

/// What a formula can name, beside the number pi.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Variable {
    /// s.
    Time,
    /// A component of ω in body axes, rad/s.
    Rate(usize),
    /// A component of the quaternion, world from body: w, x, y, z.
    Quaternion(usize),
    /// An element of the rotation matrix, world from body: row and column.
    Matrix(usize, usize),
    /// A component of the reference point's position, world axes, m.
    Position(usize),
    /// A component of the reference point's velocity, world axes, m/s.
    Velocity(usize),
}

impl Variable {
    /// Every name, and what it stands for.
    pub const ALL: [(&'static str, Self); 23] = [
        ("t", Self::Time),
        ("wx", Self::Rate(0)),
        ("wy", Self::Rate(1)),
        ("wz", Self::Rate(2)),
        ("qw", Self::Quaternion(0)),
        ("qx", Self::Quaternion(1)),
        ("qy", Self::Quaternion(2)),
        ("qz", Self::Quaternion(3)),
        ("r11", Self::Matrix(0, 0)),
        ("r12", Self::Matrix(0, 1)),
        ("r13", Self::Matrix(0, 2)),
        ("r21", Self::Matrix(1, 0)),
        ("r22", Self::Matrix(1, 1)),
        ("r23", Self::Matrix(1, 2)),
        ("r31", Self::Matrix(2, 0)),
        ("r32", Self::Matrix(2, 1)),
        ("r33", Self::Matrix(2, 2)),
        ("x", Self::Position(0)),
        ("y", Self::Position(1)),
        ("z", Self::Position(2)),
        ("vx", Self::Velocity(0)),
        ("vy", Self::Velocity(1)),
        ("vz", Self::Velocity(2)),
    ];

    /// The variable of that name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(known, _)| *known == name).map(|(_, variable)| variable)
    }
}

/// What a formula can call. All are continuous where they are defined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Function {
    /// sin x.
    Sin,
    /// cos x.
    Cos,
    /// tan x.
    Tan,
    /// arctan x.
    Atan,
    /// √x.
    Sqrt,
    /// eˣ.
    Exp,
    /// The natural logarithm.
    Ln,
    /// (eˣ − e⁻ˣ)/2.
    Sinh,
    /// (eˣ + e⁻ˣ)/2.
    Cosh,
    /// sinh x / cosh x.
    Tanh,
    /// |x|.
    Abs,
    /// The smaller of two.
    Min,
    /// The larger of two.
    Max,
}

impl Function {
    /// Every name, and what it stands for.
    pub const ALL: [(&'static str, Self); 13] = [
        ("sin", Self::Sin),
        ("cos", Self::Cos),
        ("tan", Self::Tan),
        ("atan", Self::Atan),
        ("sqrt", Self::Sqrt),
        ("exp", Self::Exp),
        ("ln", Self::Ln),
        ("sinh", Self::Sinh),
        ("cosh", Self::Cosh),
        ("tanh", Self::Tanh),
        ("abs", Self::Abs),
        ("min", Self::Min),
        ("max", Self::Max),
    ];

    /// The function of that name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(known, _)| *known == name).map(|(_, function)| function)
    }

    /// How many values it takes.
    #[must_use]
    pub const fn arguments(self) -> usize {
        match self {
            Self::Min | Self::Max => 2,
            _ => 1,
        }
    }

    /// Its operations on one value, or on a first and a second.
    pub(super) fn on(self, tape: &mut Tape, a: Node, second: Option<Node>) -> Node {
        let b = second.unwrap_or(a);
        match self {
            Self::Sin => tape.sine_cosine(a).0,
            Self::Cos => tape.sine_cosine(a).1,
            Self::Tan => {
                let (sine, cosine) = tape.sine_cosine(a);
                tape.quotient(sine, cosine)
            }
            Self::Atan => tape.arctangent(a),
            Self::Sqrt => tape.root(a),
            Self::Exp => tape.exponential(a),
            Self::Ln => tape.logarithm(a),
            Self::Sinh => {
                let [up, down] = halves(tape, a);
                tape.difference(up, down)
            }
            Self::Cosh => {
                let [up, down] = halves(tape, a);
                tape.sum(up, down)
            }
            Self::Tanh => {
                let [up, down] = halves(tape, a);
                let (sinh, cosh) = (tape.difference(up, down), tape.sum(up, down));
                tape.quotient(sinh, cosh)
            }
            Self::Abs => tape.magnitude(a),
            Self::Min => tape.smaller(a, b),
            Self::Max => tape.larger(a, b),
        }
    }
}

/// eᵃ/2 and e⁻ᵃ/2.
fn halves(tape: &mut Tape, a: Node) -> [Node; 2] {
    let (half, opposite) = (tape.constant(0.5), tape.negative(a));
    [a, opposite].map(|exponent| {
        let power = tape.exponential(exponent);
        tape.product(half, power)
    })
}
