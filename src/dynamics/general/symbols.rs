use nalgebra::Vector3;

use crate::body::State;
use crate::numerics::{Node, Tape};

/// The motion at one instant as inputs of a tape. "In body" is in principal axes.
#[derive(Debug, Clone, Copy)]
pub struct Symbols {
    /// s.
    pub time: Node,
    /// World from body: w, x, y, z.
    pub attitude: [Node; 4],
    /// In body, rad/s.
    pub rates: [Node; 3],
    /// World axes, m.
    pub position: [Node; 3],
    /// World axes, m/s.
    pub velocity: [Node; 3],
    /// σ, of a sphere inside the body relative to it, in body, rad/s; not used without one.
    pub inner: [Node; 3],
    /// The rotation matrix, world from body, by rows: the body images of the world's axes.
    pub matrix: [[Node; 3]; 3],
}

/// What one load does, as results on a tape.
#[derive(Debug, Clone, Copy)]
pub struct Push {
    /// About the reference point, in body, N m.
    pub moment: [Node; 3],
    /// On the reference point, world axes, N.
    pub force: [Node; 3],
}

impl Symbols {
    /// How many inputs: time, then the components in the order of the fields.
    pub const INPUTS: usize = 17;

    /// On the first inputs of a tape.
    #[must_use]
    pub fn on(tape: &mut Tape) -> Self {
        let vector = |tape: &Tape, first: usize| [0, 1, 2].map(|i| tape.input(first + i));
        let attitude = [1, 2, 3, 4].map(|i| tape.input(i));
        Self {
            time: tape.input(0),
            attitude,
            rates: vector(tape, 5),
            position: vector(tape, 8),
            velocity: vector(tape, 11),
            inner: vector(tape, 14),
            matrix: matrix(tape, attitude),
        }
    }

    /// The inputs' values at `time`, s, and `state`, of a body without a sphere in it.
    #[must_use]
    pub fn values(time: f64, state: &State) -> [f64; Self::INPUTS] {
        let [qw, qx, qy, qz] = state.attitude.wxyz();
        let [wx, wy, wz]: [f64; 3] = state.angular_velocity.in_body().into();
        let ([x, y, z], [vx, vy, vz]): ([f64; 3], [f64; 3]) = (state.position.into(), state.velocity.into());
        [time, qw, qx, qy, qz, wx, wy, wz, x, y, z, vx, vy, vz, 0.0, 0.0, 0.0]
    }

    /// Rᵀ w.
    pub fn to_body(&self, tape: &mut Tape, in_world: [Node; 3]) -> [Node; 3] {
        [0, 1, 2].map(|column| tape.dot([0, 1, 2].map(|row: usize| self.matrix[row][column]), in_world))
    }

    /// R b.
    pub fn to_world(&self, tape: &mut Tape, in_body: [Node; 3]) -> [Node; 3] {
        self.matrix.map(|row| tape.dot(row, in_body))
    }
}

impl Push {
    /// Nothing.
    #[must_use]
    pub fn none(tape: &mut Tape) -> Self {
        let zero = tape.constant(0.0);
        Self { moment: [zero; 3], force: [zero; 3] }
    }

    /// A moment, in body, and no force.
    #[must_use]
    pub fn moment(tape: &mut Tape, moment: [Node; 3]) -> Self {
        Self { moment, ..Self::none(tape) }
    }

    /// A force, world axes, at a point of the body: `arm`, in body, from the reference point.
    pub fn force(tape: &mut Tape, symbols: &Symbols, force: [Node; 3], arm: Vector3<f64>) -> Self {
        let arm = tape.vector(arm);
        let in_body = symbols.to_body(tape, force);
        Self { moment: tape.cross(arm, in_body), force }
    }

    /// Both at once.
    #[must_use]
    pub fn and(self, tape: &mut Tape, other: Self) -> Self {
        Self { moment: tape.sums(self.moment, other.moment), force: tape.sums(self.force, other.force) }
    }
}

/// The rotation matrix of a quaternion of unit length.
fn matrix(tape: &mut Tape, [w, x, y, z]: [Node; 4]) -> [[Node; 3]; 3] {
    let two = tape.constant(2.0);
    let squares = [w, x, y, z].map(|q| tape.product(q, q));
    let mut twice = |a: Node, b: Node| {
        let product = tape.product(a, b);
        tape.product(two, product)
    };
    let (xy, xz, yz) = (twice(x, y), twice(x, z), twice(y, z));
    let (wx, wy, wz) = (twice(w, x), twice(w, y), twice(w, z));
    let [ww, xx, yy, zz] = squares;
    let mut diagonal = |plus: Node, minus: [Node; 2]| {
        let (plus, minus) = (tape.sum(ww, plus), tape.sum(minus[0], minus[1]));
        tape.difference(plus, minus)
    };
    let (first, second, third) = (diagonal(xx, [yy, zz]), diagonal(yy, [xx, zz]), diagonal(zz, [xx, yy]));
    [
        [first, tape.difference(xy, wz), tape.sum(xz, wy)],
        [tape.sum(xy, wz), second, tape.difference(yz, wx)],
        [tape.difference(xz, wy), tape.sum(yz, wx), third],
    ]
}
