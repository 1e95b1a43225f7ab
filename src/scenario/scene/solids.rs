#[cfg(feature = "schema")]
use schemars::JsonSchema;
#[cfg(feature = "serde")]
use serde::Deserialize;

#[cfg(feature = "schema")]
use crate::scenario::schema::structure;

/// Solids by shape.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct SolidSpecs {
    /// Cuboid about its centre.
    #[cfg_attr(feature = "serde", serde(rename = "box"))]
    pub cuboid: Vec<BoxSpec>,
    /// Cylinder about its centre, along z.
    pub cylinder: Vec<RoundSpec>,
    /// Ellipsoid about its centre.
    pub ellipsoid: Vec<EllipsoidSpec>,
    /// Sphere about its centre.
    pub sphere: Vec<SphereSpec>,
    /// Cone from the centre of its base, apex up z.
    pub cone: Vec<RoundSpec>,
    /// Capsule about its centre, along z: the length is that between the half spheres.
    pub capsule: Vec<RoundSpec>,
    /// Torus about its centre and z.
    pub torus: Vec<TorusSpec>,
}

macro_rules! solid_spec {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $kind:ty),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, PartialEq)]
        #[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
        #[cfg_attr(feature = "schema", derive(JsonSchema), schemars(transform = structure::solid))]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $kind,)+
            /// Mass, kg, in place of a density; left out: that of the density.
            #[cfg_attr(feature = "serde", serde(default))]
            #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
            pub mass_kg: Option<f64>,
            /// Density, kg/m³, not 0; negative for a hole; left out: that of the mass.
            #[cfg_attr(feature = "serde", serde(default))]
            pub density_kg_m3: Option<f64>,
            /// Position of the shape's origin, in body axes, m; left out: the body's origin.
            #[cfg_attr(feature = "serde", serde(default))]
            pub position_m: Option<[f64; 3]>,
            /// Body from shape, quaternion w, x, y, z, of length 1 within 1e-12; left out: `[1, 0, 0, 0]`.
            #[cfg_attr(feature = "serde", serde(default))]
            pub rotation: Option<[f64; 4]>,
        }
    };
}

solid_spec! {
    /// A cuboid.
    BoxSpec {
        /// Full edge lengths along x, y, z, m.
        #[cfg_attr(feature = "schema", schemars(transform = structure::each_positive))]
        size_m: [f64; 3],
    }
}
solid_spec! {
    /// A cylinder, cone or capsule along z.
    RoundSpec {
        /// Radius, m.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        radius_m: f64,
        /// Length, m.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        length_m: f64,
    }
}
solid_spec! {
    /// An ellipsoid.
    EllipsoidSpec {
        /// Semi-axes along x, y, z, m.
        #[cfg_attr(feature = "schema", schemars(transform = structure::each_positive))]
        semi_axes_m: [f64; 3],
    }
}
solid_spec! {
    /// A sphere.
    SphereSpec {
        /// Radius, m.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        radius_m: f64,
    }
}
solid_spec! {
    /// A torus about z.
    TorusSpec {
        /// From the centre to the middle of the tube, m.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        major_radius_m: f64,
        /// Radius of the tube, m, at most the other.
        #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
        minor_radius_m: f64,
    }
}
