#[cfg(feature = "serde")]
use serde::Deserialize;

/// Solids by shape.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
pub struct SolidSpecs {
    /// Cuboids: `size_m`, full edge lengths.
    #[cfg_attr(feature = "serde", serde(rename = "box"))]
    pub cuboid: Vec<BoxSpec>,
    /// Along z: `radius_m`, `length_m`.
    pub cylinder: Vec<RoundSpec>,
    /// `semi_axes_m`.
    pub ellipsoid: Vec<EllipsoidSpec>,
    /// `radius_m`.
    pub sphere: Vec<SphereSpec>,
    /// Base at its origin, apex up z: `radius_m`, `length_m`.
    pub cone: Vec<RoundSpec>,
    /// Along z: `radius_m`, `length_m` of the part between the half spheres.
    pub capsule: Vec<RoundSpec>,
    /// About z: `major_radius_m`, `minor_radius_m`.
    pub torus: Vec<TorusSpec>,
}

macro_rules! solid_spec {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $kind:ty),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, PartialEq)]
        #[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $kind,)+
            /// kg, in place of a density.
            #[cfg_attr(feature = "serde", serde(default))]
            pub mass_kg: Option<f64>,
            /// kg/m³; negative for a hole.
            #[cfg_attr(feature = "serde", serde(default))]
            pub density_kg_m3: Option<f64>,
            /// Of the shape's origin, in body axes, m; left out: the body's origin.
            #[cfg_attr(feature = "serde", serde(default))]
            pub position_m: Option<[f64; 3]>,
            /// Body from shape, quaternion w, x, y, z; left out: shape axes along body axes.
            #[cfg_attr(feature = "serde", serde(default))]
            pub rotation: Option<[f64; 4]>,
        }
    };
}

solid_spec! {
    /// A cuboid.
    BoxSpec {
        /// Full edge lengths along x, y, z, m.
        size_m: [f64; 3],
    }
}
solid_spec! {
    /// A cylinder, cone or capsule along z.
    RoundSpec {
        /// m.
        radius_m: f64,
        /// m.
        length_m: f64,
    }
}
solid_spec! {
    /// An ellipsoid.
    EllipsoidSpec {
        /// Along x, y, z, m.
        semi_axes_m: [f64; 3],
    }
}
solid_spec! {
    /// A sphere.
    SphereSpec {
        /// m.
        radius_m: f64,
    }
}
solid_spec! {
    /// A torus about z.
    TorusSpec {
        /// From the centre to the middle of the tube, m.
        major_radius_m: f64,
        /// Of the tube, m.
        minor_radius_m: f64,
    }
}
