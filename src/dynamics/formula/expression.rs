use thiserror::Error;

use super::{Function, Variable, read};
use crate::numerics::{Node, Tape};

/// A formula as a tree.
#[derive(Debug, Clone, PartialEq)]
pub enum Expression {
    /// A number, finite.
    Number(f64),
    /// Something of the motion.
    Variable(Variable),
    /// −a.
    Negative(Box<Expression>),
    /// Two, and what is done to them.
    Operation(Operator, Box<Expression>, Box<Expression>),
    /// A function of one or two values.
    Call(Function, Vec<Expression>),
}

/// What is done to two values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operator {
    /// a + b.
    Plus,
    /// a − b.
    Minus,
    /// a b.
    Times,
    /// a / b.
    Over,
    /// a to the power b.
    Power,
}

/// A text that is no formula.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("at column {column}: {rule}")]
pub struct FormulaError {
    /// In characters, from 1.
    pub column: usize,
    /// What is wrong there.
    pub rule: String,
}

/// The nodes of what formulae can name, in body axes as the user knows them.
#[derive(Debug, Clone, Copy)]
pub struct Known {
    /// s.
    pub time: Node,
    /// Body axes, rad/s.
    pub rates: [Node; 3],
    /// World from body: w, x, y, z.
    pub quaternion: [Node; 4],
    /// World from body, by rows.
    pub matrix: [[Node; 3]; 3],
    /// World axes, m.
    pub position: [Node; 3],
    /// World axes, m/s.
    pub velocity: [Node; 3],
}

impl Expression {
    /// Characters of a text at most.
    pub const LONGEST: usize = 1000;
    /// Brackets, signs and powers within each other at most.
    pub const DEEPEST: usize = 32;
    /// Numbers, names and operations at most.
    pub const LARGEST: usize = 300;
    /// The largest exponent that is a whole number of products.
    const MOST_PRODUCTS: f64 = 64.0;

    /// From text such as `0.1*sin(2*t) - wx^2/3`: `+ - * / ^`, brackets, numbers, `pi`, [`Variable`]s and [`Function`]s.
    /// Powers bind first and from the right, then signs: `-x^2` is −(x²).
    ///
    /// # Errors
    /// If it is no formula, names what is not known, or is too long, too deep or too large.
    pub fn read(text: &str) -> Result<Self, FormulaError> {
        if text.chars().count() > Self::LONGEST {
            let rule = format!("a formula has at most {} characters", Self::LONGEST);
            return Err(FormulaError { column: Self::LONGEST + 1, rule });
        }
        read::read(text)
    }

    /// Whether it names something of which `which` holds.
    #[must_use]
    pub fn names(&self, which: &impl Fn(Variable) -> bool) -> bool {
        match self {
            Self::Number(_) => false,
            Self::Variable(variable) => which(*variable),
            Self::Negative(a) => a.names(which),
            Self::Operation(_, a, b) => a.names(which) || b.names(which),
            Self::Call(_, arguments) => arguments.iter().any(|argument| argument.names(which)),
        }
    }

    /// Lays it out as operations on a tape.
    pub fn on(&self, tape: &mut Tape, known: &Known) -> Node {
        match self {
            Self::Number(value) => tape.constant(*value),
            Self::Variable(variable) => match *variable {
                Variable::Time => known.time,
                Variable::Rate(i) => known.rates[i],
                Variable::Quaternion(i) => known.quaternion[i],
                Variable::Matrix(row, column) => known.matrix[row][column],
                Variable::Position(i) => known.position[i],
                Variable::Velocity(i) => known.velocity[i],
            },
            Self::Negative(a) => {
                let a = a.on(tape, known);
                tape.negative(a)
            }
            Self::Operation(Operator::Power, base, exponent) => power(tape, known, base, exponent),
            Self::Operation(operator, a, b) => {
                let (a, b) = (a.on(tape, known), b.on(tape, known));
                match operator {
                    Operator::Plus => tape.sum(a, b),
                    Operator::Minus => tape.difference(a, b),
                    Operator::Times => tape.product(a, b),
                    Operator::Over | Operator::Power => tape.quotient(a, b),
                }
            }
            Self::Call(function, arguments) => {
                let nodes: Vec<Node> = arguments.iter().map(|argument| argument.on(tape, known)).collect();
                let first = nodes.first().copied().unwrap_or(known.time);
                function.on(tape, first, nodes.get(1).copied())
            }
        }
    }

    /// The number that it is, with its sign.
    fn number(&self) -> Option<f64> {
        match self {
            Self::Number(value) => Some(*value),
            Self::Negative(a) => a.number().map(|value| -value),
            _ => None,
        }
    }
}

/// Whole powers are products, ½ is a root; any other power, of what is positive, goes by its logarithm.
fn power(tape: &mut Tape, known: &Known, base: &Expression, exponent: &Expression) -> Node {
    let a = base.on(tape, known);
    match exponent.number() {
        Some(0.5) => tape.root(a),
        Some(value) if value.fract() == 0.0 && value.abs() <= Expression::MOST_PRODUCTS => {
            // A small whole number.
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small whole number")]
            let products = tape.power(a, value.abs() as u32);
            let one = tape.constant(1.0);
            if value < 0.0 { tape.quotient(one, products) } else { products }
        }
        _ => {
            let (logarithm, exponent) = (tape.logarithm(a), exponent.on(tape, known));
            let product = tape.product(exponent, logarithm);
            tape.exponential(product)
        }
    }
}
