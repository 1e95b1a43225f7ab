//! Loads of the kinds that go by a tape.

use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};

use super::plan::window;
use crate::body::{MassProperties, State};
use crate::dynamics::formula::{Expression, Variable};
use crate::dynamics::{
    BDot, FormulaLoad, FormulaPlace, General, GeneralLoad, InnerSphere, Load, QuaternionFeedback, RateFeedback, Spring,
    Torque, Window,
};
use crate::scenario::plan::rules::{not_negative, optional_vector, positive, rotation, vector};
use crate::scenario::{BodySpec, Frame, InnerSphereSpec, Key, QuaternionFeedbackSpec, Refusal, SpringSpec};

/// What these loads have to know of the body.
struct Body<'a> {
    properties: &'a MassProperties,
    initial: &'a State,
    is_held: bool,
}

/// Those of the body at `key`, in principal axes.
pub fn plan(key: &Key, spec: &BodySpec, properties: &MassProperties, initial: &State) -> Result<Vec<Load>, Refusal> {
    let body = Body { properties, initial, is_held: spec.pivot.is_some() };
    let mut loads = torques(key, spec, &body)?;
    loads.extend(forces(key, spec, &body)?);
    Ok(loads)
}

fn torques(key: &Key, spec: &BodySpec, body: &Body) -> Result<Vec<Load>, Refusal> {
    let (torques, mut loads) = (key.field("torque"), Vec::new());
    let body_from_principal = body.properties.body_from_principal;
    for (index, spec) in spec.torque.formula.iter().enumerate() {
        let key = torques.field("formula").index(index);
        let components = body.expressions(&key.field("moment_n_m"), &spec.moment_n_m)?;
        let kind = body.by_formula(components, spec.frame, FormulaPlace::Moment);
        loads.push(load(kind, window(&key, spec.start_s, spec.end_s)?));
    }
    for (index, spec) in spec.torque.quadratic_damping.iter().enumerate() {
        let key = torques.field("quadratic_damping").index(index);
        let coefficient = not_negative(&key.field("coefficient_n_m_s2"), spec.coefficient_n_m_s2)?;
        loads.push(load(General::QuadraticDamping { coefficient }, window(&key, spec.start_s, spec.end_s)?));
    }
    for (index, spec) in spec.torque.inner_sphere.iter().enumerate() {
        let key = torques.field("inner_sphere").index(index);
        if index > 0 {
            return Err(key.refuse("a body has one sphere inside it at most"));
        }
        loads.push(load(General::InnerSphere(body.sphere(&key, spec)?), Window::ALWAYS));
    }
    for (index, spec) in spec.torque.quaternion_feedback.iter().enumerate() {
        let key = torques.field("quaternion_feedback").index(index);
        let kind = General::QuaternionFeedback(body.feedback(&key, spec)?);
        loads.push(load(kind, window(&key, spec.start_s, spec.end_s)?));
    }
    for (index, spec) in spec.torque.rate_feedback.iter().enumerate() {
        let key = torques.field("rate_feedback").index(index);
        let gain = not_negative(&key.field("gain_n_m_s"), spec.gain_n_m_s)?;
        let limit = limit(&key.field("limit_n_m"), spec.limit_n_m)?;
        let kind = General::RateFeedback(RateFeedback { gain, limit, body_from_principal });
        loads.push(load(kind, window(&key, spec.start_s, spec.end_s)?));
    }
    for (index, spec) in spec.torque.b_dot.iter().enumerate() {
        let key = torques.field("b_dot").index(index);
        let kind = General::BDot(BDot {
            gain: not_negative(&key.field("gain_a_m2_s_per_t"), spec.gain_a_m2_s_per_t)?,
            limit: limit(&key.field("limit_a_m2"), spec.limit_a_m2)?,
            field: vector(&key.field("field_t"), spec.field_t)?,
            turning: optional_vector(&key.field("field_turning_rad_s"), spec.field_turning_rad_s)?,
            body_from_principal,
        });
        loads.push(load(kind, window(&key, spec.start_s, spec.end_s)?));
    }
    Ok(loads)
}

fn forces(key: &Key, spec: &BodySpec, body: &Body) -> Result<Vec<Load>, Refusal> {
    let (forces, mut loads) = (key.field("force"), Vec::new());
    for (index, spec) in spec.force.formula.iter().enumerate() {
        let key = forces.field("formula").index(index);
        let components = body.expressions(&key.field("force_n"), &spec.force_n)?;
        let place = FormulaPlace::Force { arm: body.arm(&key.field("point_m"), spec.point_m)? };
        let kind = body.by_formula(components, spec.frame, place);
        loads.push(load(kind, window(&key, spec.start_s, spec.end_s)?));
    }
    for (index, spec) in spec.force.spring.iter().enumerate() {
        let key = forces.field("spring").index(index);
        let kind = General::Spring(body.spring(&key, spec)?);
        loads.push(load(kind, window(&key, spec.start_s, spec.end_s)?));
    }
    for (index, spec) in spec.force.quadratic_drag.iter().enumerate() {
        let key = forces.field("quadratic_drag").index(index);
        let coefficient = not_negative(&key.field("coefficient_kg_per_m"), spec.coefficient_kg_per_m)?;
        let arm = body.arm(&key.field("point_m"), spec.point_m)?;
        loads.push(load(General::QuadraticDrag { coefficient, arm }, window(&key, spec.start_s, spec.end_s)?));
    }
    Ok(loads)
}

