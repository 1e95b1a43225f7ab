//! What a scene says of a load.

use polhode::scenario::{
    AfterTable, BDotSpec, BodySpec, BrakeSpec, DampingSpec, ForceFormulaSpec, ForceSpec, Frame, GravityGradientSpec,
    InnerSphereSpec, MagneticDipoleSpec, MomentSpec, QuadraticDampingSpec, QuadraticDragSpec, QuaternionFeedbackSpec,
    RateFeedbackSpec, RotorSpec, SpringSpec, TableSpec, ThrusterSpec, TorqueFormulaSpec,
};

use super::{Kind, Span, Vector, formulae};
use crate::properties::equivalence::case::wxyz;

fn moment(moment: &Vector, &[start_s, end_s]: &Span) -> MomentSpec {
    MomentSpec { moment_n_m: (*moment).into(), start_s, end_s }
}

fn force(force: &Vector, point: &Vector, &[start_s, end_s]: &Span) -> ForceSpec {
    ForceSpec { force_n: (*force).into(), point_m: (*point).into(), start_s, end_s }
}

impl Kind {
    pub fn add_to(&self, body: &mut BodySpec, span: &Span) {
        let [start_s, end_s] = *span;
        let (torque, push) = (&mut body.torque, &mut body.force);
        match *self {
            Self::ConstantBody(ref vector) => torque.constant_body.push(moment(vector, span)),
            Self::ConstantWorld(ref vector) => torque.constant_world.push(moment(vector, span)),
            Self::LinearDamping(coefficient_n_m_s) => {
                torque.linear_damping.push(DampingSpec { coefficient_n_m_s, start_s, end_s });
            }
            Self::MomentumBrake(rate_per_s) => torque.momentum_brake.push(BrakeSpec { rate_per_s, start_s, end_s }),
            Self::Dipole { dipole, field } => {
                let (dipole_a_m2, field_t) = (dipole.into(), field.into());
                torque.magnetic_dipole.push(MagneticDipoleSpec { dipole_a_m2, field_t, start_s, end_s });
            }
            Self::Gradient { mean_motion: mean_motion_rad_s } => {
                torque.gravity_gradient.push(GravityGradientSpec { mean_motion_rad_s, start_s, end_s });
            }
            Self::Table { ref rows, is_world, interpolation, holds, point } => {
                let rows = rows.iter().map(|(time, vector)| [*time, vector.x, vector.y, vector.z]).collect();
                let table = TableSpec {
                    file: None,
                    rows: Some(rows),
                    frame: if is_world { Frame::World } else { Frame::Body },
                    interpolation,
                    after: if holds { AfterTable::Hold } else { AfterTable::Zero },
                    point_m: point.map(Into::into),
                    start_s,
                    end_s,
                };
                if point.is_some() { push.table.push(table) } else { torque.table.push(table) }
            }
            Self::ForceBody { force: ref vector, ref point } => push.constant_body.push(force(vector, point, span)),
            Self::ForceWorld { force: ref vector, ref point } => push.constant_world.push(force(vector, point, span)),
            Self::Thruster { direction, thrust: thrust_n, point, ref pulses } => push.thruster.push(ThrusterSpec {
                direction: direction.into(),
                thrust_n,
                point_m: point.into(),
                pulses_s: Some(pulses.iter().map(|pulse| pulse.to_vec()).collect()),
                period_s: None,
                duty: None,
                start_s,
                end_s,
            }),
            Self::Rotor { axis, ref momenta } => body.rotor.push(RotorSpec {
                axis: axis.into(),
                momentum_n_m_s: None,
                times_s: Some(momenta.iter().map(|pair| pair.0).collect()),
                momenta_n_m_s: Some(momenta.iter().map(|pair| pair.1).collect()),
            }),
            _ => self.add_general_to(body, span),
        }
    }

    fn add_general_to(&self, body: &mut BodySpec, &[start_s, end_s]: &Span) {
        let (torque, push) = (&mut body.torque, &mut body.force);
        let formula = |moment_n_m, frame| TorqueFormulaSpec { moment_n_m, frame, start_s, end_s };
        match *self {
            Self::Spring { anchor, point, stiffness, rest, damping, is_tether } => push.spring.push(SpringSpec {
                anchor_m: anchor.into(),
                point_m: point.into(),
                stiffness_n_per_m: stiffness,
                rest_length_m: rest,
                damping_n_s_per_m: Some(damping),
                pulls_only: is_tether,
                start_s,
                end_s,
            }),
            Self::Drag { coefficient: coefficient_kg_per_m, point } => {
                let point_m = point.into();
                push.quadratic_drag.push(QuadraticDragSpec { coefficient_kg_per_m, point_m, start_s, end_s });
            }
            Self::QuadraticDamping(coefficient_n_m_s2) => {
                torque.quadratic_damping.push(QuadraticDampingSpec { coefficient_n_m_s2, start_s, end_s });
            }
            Self::Sphere { inertia: inertia_kg_m2, coefficient: coefficient_n_m_s, relative } => {
                let relative_rate_rad_s = Some(relative.into());
                torque.inner_sphere.push(InnerSphereSpec { inertia_kg_m2, coefficient_n_m_s, relative_rate_rad_s });
            }
            Self::Feedback { target, stiffness, damping, limit, dead_band } => {
                torque.quaternion_feedback.push(QuaternionFeedbackSpec {
                    target: wxyz(&target),
                    attitude_gain_n_m: stiffness,
                    rate_gain_n_m_s: damping,
                    limit_n_m: limit,
                    dead_band_n_m: Some(dead_band),
                    start_s,
                    end_s,
                });
            }
            Self::RateFeedback { gain: gain_n_m_s, limit: limit_n_m } => {
                torque.rate_feedback.push(RateFeedbackSpec { gain_n_m_s, limit_n_m, start_s, end_s });
            }
            Self::BDot { field, turning, gain, limit } => torque.b_dot.push(BDotSpec {
                field_t: field.into(),
                field_turning_rad_s: Some(turning.into()),
                gain_a_m2_s_per_t: gain,
                limit_a_m2: limit,
                start_s,
                end_s,
            }),
            Self::FormulaBody { ref matrix, ref swing, beat, ref world } => {
                torque.formula.push(formula(formulae::in_body(matrix, swing, beat, world), Frame::Body));
            }
            Self::FormulaWorld { ref matrix, ref swing, beat, ref body } => {
                torque.formula.push(formula(formulae::in_world(matrix, swing, beat, body), Frame::World));
            }
            Self::FormulaForce { pull, ref anchor, ref swing, beat, point } => {
                let (force_n, point_m) = (formulae::pull(pull, anchor, swing, beat), point.into());
                push.formula.push(ForceFormulaSpec { force_n, frame: Frame::World, point_m, start_s, end_s });
            }
            _ => unreachable!("listed"),
        }
    }
}
