use std::path::Path;

use nalgebra::Vector3;

use super::{general, profiles, springs};
use crate::body::{MassProperties, State};
use crate::dynamics::{Load, Torque, Window};
use crate::scenario::plan::rules::{not_negative, optional_vector, positive, unused, vector};
use crate::scenario::{BodySpec, ForceSpec, ForceSpecs, Frame, Key, Refusal};

/// Everything that acts on one body, and the uniform acceleration of its centre of mass.
pub struct Acting {
    /// In principal axes.
    pub on_rotation: Vec<Load>,
    /// World axes, m/s²; zero for a body that is held at a pivot.
    pub gravity: Vector3<f64>,
    /// Whether a force acts on the centre of mass.
    pub moves: bool,
}

/// The loads of the body at `key`, its `rotors` among them, turned into principal axes, until `end`, s.
pub fn plan(
    key: &Key,
    spec: &BodySpec,
    properties: &MassProperties,
    initial: &State,
    rotors: Vec<Load>,
    folder: &Path,
    end: f64,
) -> Result<Acting, Refusal> {
    let mut loads = torques(key, spec, properties, folder)?;
    loads.extend(rotors);
    loads.extend(forces(key, spec, properties, folder, end)?);
    loads.extend(general::plan(key, spec, properties, initial)?);
    loads.extend(springs::plan(key, spec, properties, initial)?);
    let forces = key.field("force");
    let to_principal = |in_body: Vector3<f64>| properties.body_from_principal.inverse_transform_vector(&in_body);
    let gravity_key = key.field("gravity_m_s2");
    let gravity = optional_vector(&gravity_key, spec.gravity_m_s2)?;
    let has_forces = spec.force != ForceSpecs::default();
    let is_pulled = gravity != Vector3::zeros();
    if properties.mass.is_none() && (is_pulled || (has_forces && spec.pivot.is_none())) {
        let asked = if is_pulled { gravity_key } else { forces };
        return Err(asked.refuse("needs the body's mass_kg"));
    }
    if spec.pivot.is_some() {
        let arm = to_principal(properties.centre_of_mass - properties.about);
        let weight = properties.mass.unwrap_or_default() * gravity;
        if is_pulled && arm != Vector3::zeros() {
            loads.push(Load { torque: Torque::ForceWorld { force: weight, arm }, window: Window::ALWAYS });
        }
        return Ok(Acting { on_rotation: loads, gravity: Vector3::zeros(), moves: false });
    }
    Ok(Acting { on_rotation: loads, gravity, moves: has_forces || is_pulled })
}

/// The rotors of the body at `key`, in principal axes: its first rates may be told by the momentum of all.
pub fn rotors(key: &Key, spec: &BodySpec, properties: &MassProperties) -> Result<Vec<Load>, Refusal> {
    let to_principal = |in_body: Vector3<f64>| properties.body_from_principal.inverse_transform_vector(&in_body);
    let rotor = |(index, spec)| {
        let momentum = profiles::rotor(&key.field("rotor").index(index), spec, to_principal)?;
        Ok(Load { torque: Torque::Rotor { momentum }, window: Window::ALWAYS })
    };
    spec.rotor.iter().enumerate().map(rotor).collect()
}

/// Torques.
fn torques(key: &Key, spec: &BodySpec, properties: &MassProperties, folder: &Path) -> Result<Vec<Load>, Refusal> {
    let to_principal = |in_body: Vector3<f64>| properties.body_from_principal.inverse_transform_vector(&in_body);
    let mut loads = Vec::new();
    let torques = key.field("torque");
    for (index, spec) in spec.torque.constant_body.iter().enumerate() {
        let key = torques.field("constant_body").index(index);
        let moment = to_principal(vector(&key.field("moment_n_m"), spec.moment_n_m)?);
        loads.push(Load { torque: Torque::ConstantBody { moment }, window: window(&key, spec.start_s, spec.end_s)? });
    }
    for (index, spec) in spec.torque.constant_world.iter().enumerate() {
        let key = torques.field("constant_world").index(index);
        let moment = vector(&key.field("moment_n_m"), spec.moment_n_m)?;
        loads.push(Load { torque: Torque::ConstantWorld { moment }, window: window(&key, spec.start_s, spec.end_s)? });
    }
    for (index, spec) in spec.torque.linear_damping.iter().enumerate() {
        let key = torques.field("linear_damping").index(index);
        let coefficient = not_negative(&key.field("coefficient_n_m_s"), spec.coefficient_n_m_s)?;
        let window = window(&key, spec.start_s, spec.end_s)?;
        loads.push(Load { torque: Torque::LinearDamping { coefficient }, window });
    }
    for (index, spec) in spec.torque.momentum_brake.iter().enumerate() {
        let key = torques.field("momentum_brake").index(index);
        let rate = not_negative(&key.field("rate_per_s"), spec.rate_per_s)?;
        loads.push(Load { torque: Torque::MomentumBrake { rate }, window: window(&key, spec.start_s, spec.end_s)? });
    }
    for (index, spec) in spec.torque.magnetic_dipole.iter().enumerate() {
        let key = torques.field("magnetic_dipole").index(index);
        let dipole = to_principal(vector(&key.field("dipole_a_m2"), spec.dipole_a_m2)?);
        let field = vector(&key.field("field_t"), spec.field_t)?;
        let window = window(&key, spec.start_s, spec.end_s)?;
        loads.push(Load { torque: Torque::MagneticDipole { dipole, field }, window });
    }
    for (index, gradient) in spec.torque.gravity_gradient.iter().enumerate() {
        let key = torques.field("gravity_gradient").index(index);
        if spec.pivot.is_some() {
            return Err(key.refuse("contradicts the pivot: a body in orbit is held at no point"));
        }
        let mean_motion = positive(&key.field("mean_motion_rad_s"), gradient.mean_motion_rad_s)?;
        let window = window(&key, gradient.start_s, gradient.end_s)?;
        loads.push(Load { torque: Torque::GravityGradient { mean_motion }, window });
    }
    for (index, spec) in spec.torque.table.iter().enumerate() {
        let key = torques.field("table").index(index);
        unused(&key.field("point_m"), spec.point_m.as_ref(), "a torque acts at no point")?;
        let window = window(&key, spec.start_s, spec.end_s)?;
        let torque = match spec.frame {
            Frame::Body => Torque::ProfileBody { moment: profiles::table(&key, spec, folder, to_principal)? },
            Frame::World => Torque::ProfileWorld { moment: profiles::table(&key, spec, folder, |moment| moment)? },
        };
        loads.push(Load { torque, window });
    }
    Ok(loads)
}

