//! The scenes that come with the program.

macro_rules! scenes {
    ($($name:literal),+ $(,)?) => {
        const SCENES: &[(&str, &str)] =
            &[$(($name, include_str!(concat!("../../scenarios/", $name, ".toml")))),+];
    };
}

scenes![
    "apophis",
    "axial_chirp",
    "book",
    "boxes_benchmark",
    "compass_needle",
    "constant_body_torque",
    "constant_world_torque",
    "detumbling",
    "driven_wobble",
    "dzhanibekov",
    "dzhanibekov_three_axes",
    "earth_euler",
    "explorer_1",
    "feynman_plate",
    "free_precession_oblate",
    "free_precession_prolate",
    "gravity_gradient",
    "gravity_probe_b",
    "gyrostat_stability",
    "kovalevskaya_top",
    "lagrange_top",
    "libration",
    "lro",
    "measured_thruster",
    "momentum_brake",
    "particle_cloud",
    "reaction_wheel",
    "separatrix",
    "shuttlecock",
    "sleeping_top",
    "slew_with_saturation",
    "spin_up",
    "tennis_racket",
    "tether",
    "thrown_hammer",
    "thruster_pulses",
    "thruster_schedule",
    "tiangong_1",
    "toutatis",
    "transverse_spin_up",
];

/// Their names, in alphabetical order.
pub fn names() -> impl Iterator<Item = &'static str> {
    SCENES.iter().map(|(name, _)| *name)
}

/// The TOML text of the scene called `name`.
#[must_use]
pub fn text(name: &str) -> Option<&'static str> {
    SCENES.iter().find(|(candidate, _)| *candidate == name).map(|(_, text)| *text)
}

/// What to say to somebody who asked for a scene that there is not.
#[must_use]
pub(super) fn hint(name: &str) -> String {
    super::nearest(name, names())
        .map_or_else(|| ": `polhode list` names them all".to_owned(), |near| format!("; did you mean {near:?}?"))
}
