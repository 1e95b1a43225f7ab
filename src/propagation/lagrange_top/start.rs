use crate::numerics::DoubleDouble;
use crate::propagation::exact::{ExactQuaternion, Frame};

/// What a start determines, in double-double. Axis 3′ goes from the fixed point to where the force acts, and the upward
/// direction is against the force.
#[derive(Debug, Clone, Copy)]
pub struct Start {
    pub frame: Frame,
    /// World from a frame whose third axis is up, of any length.
    pub world_from_upright: ExactQuaternion,
    /// A = w + iz and B = x + iy of "upright frame from primed axes".
    pub pair: [[DoubleDouble; 2]; 2],
    /// ω₁′ + iω₂′.
    pub across: [DoubleDouble; 2],
    /// ω₃′.
    pub along: DoubleDouble,
    /// a = L₃/J₁.
    pub spin: DoubleDouble,
    /// (ω₃ − a)/2: half of what the body turns about its axis by itself.
    pub half_excess: DoubleDouble,
    /// β = 2 F r/J₁.
    pub strength: DoubleDouble,
}

/// x y of two complex numbers.
pub fn product([a, b]: [DoubleDouble; 2], [c, d]: [DoubleDouble; 2]) -> [DoubleDouble; 2] {
    [a * c - b * d, a * d + b * c]
}

/// Conjugate.
pub fn conjugate([a, b]: [DoubleDouble; 2]) -> [DoubleDouble; 2] {
    [a, -b]
}

/// |x|².
pub fn square([a, b]: [DoubleDouble; 2]) -> DoubleDouble {
    a.square() + b.square()
}

/// The rotation, of any length, that takes this world vector of some size, which must not be 0, to the third axis.
fn upright_from_world(up: [DoubleDouble; 3], size: DoubleDouble) -> ExactQuaternion {
    let zero = DoubleDouble::ZERO;
    let [x, y, z] = up;
    if z.hi() < 0.0 {
        // Half a turn about x first, so that nothing cancels.
        return ExactQuaternion([y, size - z, zero, x]);
    }
    ExactQuaternion([size + z, y, -x, zero])
}

impl Start {
    /// Principal moments, ω and the attitude; force in world axes, and its arm along the principal axis `axis`.
    pub fn new(
        moments: [f64; 3],
        omega: [f64; 3],
        attitude: ExactQuaternion,
        force: [f64; 3],
        (axis, arm): (usize, f64),
    ) -> Self {
        let others = [(axis + 1) % 3, (axis + 2) % 3];
        let mut sides = [1.0; 3];
        sides[axis] = arm;
        let frame = Frame::new([others[0], others[1], axis], sides);
        let [f1, f2, f3] = force.map(|part| DoubleDouble::product(part, part));
        let weight = (f1 + f2 + f3).sqrt();
        let upright = upright_from_world(force.map(|part| DoubleDouble::from(-part)), weight);
        let from_primed = upright.times(attitude).times(frame.principal_from_primed());
        let ExactQuaternion([w, x, y, z]) = ExactQuaternion::normalised(from_primed.0);
        let [w1, w2, w3] = frame.vector(omega).map(DoubleDouble::from);
        let (transverse, axial) = (moments[others[0]], moments[axis]);
        Self {
            frame,
            world_from_upright: upright.conjugate(),
            pair: [[w, z], [x, y]],
            across: [w1, w2],
            along: w3,
            spin: w3 * axial / transverse.into(),
            half_excess: (DoubleDouble::sum(transverse, -axial) / transverse.into() * w3).scale(0.5),
            strength: (weight * arm.abs()).scale(2.0) / transverse.into(),
        }
    }

    /// A B* (ω₁ + iω₂).
    fn swing(&self) -> [DoubleDouble; 2] {
        product(product(self.pair[0], conjugate(self.pair[1])), self.across)
    }

    /// b − a u: what L has about the vertical beside its part along the axis, over J₁.
    pub fn upright_rate(&self) -> DoubleDouble {
        self.swing()[1].scale(2.0)
    }

    /// u′.
    pub fn slope(&self) -> DoubleDouble {
        self.swing()[0].scale(-2.0)
    }

    /// A′ and B′.
    pub fn pair_rates(&self) -> [[DoubleDouble; 2]; 2] {
        let [a, b] = self.pair;
        let along = [DoubleDouble::ZERO, self.along];
        let (turned, swung) = (product(along, a), product(b, conjugate(self.across)));
        let first = [turned[0] - swung[0], turned[1] - swung[1]].map(|part| part.scale(0.5));
        let (swung, turned) = (product(a, self.across), product(along, b));
        [first, [swung[0] - turned[0], swung[1] - turned[1]].map(|part| part.scale(0.5))]
    }
}
