use super::Update;
use crate::recording::Axes;

/// What is likely wrong with the program that made a file.
#[derive(Debug, Clone, PartialEq)]
pub enum Cause {
    /// The four numbers are x, y, z, w.
    QuaternionOrder,
    /// The quaternion takes world to body.
    QuaternionConjugated,
    /// ω is in degrees per second.
    Degrees,
    /// ω is in other axes than the file says.
    OtherFrameThanTold {
        /// In which it is.
        found: Axes,
    },
    /// The attitude turns this many times as fast as ω says.
    TimeScale {
        /// How many.
        factor: f64,
    },
    /// Attitudes jump: frames are missing.
    DroppedFrames,
    /// ω × I ω is left out: ω stays constant where no torque acts.
    MissingGyroscopicTerm,
    /// ω changes as it does in one frame, and turns the attitude as if it were in the other.
    WrongFrame {
        /// In which it turns the attitude.
        turns_in: Axes,
    },
    /// The inertia tensor is not turned with the body.
    InertiaNotRotated,
    /// The moments are those of the body in another order.
    PermutedMoments {
        /// Whose moment each axis has.
        order: [usize; 3],
    },
    /// The motion is that of another body.
    OtherInertia {
        /// Its principal moments, the largest 1.
        ratios: [f64; 3],
    },
    /// ω is stepped explicitly at first order.
    ExplicitStep {
        /// Of the step, s.
        step_s: f64,
    },
    /// ω is stepped implicitly at first order.
    ImplicitStep {
        /// Of the step, s.
        step_s: f64,
    },
    /// ω dies away.
    Damping {
        /// 1/s.
        rate: f64,
    },
    /// |ω| is cut off.
    ClampedRate {
        /// rad/s.
        limit: f64,
    },
    /// The torque acts in world axes where it should in body axes, or the other way.
    TorqueInWrongFrame,
    /// The torque does not act.
    TorqueMissing,
    /// The torque acts with the other sign.
    TorqueReversed,
    /// The torque is this many times as strong.
    TorqueScaled {
        /// How many.
        factor: f64,
    },
    /// The attitude is stepped by adding q̇ h (or Ṙ h), and made a rotation again.
    FirstOrderAttitude {
        /// Of the step, s.
        step_s: f64,
        /// The formula, where it holds to rounding.
        update: Option<Update>,
    },
    /// The quaternion is not normalised.
    NotNormalised,
    /// Attitude and ω of a sample belong to different times.
    OutOfStep {
        /// By how much, s.
        lag_s: f64,
        /// The formula, where it holds to rounding.
        update: Option<Update>,
    },
    /// The numbers are those of 32-bit arithmetic.
    SinglePrecision,
    /// ω is noisy, or the attitude is.
    Noise,
    /// An error of the method that is none of these.
    Truncation,
    /// Attitude and ω do not belong together.
    RatesDisagree,
}

/// A cause, and what speaks for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// What is wrong.
    pub cause: Cause,
    /// The share of the error that it explains, 0 to 1.
    pub share: f64,
    /// What was measured that says so.
    pub evidence: String,
}

