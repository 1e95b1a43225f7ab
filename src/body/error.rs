use thiserror::Error;

/// A body that cannot exist, or a quantity that cannot be what its type says.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum BodyError {
    /// A moment of inertia is not a positive finite number.
    #[error("principal moments {0:?} kg m²: each must be positive and finite")]
    MomentNotPositive([f64; 3]),
    /// One moment exceeds the sum of the other two: no mass distribution has it.
    #[error("principal moments {0:?} kg m²: the largest may not exceed the sum of the other two (triangle inequality)")]
    TriangleInequality([f64; 3]),
    /// The quaternion is not of unit length.
    #[error("attitude quaternion {quaternion:?} has length {length}: it must be 1 within {tolerance:e}")]
    NotUnit {
        /// As given: w, x, y, z.
        quaternion: [f64; 4],
        /// Its length.
        length: f64,
        /// How far from 1 the length may be.
        tolerance: f64,
    },
    /// A component is NaN or infinite.
    #[error("{quantity} {value:?}: every component must be finite")]
    NotFinite {
        /// What was given.
        quantity: &'static str,
        /// Its components.
        value: Vec<f64>,
    },
    /// A scalar that must be positive is not.
    #[error("{quantity} = {value} {unit}: it must be positive and finite")]
    NotPositive {
        /// What was given: a mass, a density, an edge of a box.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// A density of zero, NaN or infinity.
    #[error("density = {0} kg/m³: it must be finite and not zero (negative for a hole)")]
    Density(f64),
    /// The tube of a torus is thicker than its ring is wide.
    #[error(
        "torus minor_radius = {minor_radius} m exceeds major_radius = {major_radius} m: it would pass through itself"
    )]
    SpindleTorus {
        /// Of the ring, m.
        major_radius: f64,
        /// Of the tube, m.
        minor_radius: f64,
    },
    /// A tensor whose halves differ.
    #[error("inertia tensor: elements [{row}][{column}] = {upper} and [{column}][{row}] = {lower} must be equal")]
    NotSymmetric {
        /// From 0.
        row: usize,
        /// From 0, beyond the row.
        column: usize,
        /// Above the diagonal, kg m².
        upper: f64,
        /// Below the diagonal, kg m².
        lower: f64,
    },
    /// Parallel axes need a mass, and only moments were given.
    #[error("moments about {point:?} m from those about {about:?} m: the mass must be known (parallel axes)")]
    MassUnknown {
        /// The point asked for, body axes, m.
        point: [f64; 3],
        /// The point that the moments are about, body axes, m.
        about: [f64; 3],
    },
    /// A body of no parts.
    #[error("mass properties of no {0}: there must be at least one")]
    Empty(&'static str),
    /// A particle without mass.
    #[error("particle {index} has mass {mass} kg: it must be positive and finite")]
    ParticleMass {
        /// From 0, in the order given.
        index: usize,
        /// kg.
        mass: f64,
    },
    /// Particles on one line or in one point have no moment of inertia about it.
    #[error(
        "{count} particles on one line (smallest moment {smallest:e} of {largest:e} kg m²): \
         they must not all lie on a line or in a point"
    )]
    Collinear {
        /// How many particles.
        count: usize,
        /// Moment about the line, kg m²: zero but for rounding.
        smallest: f64,
        /// Largest moment, kg m².
        largest: f64,
    },
    /// A spring holds a particle that is not there, or both its ends are in one place.
    #[error("spring {index} joins particles {ends:?} of {particles}: they must exist and lie apart")]
    Spring {
        /// From 0, in the order given.
        index: usize,
        /// The particles it joins, from 0.
        ends: [usize; 2],
        /// How many particles there are.
        particles: usize,
    },
    /// A triangle uses a vertex that is not there.
    #[error("triangle {triangle} of the mesh uses vertex {vertex}, but there are {vertices} (counted from 0)")]
    VertexMissing {
        /// From 0.
        triangle: usize,
        /// The index it uses.
        vertex: u32,
        /// How many there are.
        vertices: usize,
    },
    /// The mesh does not enclose a volume.
    #[error(
        "mesh edge from vertex {from} to {to} is used {forward} times and {backward} times backward: \
         a closed mesh uses each edge exactly once each way"
    )]
    NotClosed {
        /// Vertex index, from 0.
        from: u32,
        /// Vertex index, from 0.
        to: u32,
        /// Triangles that run along the edge.
        forward: usize,
        /// Triangles that run against it.
        backward: usize,
    },
    /// The triangles of the mesh face inwards.
    #[error("mesh encloses {volume} m³: its triangles must run counter-clockwise seen from outside (inside out?)")]
    InsideOut {
        /// Not positive, m³.
        volume: f64,
    },
    /// A mesh file that cannot be read as a mesh.
    #[error("mesh file {path}: {reason}")]
    MeshFile {
        /// As given.
        path: String,
        /// What is wrong with it.
        reason: String,
    },
}

/// `value`, if it is a positive finite number.
pub(super) fn positive(quantity: &'static str, value: f64, unit: &'static str) -> Result<f64, BodyError> {
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(BodyError::NotPositive { quantity, value, unit }) }
}

/// `vector`, if all its components are finite.
pub(super) fn finite(
    quantity: &'static str,
    vector: nalgebra::Vector3<f64>,
) -> Result<nalgebra::Vector3<f64>, BodyError> {
    if vector.iter().all(|component| component.is_finite()) {
        Ok(vector)
    } else {
        Err(BodyError::NotFinite { quantity, value: vector.as_slice().to_vec() })
    }
}
