use nalgebra::Vector3;

use crate::body::PrincipalMoments;

/// Euler's equations of a rigid body in principal axes, their constants worked out once.
///
/// I ω̇ = (I ω) × ω + τ, written with differences of moments: ω̇₁ = (I₂ − I₃)/I₁ · ω₂ω₃ + τ₁/I₁ and cyclic. On a nearly
/// round body the cross product would subtract two large numbers; these products lose nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EulerEquations {
    inertia: Vector3<f64>,
    coupling: Vector3<f64>,
}

impl EulerEquations {
    /// For a body with these moments.
    #[must_use]
    pub fn new(moments: PrincipalMoments) -> Self {
        Self::around(0.0, moments)
    }

    /// For the shell about a sphere of moment `inner` in kg m², less than each of `moments`, which are of both together.
    #[must_use]
    pub fn around(inner: f64, moments: PrincipalMoments) -> Self {
        let [a, b, c]: [f64; 3] = moments.vector().into();
        let inertia = moments.vector().add_scalar(-inner);
        Self { inertia, coupling: Vector3::new(b - c, c - a, a - b).component_div(&inertia) }
    }

    /// (I₂ − I₃)/I₁ and cyclic: what turns ω₂ω₃ into ω̇₁.
    #[must_use]
    pub fn coupling(&self) -> Vector3<f64> {
        self.coupling
    }

    /// The principal moments, kg m².
    #[must_use]
    pub fn inertia(&self) -> Vector3<f64> {
        self.inertia
    }

    /// ω̇ in rad/s² from ω in rad/s and τ in N m, all in principal axes.
    #[must_use]
    pub fn acceleration(&self, omega: &Vector3<f64>, moment: &Vector3<f64>) -> Vector3<f64> {
        let gyroscopic = Vector3::new(
            self.coupling.x * (omega.y * omega.z),
            self.coupling.y * (omega.z * omega.x),
            self.coupling.z * (omega.x * omega.y),
        );
        gyroscopic + moment.component_div(&self.inertia)
    }
}

/// q̇ = ½ q (0, ω), 1/s, for q = [w, x, y, z] from body to world and ω in body axes, rad/s.
#[must_use]
pub fn attitude_rate(wxyz: [f64; 4], omega: &Vector3<f64>) -> [f64; 4] {
    let [w, x, y, z] = wxyz;
    let half = 0.5 * omega;
    [
        -(x * half.x + y * half.y + z * half.z),
        w * half.x + y * half.z - z * half.y,
        w * half.y + z * half.x - x * half.z,
        w * half.z + x * half.y - y * half.x,
    ]
}