/// Forces at points of the body, but for gravity; until `end`, s.
fn forces(
    key: &Key,
    spec: &BodySpec,
    properties: &MassProperties,
    folder: &Path,
    end: f64,
) -> Result<Vec<Load>, Refusal> {
    let to_principal = |in_body: Vector3<f64>| properties.body_from_principal.inverse_transform_vector(&in_body);
    let mut loads = Vec::new();
    let forces = key.field("force");
    for (index, spec) in spec.force.thruster.iter().enumerate() {
        let key = forces.field("thruster").index(index);
        let window = window(&key, spec.start_s, spec.end_s)?;
        let arm = arm(&key, spec.point_m, properties)?;
        let force = profiles::thruster(&key, spec, end, to_principal)?;
        loads.push(Load { torque: Torque::ForceProfileBody { force, arm }, window });
    }
    for (index, spec) in spec.force.table.iter().enumerate() {
        let key = forces.field("table").index(index);
        let window = window(&key, spec.start_s, spec.end_s)?;
        let point = spec.point_m.ok_or_else(|| key.refuse("needs point_m: where the force acts"))?;
        let arm = arm(&key, point, properties)?;
        let torque = match spec.frame {
            Frame::Body => Torque::ForceProfileBody { force: profiles::table(&key, spec, folder, to_principal)?, arm },
            Frame::World => {
                Torque::ForceProfileWorld { force: profiles::table(&key, spec, folder, |force| force)?, arm }
            }
        };
        loads.push(Load { torque, window });
    }
    for (index, spec) in spec.force.constant_body.iter().enumerate() {
        let key = forces.field("constant_body").index(index);
        let (force, arm, window) = force(&key, spec, properties)?;
        loads.push(Load { torque: Torque::ForceBody { force: to_principal(force), arm }, window });
    }
    for (index, spec) in spec.force.constant_world.iter().enumerate() {
        let key = forces.field("constant_world").index(index);
        let (force, arm, window) = force(&key, spec, properties)?;
        loads.push(Load { torque: Torque::ForceWorld { force, arm }, window });
    }
    Ok(loads)
}

/// Force as given, arm from the reference point in principal axes, window.
fn force(
    key: &Key,
    spec: &ForceSpec,
    properties: &MassProperties,
) -> Result<(Vector3<f64>, Vector3<f64>, Window), Refusal> {
    let arm = arm(key, spec.point_m, properties)?;
    Ok((vector(&key.field("force_n"), spec.force_n)?, arm, window(key, spec.start_s, spec.end_s)?))
}

/// From the reference point to a point of the body, in principal axes.
fn arm(key: &Key, point: [f64; 3], properties: &MassProperties) -> Result<Vector3<f64>, Refusal> {
    let point = vector(&key.field("point_m"), point)?;
    Ok(properties.body_from_principal.inverse_transform_vector(&(point - properties.about)))
}

pub fn window(key: &Key, start: Option<f64>, end: Option<f64>) -> Result<Window, Refusal> {
    let start = start.map_or(Ok(Window::ALWAYS.start), |start| not_negative(&key.field("start_s"), start))?;
    let end = end.map_or(Ok(Window::ALWAYS.end), |end| positive(&key.field("end_s"), end))?;
    if end <= start {
        return Err(key.field("end_s").refuse(format_args!("{end:?} must come after start_s = {start:?}")));
    }
    Ok(Window { start, end })
}