fn load(kind: General, window: Window) -> Load {
    Load { torque: Torque::General(Arc::new(GeneralLoad::new(kind))), window }
}

impl Body<'_> {
    fn by_formula(&self, components: [Expression; 3], frame: Frame, place: FormulaPlace) -> General {
        let body_from_principal = self.properties.body_from_principal;
        General::Formula(FormulaLoad { components, in_world: frame == Frame::World, place, body_from_principal })
    }

    /// Three formulae.
    fn expressions(&self, key: &Key, texts: &[String; 3]) -> Result<[Expression; 3], Refusal> {
        let read = |index: usize| {
            let (key, text) = (key.index(index), &texts[index]);
            let expression =
                Expression::read(text).map_err(|error| key.refuse(format_args!("{:?} {error}", shortened(text))))?;
            let is_translation = |variable: Variable| matches!(variable, Variable::Position(_) | Variable::Velocity(_));
            if self.is_held && expression.names(&is_translation) {
                let rule = "contradicts the pivot: the position and the velocity of a body that is held do not change";
                return Err(key.refuse(format_args!("{text:?} {rule}")));
            }
            Ok(expression)
        };
        Ok([read(0)?, read(1)?, read(2)?])
    }

    /// From the reference point to a point given in body axes, in principal axes.
    fn arm(&self, key: &Key, point: [f64; 3]) -> Result<Vector3<f64>, Refusal> {
        Ok(self.to_principal(vector(key, point)? - self.properties.about))
    }

    fn to_principal(&self, in_body: Vector3<f64>) -> Vector3<f64> {
        self.properties.body_from_principal.inverse_transform_vector(&in_body)
    }

    fn spring(&self, key: &Key, spec: &SpringSpec) -> Result<Spring, Refusal> {
        let damping_key = key.field("damping_n_s_per_m");
        let spring = Spring {
            anchor: vector(&key.field("anchor_m"), spec.anchor_m)?,
            arm: self.arm(&key.field("point_m"), spec.point_m)?,
            stiffness: positive(&key.field("stiffness_n_per_m"), spec.stiffness_n_per_m)?,
            damping: spec.damping_n_s_per_m.map_or(Ok(0.0), |damping| not_negative(&damping_key, damping))?,
            rest_length: not_negative(&key.field("rest_length_m"), spec.rest_length_m)?,
            is_tether: spec.pulls_only,
        };
        if spring.is_tether && spring.damping > 0.0 {
            return Err(damping_key.refuse("contradicts pulls_only: a damper's pull would begin with a jump"));
        }
        let point = self.initial.position + self.initial.attitude.to_world(&spring.arm);
        if point == spring.anchor && (spring.rest_length > 0.0 || spring.damping > 0.0) {
            return Err(key
                .field("anchor_m")
                .refuse("is where the body's point starts: the spring has no direction there"));
        }
        Ok(spring)
    }

    fn sphere(&self, key: &Key, spec: &InnerSphereSpec) -> Result<InnerSphere, Refusal> {
        let inertia_key = key.field("inertia_kg_m2");
        let inertia = positive(&inertia_key, spec.inertia_kg_m2)?;
        let least = self.properties.moments.vector().min();
        if inertia >= least {
            let rule = format_args!("{inertia:?} must be below the body's least moment, {least:?}: it is part of it");
            return Err(inertia_key.refuse(rule));
        }
        let relative = optional_vector(&key.field("relative_rate_rad_s"), spec.relative_rate_rad_s)?;
        Ok(InnerSphere {
            inertia,
            coefficient: not_negative(&key.field("coefficient_n_m_s"), spec.coefficient_n_m_s)?,
            initial: self.to_principal(relative),
        })
    }

    fn feedback(&self, key: &Key, spec: &QuaternionFeedbackSpec) -> Result<QuaternionFeedback, Refusal> {
        let body_from_principal = self.properties.body_from_principal;
        let target = rotation(&key.field("target"), Some(spec.target))?.world_from_body();
        let start: UnitQuaternion<f64> = self.initial.attitude.world_from_body() * body_from_principal.inverse();
        let dead_band_key = key.field("dead_band_n_m");
        Ok(QuaternionFeedback {
            target,
            stiffness: not_negative(&key.field("attitude_gain_n_m"), spec.attitude_gain_n_m)?,
            damping: not_negative(&key.field("rate_gain_n_m_s"), spec.rate_gain_n_m_s)?,
            limit: limit(&key.field("limit_n_m"), spec.limit_n_m)?,
            dead_band: spec.dead_band_n_m.map_or(Ok(0.0), |band| not_negative(&dead_band_key, band))?,
            way: if (target.inverse() * start).w < 0.0 { -1.0 } else { 1.0 },
            body_from_principal,
        })
    }
}

/// The beginning of a long text.
fn shortened(text: &str) -> String {
    const SHOWN: usize = 60;
    let rest = if text.chars().count() > SHOWN { "…" } else { "" };
    text.chars().take(SHOWN).chain(rest.chars()).collect()
}

/// A largest value; left out: infinity.
fn limit(key: &Key, value: Option<f64>) -> Result<f64, Refusal> {
    value.map_or(Ok(f64::INFINITY), |value| positive(key, value))
}
