use super::Scheme;
use super::composition::{KAHAN_LI_6, KAHAN_LI_8, STRANG, SUZUKI_4};
use super::euler_naive::EulerNaive;
use super::euler_semi_implicit::EulerSemiImplicit;
use super::free_flow::FreeFlow;
use super::gauss::{GAUSS_2_STAGES, GAUSS_3_STAGES, Gauss};
use super::kicked::Kicked;
use super::moser_veselov::MoserVeselov;
use super::planar_rotations::PlanarRotations;
use super::preprocessing::CORRECTIONS;
use super::rkmk4::Rkmk4;
use crate::dynamics::Problem;
use crate::propagation::runge_kutta::ClassicRk4;

/// A method with a fixed step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FixedStepMethod {
    /// Explicit Euler on the rotation matrix, orthogonalised again after each step.
    EulerNaive,
    /// ω first, gyroscopic term and all, then the attitude with the new ω: as physics engines do it.
    EulerSemiImplicit,
    /// The classical Runge–Kutta method.
    Rk4,
    /// Its counterpart on the group of rotations, after Munthe-Kaas.
    Rkmk4,
    /// Rotations about the principal axes one after the other, half a moment before and after.
    Splitting2,
    /// The same, composed to order 4.
    Splitting4,
    /// The same, composed to order 6.
    Splitting6,
    /// The same, composed to order 8.
    Splitting8,
    /// The discrete Moser–Veselov equations of a free body.
    Dmv2,
    /// The same with moments of inertia preprocessed for order 4.
    Dmv4,
    /// The same for order 6.
    Dmv6,
    /// The same for order 8.
    Dmv8,
    /// Gauss collocation, two stages.
    Gauss4,
    /// Gauss collocation, three stages.
    Gauss6,
    /// The exact free motion, half a moment before and after.
    Kicks2,
    /// The same, composed to order 4.
    Kicks4,
}

/// What a method is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Information {
    /// As scenes name it.
    pub name: &'static str,
    /// As tables show it.
    pub title: &'static str,
    /// The error over a given time goes like this power of the step.
    pub order: u32,
    /// Run backwards from its end, a step leads exactly to its start.
    pub is_symmetric: bool,
    /// What may act on the body.
    pub coverage: Coverage,
    /// Where it is described, by the keys of `docs/references.md`.
    pub source: &'static str,
}

/// What may act on a body for a method to propagate it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coverage {
    /// Every load, and a [`TorqueModel`](crate::dynamics::TorqueModel) of the caller's own.
    Everything,
    /// Every [`Torque`](crate::dynamics::Torque) but a rotor, whose moment grows with ω across it.
    ListedLoads,
    /// Nothing but uniform gravity.
    TorqueFree,
}

impl FixedStepMethod {
    /// All of them, from what everybody tries first to what is made for the purpose.
    pub const ALL: [Self; 16] = [
        Self::EulerNaive,
        Self::EulerSemiImplicit,
        Self::Rk4,
        Self::Rkmk4,
        Self::Splitting2,
        Self::Splitting4,
        Self::Splitting6,
        Self::Splitting8,
        Self::Dmv2,
        Self::Dmv4,
        Self::Dmv6,
        Self::Dmv8,
        Self::Gauss4,
        Self::Gauss6,
        Self::Kicks2,
        Self::Kicks4,
    ];

    /// What it is: the table of methods.
    #[must_use]
    pub const fn information(self) -> Information {
        use Coverage::{Everything, ListedLoads, TorqueFree};
        let (name, title, order, is_symmetric, coverage, source) = match self {
            Self::EulerNaive => ("euler_naive", "naive Euler", 1, false, Everything, "Baraff97"),
            Self::EulerSemiImplicit => {
                ("euler_semi_implicit", "semi-implicit Euler", 1, false, Everything, "HLW06 §I.1.2")
            }
            Self::Rk4 => ("rk4", "RK4", 4, false, Everything, "HNW93 §II.1"),
            Self::Rkmk4 => ("rkmk4", "RKMK4", 4, false, Everything, "MuntheKaas99"),
            Self::Splitting2 => ("splitting2", "splitting 2", 2, true, ListedLoads, "McLachlan93, Reich94"),
            Self::Splitting4 => ("splitting4", "splitting 4", 4, true, ListedLoads, "McLachlan93, Reich94, Suzuki90"),
            Self::Splitting6 => ("splitting6", "splitting 6", 6, true, ListedLoads, "McLachlan93, Reich94, KL97"),
            Self::Splitting8 => ("splitting8", "splitting 8", 8, true, ListedLoads, "McLachlan93, Reich94, KL97"),
            Self::Dmv2 => ("dmv2", "discrete Moser–Veselov 2", 2, true, TorqueFree, "MV91"),
            Self::Dmv4 => ("dmv4", "discrete Moser–Veselov 4", 4, true, TorqueFree, "HV06"),
            Self::Dmv6 => ("dmv6", "discrete Moser–Veselov 6", 6, true, TorqueFree, "HV06"),
            Self::Dmv8 => ("dmv8", "discrete Moser–Veselov 8", 8, true, TorqueFree, "HV06"),
            Self::Gauss4 => ("gauss4", "Gauss 4", 4, true, Everything, "HLW06 §II.1.3, §VIII.6"),
            Self::Gauss6 => ("gauss6", "Gauss 6", 6, true, Everything, "HLW06 §II.1.3, §VIII.6"),
            Self::Kicks2 => ("kicks2", "kicks 2", 2, true, ListedLoads, "CFSZ08"),
            Self::Kicks4 => ("kicks4", "kicks 4", 4, true, ListedLoads, "CFSZ08, Suzuki90"),
        };
        Information { name, title, order, is_symmetric, coverage, source }
    }

    /// The method, ready to step.
    pub(super) fn scheme(self, problem: &Problem) -> Box<dyn Scheme> {
        let splitting = |composition| Box::new(Kicked::new(PlanarRotations::new(problem), composition));
        let moser_veselov = |corrections| Box::new(MoserVeselov::new(problem, &CORRECTIONS[..corrections]));
        let kicks = |composition| Box::new(Kicked::new(FreeFlow::new(problem), composition));
        match self {
            Self::EulerNaive => Box::new(EulerNaive),
            Self::EulerSemiImplicit => Box::new(EulerSemiImplicit),
            Self::Rk4 => Box::new(ClassicRk4),
            Self::Rkmk4 => Box::new(Rkmk4),
            Self::Splitting2 => splitting(STRANG),
            Self::Splitting4 => splitting(&SUZUKI_4),
            Self::Splitting6 => splitting(&KAHAN_LI_6),
            Self::Splitting8 => splitting(&KAHAN_LI_8),
            Self::Dmv2 => moser_veselov(0),
            Self::Dmv4 => moser_veselov(1),
            Self::Dmv6 => moser_veselov(2),
            Self::Dmv8 => moser_veselov(3),
            Self::Gauss4 => Box::new(Gauss::new(&GAUSS_2_STAGES)),
            Self::Gauss6 => Box::new(Gauss::new(&GAUSS_3_STAGES)),
            Self::Kicks2 => kicks(STRANG),
            Self::Kicks4 => kicks(&SUZUKI_4),
        }
    }
}
