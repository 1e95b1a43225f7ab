use std::path::PathBuf;

#[cfg(feature = "schema")]
use schemars::JsonSchema;
#[cfg(feature = "serde")]
use serde::Deserialize;

use super::{BodySpec, Checks};
#[cfg(feature = "schema")]
use crate::scenario::schema::structure;

/// What was asked. [`Plan::new`](crate::scenario::Plan::new) checks it.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
#[cfg_attr(feature = "schema", derive(JsonSchema), schemars(title = "A scene of polhode", transform = structure::scene))]
pub struct Scenario {
    /// One line: what this is; left out: the scene's name.
    pub title: String,
    /// What to see in it, and why; left out: empty.
    pub summary: String,
    /// How long, s; needed with `sample_every_s`; left out: to the last of `sample_times_s`.
    #[cfg_attr(feature = "schema", schemars(range(max = 9e9), extend("exclusiveMinimum" = 0)))]
    pub duration_s: Option<f64>,
    /// Time between samples, s: sample n is at n times this; at most the duration and 1e9 samples; left out: the scene has
    /// `sample_times_s`.
    #[cfg_attr(feature = "schema", schemars(range(min = 1e-9)))]
    pub sample_every_s: Option<f64>,
    /// Sample times one by one, s: from 0 on, ascending by 1e-9 or more; left out: the scene has `sample_every_s`.
    #[cfg_attr(feature = "schema", schemars(length(min = 1), inner(range(min = 0, max = 9e9))))]
    pub sample_times_s: Option<Vec<f64>>,
    /// What is recorded: names of [channels](#channels), none twice; left out: what the scene makes interesting.
    #[cfg_attr(feature = "schema", schemars(schema_with = "structure::channels"))]
    pub channels: Option<Vec<String>>,
    /// How to propagate; left out: `auto`.
    pub method: Method,
    /// Attitude error to keep over the whole run, rad, by the cheapest path that does: refused where f64 cannot promise it,
    /// and for closed forms asked for by name and fixed steps; left out: as tight as f64 carries.
    #[cfg_attr(feature = "schema", schemars(range(min = 2e-15, max = 0.1)))]
    pub tolerance_rad: Option<f64>,
    /// The longest step, s, of a method with a fixed step, which needs it; for those alone; left out: the method needs none.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub step_s: Option<f64>,
    /// The bodies, each with its own motion: they do not act on each other.
    #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
    pub body: Vec<BodySpec>,
    /// What the motion must show.
    pub check: Checks,
    /// Where the numbers come from.
    pub provenance: Provenance,
    /// The file or scene that messages name; not a key.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub file: String,
    /// Where relative file names start; not a key.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub folder: PathBuf,
    /// The name recordings get; not a key.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub name: String,
    /// The text this was read from, if any; not a key.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub text: String,
}

/// How to propagate.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub enum Method {
    /// The best there is for each body.
    #[default]
    Auto,
    /// The closed form of the motion, where one is known.
    ClosedForm,
    /// Taylor series of the equations of motion, with dense output.
    Taylor,
    /// Dormand and Prince's Runge–Kutta method of order 8.
    Dop853,
    /// Explicit Euler on the rotation matrix; the first of the methods with a fixed step.
    EulerNaive,
    /// Semi-implicit Euler, as physics engines step.
    EulerSemiImplicit,
    /// The classical Runge–Kutta method.
    Rk4,
    /// Runge–Kutta on the group of rotations.
    Rkmk4,
    /// Splitting into planar rotations, order 2.
    Splitting2,
    /// The same, order 4.
    Splitting4,
    /// The same, order 6.
    Splitting6,
    /// The same, order 8.
    Splitting8,
    /// Discrete Moser–Veselov equations, order 2; torque-free.
    Dmv2,
    /// The same, order 4; torque-free.
    Dmv4,
    /// The same, order 6; torque-free.
    Dmv6,
    /// The same, order 8; torque-free.
    Dmv8,
    /// Gauss collocation, order 4.
    Gauss4,
    /// The same, order 6.
    Gauss6,
    /// Exact free motion between kicks, order 2.
    Kicks2,
    /// The same, order 4.
    Kicks4,
}

/// What a method is told about the accuracy wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Setting {
    /// Nothing: it is exact, or chooses for itself.
    None,
    /// `tolerance_rad`.
    Tolerance,
    /// `step_s`.
    Step,
}

impl Method {
    /// All of them.
    pub const ALL: [Self; 20] = [
        Self::Auto,
        Self::ClosedForm,
        Self::Taylor,
        Self::Dop853,
        Self::EulerNaive,
        Self::EulerSemiImplicit,
        Self::Rk4,
        Self::Rkmk4,
        Self::Splitting2,
        Self::Splitting4,
        Self::Splitting6,
        Self::Splitting8,
        Self::Dmv2,
        Self::Dmv4,
        Self::Dmv6,
        Self::Dmv8,
        Self::Gauss4,
        Self::Gauss6,
        Self::Kicks2,
        Self::Kicks4,
    ];

    /// As scenes spell it.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::ClosedForm => "closed_form",
            Self::Taylor => "taylor",
            Self::Dop853 => "dop853",
            Self::EulerNaive => "euler_naive",
            Self::EulerSemiImplicit => "euler_semi_implicit",
            Self::Rk4 => "rk4",
            Self::Rkmk4 => "rkmk4",
            Self::Splitting2 => "splitting2",
            Self::Splitting4 => "splitting4",
            Self::Splitting6 => "splitting6",
            Self::Splitting8 => "splitting8",
            Self::Dmv2 => "dmv2",
            Self::Dmv4 => "dmv4",
            Self::Dmv6 => "dmv6",
            Self::Dmv8 => "dmv8",
            Self::Gauss4 => "gauss4",
            Self::Gauss6 => "gauss6",
            Self::Kicks2 => "kicks2",
            Self::Kicks4 => "kicks4",
        }
    }

    /// What it is told about the accuracy wanted.
    #[must_use]
    pub const fn setting(self) -> Setting {
        match self {
            Self::Auto | Self::ClosedForm => Setting::None,
            Self::Taylor | Self::Dop853 => Setting::Tolerance,
            _ => Setting::Step,
        }
    }
}

/// Where a scene's numbers come from.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
#[cfg_attr(feature = "schema", derive(JsonSchema))]
pub struct Provenance {
    /// Author, title, place, year; left out: empty.
    pub source: String,
    /// Where to read it; left out: empty.
    pub url: String,
    /// What was taken from it, and how the numbers were checked; left out: empty.
    pub note: String,
}