impl Cause {
    /// A name for scripts.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::QuaternionOrder => "quaternion_order",
            Self::QuaternionConjugated => "quaternion_conjugated",
            Self::Degrees => "degrees",
            Self::OtherFrameThanTold { .. } => "other_frame_than_told",
            Self::TimeScale { .. } => "time_scale",
            Self::DroppedFrames => "dropped_frames",
            Self::MissingGyroscopicTerm => "missing_gyroscopic_term",
            Self::WrongFrame { .. } => "wrong_frame",
            Self::InertiaNotRotated => "inertia_not_rotated",
            Self::PermutedMoments { .. } => "permuted_moments",
            Self::OtherInertia { .. } => "other_inertia",
            Self::ExplicitStep { .. } => "explicit_step",
            Self::ImplicitStep { .. } => "implicit_step",
            Self::Damping { .. } => "damping",
            Self::ClampedRate { .. } => "clamped_rate",
            Self::TorqueInWrongFrame => "torque_in_wrong_frame",
            Self::TorqueMissing => "torque_missing",
            Self::TorqueReversed => "torque_reversed",
            Self::TorqueScaled { .. } => "torque_scaled",
            Self::FirstOrderAttitude { .. } => "first_order_attitude",
            Self::NotNormalised => "not_normalised",
            Self::OutOfStep { .. } => "out_of_step",
            Self::SinglePrecision => "single_precision",
            Self::Noise => "noise",
            Self::Truncation => "truncation",
            Self::RatesDisagree => "rates_disagree",
        }
    }

    /// What is wrong, in a line.
    #[must_use]
    pub fn words(&self) -> String {
        match self {
            Self::QuaternionOrder => "the quaternion is x, y, z, w, not w, x, y, z".into(),
            Self::QuaternionConjugated => "the quaternion takes world to body, not body to world".into(),
            Self::Degrees => "ω is in degrees per second".into(),
            Self::OtherFrameThanTold { found: Axes::World } => "ω is in world axes, not in body axes".into(),
            Self::OtherFrameThanTold { found: Axes::Body } => "ω is in body axes, not in world axes".into(),
            Self::TimeScale { factor } => format!("the attitude turns {factor:.6} times as fast as ω says"),
            Self::DroppedFrames => "the attitude jumps: frames are missing".into(),
            Self::MissingGyroscopicTerm => "the gyroscopic term ω × I ω is missing".into(),
            Self::WrongFrame { turns_in: Axes::World } => {
                "ω in body axes turns the attitude as if in world axes".into()
            }
            Self::WrongFrame { turns_in: Axes::Body } => "ω in world axes turns the attitude as if in body axes".into(),
            Self::InertiaNotRotated => "the inertia tensor is not turned with the body".into(),
            Self::PermutedMoments { order } => {
                let names = order.map(|axis| ["I1", "I2", "I3"][axis]);
                format!("the moments are in another order: axes x, y, z have {}", names.join(", "))
            }
            Self::OtherInertia { ratios: [a, b, c] } => {
                format!("the motion is that of a body with moments {a:.4} : {b:.4} : {c:.4}")
            }
            Self::ExplicitStep { step_s } => format!("explicit Euler steps of ω, of about {step_s:.3e} s"),
            Self::ImplicitStep { step_s } => format!("implicit Euler steps of ω, of about {step_s:.3e} s"),
            Self::Damping { rate } => format!("angular damping of {rate:.4e} per second"),
            Self::ClampedRate { limit } => format!("|ω| is cut off at {limit:.6} rad/s"),
            Self::TorqueInWrongFrame => "the torque acts in the wrong axes".into(),
            Self::TorqueMissing => "the torque does not act".into(),
            Self::TorqueReversed => "the torque acts with the wrong sign".into(),
            Self::TorqueScaled { factor } => format!("the torque is {factor:.4} times as strong as stated"),
            Self::FirstOrderAttitude { step_s, .. } => {
                format!("the attitude is stepped at first order and normalised, by about {step_s:.3e} s")
            }
            Self::NotNormalised => "the quaternion is not normalised".into(),
            Self::OutOfStep { lag_s, .. } => format!("attitude and ω of a sample are {:.3e} s apart", lag_s.abs()),
            Self::SinglePrecision => "rounding of 32-bit arithmetic".into(),
            Self::Noise => "noise: each sample is off by itself".into(),
            Self::Truncation => "the method's own error: nothing known explains it".into(),
            Self::RatesDisagree => "attitude and ω are not of one motion".into(),
        }
    }

    /// What to look at.
    #[must_use]
    pub fn advice(&self) -> &'static str {
        match self {
            Self::QuaternionOrder => "Reorder the columns on the way in or out: Hamilton's order is w first.",
            Self::QuaternionConjugated => {
                "Conjugate it, or say body from world. ω with its sign reversed, in the other axes, looks the same."
            }
            Self::Degrees => "Multiply by π/180.",
            Self::OtherFrameThanTold { .. } => "Rotate ω by the attitude where it is logged, or rename its frame.",
            Self::TimeScale { .. } => {
                "The step that q is advanced by is not the step between the times, or ω has another unit."
            }
            Self::DroppedFrames => "The recorder lost frames, or gave them evenly spaced times that they did not have.",
            Self::MissingGyroscopicTerm => {
                "Look for ω += h I⁻¹ τ: it wants I⁻¹ (τ − ω × I ω). Or keep L in world axes, and ω = R I⁻¹ Rᵀ L."
            }
            Self::WrongFrame { turns_in: Axes::World } => {
                "Look at the product in q̇: ω in body axes wants q (0, ω)/2, ω in world axes (0, ω) q/2. An inertia tensor held \
                 in world axes, with its gyroscopic term, does the same."
            }
            Self::WrongFrame { turns_in: Axes::Body } => {
                "Look at the product in q̇: ω in world axes wants (0, ω) q/2, ω in body axes q (0, ω)/2."
            }
            Self::InertiaNotRotated => "Update the world tensor each step: R I Rᵀ, or its inverse R I⁻¹ Rᵀ.",
            Self::PermutedMoments { .. } => "Look at the order of the axes where the moments go in.",
            Self::OtherInertia { .. } => {
                "Look at the inertia given to the program: axes, products, an engine's own from shape and density."
            }
            Self::ExplicitStep { .. } => {
                "The gyroscopic term by the old ω feeds energy in, ∝ h. Step it implicitly, use a smaller step, or keep L."
            }
            Self::ImplicitStep { .. } => {
                "An implicit gyroscopic step takes energy out, ∝ h, and drifts to the axis of the largest moment."
            }
            Self::Damping { .. } => "Engines damp by default (angularDamping, linearDamping): set it to 0.",
            Self::ClampedRate { .. } => "Engines limit ω by default (maxAngularVelocity): raise it.",
            Self::TorqueInWrongFrame => {
                "Look whether torque is added to world or body axes, and turn it by the attitude."
            }
            Self::TorqueMissing => "Look whether it is applied at every step: engines clear torques after each.",
            Self::TorqueReversed => "Look at the order in arm × force.",
            Self::TorqueScaled { .. } => "Look at units, at substeps that each apply all of it, and at the lever arm.",
            Self::FirstOrderAttitude { .. } => {
                "q + h q̇, normalised, turns by 2 arctan(|ω|h/2) in place of |ω|h: multiply by exp(h ω) instead."
            }
            Self::NotNormalised => "Normalise q after each step, or multiply by unit quaternions.",
            Self::OutOfStep { .. } => {
                "Semi-implicit steps move q by the new ω: record ω half a step later, or compare with that in mind."
            }
            Self::SinglePrecision => "32-bit floats hold 7 digits: over many steps their rounding adds up.",
            Self::Noise => "Is this a measurement? Then the exact motion is not what it should repeat to all digits.",
            Self::Truncation => {
                "Halve the step: the power of two by which the error falls is the order that the method really has."
            }
            Self::RatesDisagree => "Look whether both are of the same body, clock and frame.",
        }
    }
}
