//! Loads of the kinds that go by a tape.

use std::sync::Arc;

use nalgebra::Vector3;

use super::loads::window;
use super::rules::vector;
use crate::body::MassProperties;
use crate::dynamics::formula::{Expression, Variable};
use crate::dynamics::{FormulaLoad, FormulaPlace, General, GeneralLoad, Load, Torque};
use crate::scenario::{BodySpec, Frame, Key, Refusal};

/// Those of the body at `key`, in principal axes.
pub fn plan(key: &Key, spec: &BodySpec, properties: &MassProperties) -> Result<Vec<Load>, Refusal> {
    let mut loads = Vec::new();
    let mut push = |kind: General, key: &Key, start: Option<f64>, end: Option<f64>| {
        let torque = Torque::General(Arc::new(GeneralLoad::new(kind)));
        loads.push(Load { torque, window: window(key, start, end)? });
        Ok(())
    };
    let is_held = spec.pivot.is_some();
    for (index, formula) in spec.torque.formula.iter().enumerate() {
        let key = key.field("torque").field("formula").index(index);
        let components = expressions(&key.field("moment_n_m"), &formula.moment_n_m, is_held)?;
        let load = by_formula(components, formula.frame, FormulaPlace::Moment, properties);
        push(General::Formula(load), &key, formula.start_s, formula.end_s)?;
    }
    for (index, formula) in spec.force.formula.iter().enumerate() {
        let key = key.field("force").field("formula").index(index);
        let components = expressions(&key.field("force_n"), &formula.force_n, is_held)?;
        let place = FormulaPlace::Force { arm: arm(&key.field("point_m"), formula.point_m, properties)? };
        push(General::Formula(by_formula(components, formula.frame, place, properties)), &key, formula.start_s, formula.end_s)?;
    }
    Ok(loads)
}

fn by_formula(
    components: [Expression; 3],
    frame: Frame,
    place: FormulaPlace,
    properties: &MassProperties,
) -> FormulaLoad {
    let body_from_principal = properties.body_from_principal;
    FormulaLoad { components, in_world: frame == Frame::World, place, body_from_principal }
}

/// Three formulae.
fn expressions(key: &Key, texts: &[String; 3], is_held: bool) -> Result<[Expression; 3], Refusal> {
    let read = |index: usize| {
        let (key, text) = (key.index(index), &texts[index]);
        let expression = Expression::read(text).map_err(|error| key.refuse(format_args!("{text:?} {error}")))?;
        let is_translation = |variable: Variable| matches!(variable, Variable::Position(_) | Variable::Velocity(_));
        if is_held && expression.names(&is_translation) {
            let rule = "contradicts the pivot: the position and the velocity of a body that is held do not change";
            return Err(key.refuse(format_args!("{text:?} {rule}")));
        }
        Ok(expression)
    };
    Ok([read(0)?, read(1)?, read(2)?])
}

/// From the reference point to a point given in body axes, in principal axes.
fn arm(key: &Key, point: [f64; 3], properties: &MassProperties) -> Result<Vector3<f64>, Refusal> {
    Ok(properties.body_from_principal.inverse_transform_vector(&(vector(key, point)? - properties.about)))
}
