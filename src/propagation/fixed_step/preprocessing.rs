//! Preprocessing of the discrete Moser–Veselov equations: by which moments of inertia they give the true motion.
//!
//! `[HV06]` shows that there are scalars s and d of the energy and the momentum with which
//! 1/Ĩⱼ = (1 + h² s₃ + h⁴ s₅ + …)/Iⱼ + h² d₃ + h⁴ d₅ + … makes a step exact, however far the series is taken. The terms
//! below were found from that: put the exact p(h) into 2 (p₀ Ĩ p + p × Ĩ p) = h L; at each even power of h three
//! equations agree on two scalars, and these are polynomials in H, C and the symmetric functions of 1/Iⱼ. The measured
//! orders hold them (`fixed_step::every_method_is_of_its_order_on_every_smooth_torque`).

/// One term: numerator, denominator, and the powers of H = ½ Σ Lⱼ²/Iⱼ, C = ½ |L|², Σ 1/Iⱼ, Σ 1/(IⱼIₖ), 1/(I₁I₂I₃).
pub(super) type Term = (f64, f64, [usize; 5]);

/// The terms of s and of d at one power of h.
pub(super) struct Correction {
    /// Of s.
    pub factor: &'static [Term],
    /// Of d.
    pub shift: &'static [Term],
}

/// At h², h⁴, h⁶: for orders 4, 6, 8.
pub(super) static CORRECTIONS: [Correction; 3] = [
    Correction {
        factor: &[(-1.0, 3.0, [1, 0, 1, 0, 0]), (1.0, 6.0, [0, 1, 0, 1, 0])],
        shift: &[(1.0, 6.0, [1, 0, 0, 1, 0]), (-1.0, 3.0, [0, 1, 0, 0, 1])],
    },
    Correction {
        factor: &[
            (1.0, 30.0, [2, 0, 2, 0, 0]),
            (-1.0, 60.0, [2, 0, 0, 1, 0]),
            (-1.0, 30.0, [1, 1, 1, 1, 0]),
            (2.0, 15.0, [1, 1, 0, 0, 1]),
            (1.0, 30.0, [0, 2, 0, 2, 0]),
            (-1.0, 10.0, [0, 2, 1, 0, 1]),
        ],
        shift: &[
            (-1.0, 60.0, [2, 0, 1, 1, 0]),
            (-1.0, 10.0, [2, 0, 0, 0, 1]),
            (-1.0, 60.0, [1, 1, 0, 2, 0]),
            (2.0, 15.0, [1, 1, 1, 0, 1]),
            (-1.0, 60.0, [0, 2, 0, 1, 1]),
        ],
    },
    Correction {
        factor: &[
            (-1.0, 630.0, [3, 0, 3, 0, 0]),
            (1.0, 630.0, [3, 0, 1, 1, 0]),
            (1.0, 35.0, [3, 0, 0, 0, 1]),
            (1.0, 420.0, [2, 1, 2, 1, 0]),
            (41.0, 2520.0, [2, 1, 0, 2, 0]),
            (-53.0, 630.0, [2, 1, 1, 0, 1]),
            (-1.0, 70.0, [1, 2, 1, 2, 0]),
            (11.0, 210.0, [1, 2, 2, 0, 1]),
            (-1.0, 84.0, [1, 2, 0, 1, 1]),
            (17.0, 2520.0, [0, 3, 0, 3, 0]),
            (-11.0, 420.0, [0, 3, 1, 1, 1]),
            (5.0, 126.0, [0, 3, 0, 0, 2]),
        ],
        shift: &[
            (1.0, 1260.0, [3, 0, 2, 1, 0]),
            (-13.0, 1260.0, [3, 0, 0, 2, 0]),
            (1.0, 42.0, [3, 0, 1, 0, 1]),
            (13.0, 2520.0, [2, 1, 1, 2, 0]),
            (-8.0, 315.0, [2, 1, 2, 0, 1]),
            (11.0, 252.0, [2, 1, 0, 1, 1]),
            (1.0, 1260.0, [1, 2, 0, 3, 0]),
            (-1.0, 1260.0, [1, 2, 1, 1, 1]),
            (-22.0, 315.0, [1, 2, 0, 0, 2]),
            (-19.0, 2520.0, [0, 3, 0, 2, 1]),
            (1.0, 35.0, [0, 3, 1, 0, 2]),
        ],
    },
];
