use super::rules::{finite, optional_vector, positive, rotation};
use crate::body::{Shape, Solid};
use crate::scenario::{Key, Refusal, SolidSpecs};

/// What every kind of solid says beside its lengths.
struct Placing {
    key: Key,
    shape: Shape,
    mass_kg: Option<f64>,
    density_kg_m3: Option<f64>,
    position_m: Option<[f64; 3]>,
    rotation: Option<[f64; 4]>,
}

/// All solids of a body, checked, in the order of their kinds.
pub fn plan(key: &Key, specs: &SolidSpecs) -> Result<Vec<Solid>, Refusal> {
    placings(key, specs).into_iter().map(place).collect()
}

fn placings(key: &Key, specs: &SolidSpecs) -> Vec<Placing> {
    let mut placings = Vec::new();
    macro_rules! each {
        ($list:expr, $name:literal, |$spec:ident| $shape:expr) => {
            for (index, $spec) in $list.iter().enumerate() {
                placings.push(Placing {
                    key: key.field($name).index(index),
                    shape: $shape,
                    mass_kg: $spec.mass_kg,
                    density_kg_m3: $spec.density_kg_m3,
                    position_m: $spec.position_m,
                    rotation: $spec.rotation,
                });
            }
        };
    }
    each!(specs.cuboid, "box", |spec| Shape::Box { size: spec.size_m });
    each!(specs.cylinder, "cylinder", |spec| Shape::Cylinder { radius: spec.radius_m, length: spec.length_m });
    each!(specs.ellipsoid, "ellipsoid", |spec| Shape::Ellipsoid { semi_axes: spec.semi_axes_m });
    each!(specs.sphere, "sphere", |spec| Shape::Sphere { radius: spec.radius_m });
    each!(specs.cone, "cone", |spec| Shape::Cone { radius: spec.radius_m, height: spec.length_m });
    each!(specs.capsule, "capsule", |spec| Shape::Capsule { radius: spec.radius_m, length: spec.length_m });
    each!(specs.torus, "torus", |spec| Shape::Torus {
        major_radius: spec.major_radius_m,
        minor_radius: spec.minor_radius_m
    });
    placings
}

fn place(placing: Placing) -> Result<Solid, Refusal> {
    let Placing { key, shape, .. } = placing;
    let solid = match (placing.mass_kg, placing.density_kg_m3) {
        (Some(mass), None) => Solid::from_mass(shape, positive(&key.field("mass_kg"), mass)?),
        (None, Some(density)) => Solid::new(shape, finite(&key.field("density_kg_m3"), density)?),
        (Some(_), Some(_)) => return Err(key.field("mass_kg").refuse("given beside density_kg_m3: one of the two")),
        (None, None) => return Err(key.refuse("needs mass_kg or density_kg_m3")),
    };
    let position = optional_vector(&key.field("position_m"), placing.position_m)?;
    let rotation = rotation(&key.field("rotation"), placing.rotation)?;
    solid.map(|solid| solid.at(position).turned(rotation.world_from_body())).map_err(|error| key.refuse(error))
}
