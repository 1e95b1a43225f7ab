#[cfg(feature = "schema")]
use schemars::JsonSchema;
#[cfg(feature = "serde")]
use serde::Deserialize;

/// One point mass.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct ParticleSpec {
    /// Under which it is recorded where springs join the particles: at most 64 letters, digits, `_` and `-`; with springs
    /// alone; left out: `p1`, `p2` and so on.
    #[cfg_attr(feature = "serde", serde(default))]
    #[cfg_attr(feature = "schema", schemars(pattern(r"^[A-Za-z0-9_-]{1,64}$")))]
    pub name: Option<String>,
    /// Mass, kg.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub mass_kg: f64,
    /// Position in body axes, from the body's origin, m.
    pub position_m: [f64; 3],
}

/// A spring and a damper between every two particles of the body, which then is not rigid: each particle moves by its own
/// equation of motion.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct SpringsSpec {
    /// k of every spring, N/m, its length without force that between the particles' positions: at least what holds the body
    /// together at its first spin.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub stiffness_n_per_m: f64,
    /// c of every damper, N s/m, along the line between its particles; left out: `0`.
    #[cfg_attr(feature = "serde", serde(default))]
    #[cfg_attr(feature = "schema", schemars(range(min = 0)))]
    pub damping_n_s_per_m: Option<f64>,
    /// Whether the springs start stretched as the spin stretches them, so that next to nothing vibrates; left out: `false`.
    #[cfg_attr(feature = "serde", serde(default))]
    pub relaxed: bool,
}
