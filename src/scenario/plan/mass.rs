use std::path::Path;

use nalgebra::{Matrix3, Vector3};

use super::rules::{optional_vector, positive, unused, vector};
use super::{mesh, solids};
use crate::body::{MassProperties, Particle, ParticleCloud, Surface, mass_properties_of};
use crate::scenario::{BodySpec, Key, ParticleSpec, PivotSpec, Refusal};

/// Mass properties about the centre of mass or the pivot, and what the body looks like from there.
pub fn plan(key: &Key, spec: &BodySpec, folder: &Path) -> Result<(MassProperties, Vec<Surface>), Refusal> {
    let sources = [
        ("principal_moments_kg_m2", spec.principal_moments_kg_m2.is_some()),
        ("inertia_kg_m2", spec.inertia_kg_m2.is_some()),
        ("particle", !spec.particle.is_empty()),
        ("solid", spec.solid != crate::scenario::SolidSpecs::default()),
        ("mesh", spec.mesh.is_some()),
    ];
    let given: Vec<&'static str> = sources.iter().filter(|(_, given)| *given).map(|(name, _)| *name).collect();
    let source = match given.as_slice() {
        [source] => key.field(source),
        [] => {
            let names = sources.map(|(name, _)| name).join(", ");
            return Err(key.refuse(format_args!("a body needs its inertia: one of {names}")));
        }
        [first, second, ..] => {
            let rule = format!("given beside {first}: a body's inertia has one source");
            return Err(key.field(second).refuse(rule));
        }
    };
    let is_typed = spec.principal_moments_kg_m2.is_some() || spec.inertia_kg_m2.is_some();
    if !is_typed {
        let rule = "mass and centre of mass follow from particles, solids or mesh";
        unused(&key.field("mass_kg"), spec.mass_kg.as_ref(), rule)?;
        unused(&key.field("centre_of_mass_m"), spec.centre_of_mass_m.as_ref(), rule)?;
        if spec.pivot.as_ref().is_some_and(|pivot| pivot.inertia_about_pivot) {
            let rule = "not used: the inertia of particles, solids or mesh is computed about the pivot";
            return Err(key.field("pivot").field("inertia_about_pivot").refuse(rule));
        }
    }
    let pivot = pivot_point(key, spec.pivot.as_ref())?;
    if is_typed {
        let properties = typed(key, &source, spec, pivot)?;
        let surface = stand_in(&properties);
        return Ok((properties, vec![surface]));
    }
    let refuse = |error| source.refuse(error);
    if !spec.particle.is_empty() {
        let cloud = ParticleCloud::new(particles(&source, &spec.particle)?).map_err(refuse)?;
        let properties = about_pivot(&source, &cloud.mass_properties().map_err(refuse)?, pivot)?;
        let surface = Surface::of_particles(&cloud, &properties.about);
        return Ok((properties, vec![surface]));
    }
    if let Some(spec) = &spec.mesh {
        let (mesh, properties) = mesh::plan(&source, spec, folder)?;
        let properties = about_pivot(&source, &properties, pivot)?;
        let surface = Surface::of_mesh(&mesh, &properties.about);
        return Ok((properties, vec![surface]));
    }
    let solids = solids::plan(&source, &spec.solid)?;
    let properties = about_pivot(&source, &mass_properties_of(&solids).map_err(refuse)?, pivot)?;
    let surfaces = Surface::of_solids(&solids, &properties.about);
    Ok((properties, surfaces))
}

fn pivot_point(key: &Key, pivot: Option<&PivotSpec>) -> Result<Option<Vector3<f64>>, Refusal> {
    pivot.map(|pivot| vector(&key.field("pivot").field("position_m"), pivot.position_m)).transpose()
}

fn about_pivot(key: &Key, body: &MassProperties, pivot: Option<Vector3<f64>>) -> Result<MassProperties, Refusal> {
    pivot.map_or(Ok(body.clone()), |pivot| body.about(pivot)).map_err(|error| key.refuse(error))
}

/// A body given by moments or by its tensor.
fn typed(key: &Key, source: &Key, spec: &BodySpec, pivot: Option<Vector3<f64>>) -> Result<MassProperties, Refusal> {
    let mass = spec.mass_kg.map(|mass| positive(&key.field("mass_kg"), mass)).transpose()?;
    let centre = optional_vector(&key.field("centre_of_mass_m"), spec.centre_of_mass_m)?;
    let refuse = |error| source.refuse(error);
    let body = match (spec.principal_moments_kg_m2, spec.inertia_kg_m2) {
        (Some(moments), _) => MassProperties::from_principal(mass, moments).map_err(refuse)?,
        (None, tensor) => {
            let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = tensor.unwrap_or_default();
            MassProperties::from_tensor(mass, Matrix3::new(xx, xy, xz, yx, yy, yz, zx, zy, zz)).map_err(refuse)?
        }
    };
    match (pivot, spec.pivot.as_ref().is_some_and(|pivot| pivot.inertia_about_pivot)) {
        (Some(pivot), true) => body.shifted(pivot).and_then(|body| body.with_centre_of_mass(centre)).map_err(refuse),
        (Some(pivot), false) => body.shifted(centre).and_then(|body| body.about(pivot)).map_err(refuse),
        (None, _) => body.shifted(centre).map_err(refuse),
    }
}

/// The point masses of a body.
pub fn particles(key: &Key, specs: &[ParticleSpec]) -> Result<Vec<Particle>, Refusal> {
    let each = specs.iter().enumerate().map(|(index, spec)| {
        let key = key.index(index);
        Ok(Particle {
            mass: positive(&key.field("mass_kg"), spec.mass_kg)?,
            position: vector(&key.field("position_m"), spec.position_m)?,
        })
    });
    each.collect()
}

/// What is drawn of a body of which only moments are known: the uniform box that has them, at its centre of mass.
fn stand_in(properties: &MassProperties) -> Surface {
    // Without a mass the moments cannot be moved from the pivot: then the box has those about it.
    let central = properties.about(properties.centre_of_mass).unwrap_or_else(|_| properties.clone());
    let mut surface = Surface::equivalent_box(central.moments, central.mass);
    let turn = central.body_from_principal.cast::<f32>();
    let centre = (properties.centre_of_mass - properties.about).cast::<f32>();
    for normal in &mut surface.normals {
        *normal = (turn * Vector3::from(*normal)).into();
    }
    for vertex in &mut surface.vertices {
        *vertex = (turn * Vector3::from(*vertex) + centre).into();
    }
    surface
}
