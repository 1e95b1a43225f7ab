use std::path::PathBuf;

#[cfg(feature = "serde")]
use serde::Deserialize;

use super::{BodySpec, Checks};

/// What was asked. [`Plan::new`](crate::scenario::Plan::new) checks it.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Deserialize), serde(deny_unknown_fields, default))]
pub struct Scenario {
    /// One line: what this is.
    pub title: String,
    /// What to see in it.
    pub summary: String,
    /// How long, s. May be left out where sample times are listed.
    pub duration_s: Option<f64>,
    /// Time between samples, s.
    pub sample_every_s: Option<f64>,
    /// Sample times, s, in place of a fixed interval: ascending, from 0 on.
    pub sample_times_s: Option<Vec<f64>>,
    /// Names of channels; left out: those that the scene makes interesting.
    pub channels: Option<Vec<String>>,
    /// How to propagate.
    pub method: Method,
    /// Attitude error to keep over the whole run, rad; not for closed forms asked for by name, nor for fixed steps.
    pub tolerance_rad: Option<f64>,
    /// Step, s, for the methods that do not.
    pub step_s: Option<f64>,
    /// The bodies, each with its own motion.
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
pub struct Provenance {
    /// Author, title, place, year.
    pub source: String,
    /// Where to read it.
    pub url: String,
    /// What was taken from it, and how the numbers were checked.
    pub note: String,
}
