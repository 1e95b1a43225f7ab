/// How the name of a key ends, and the unit that this means; the longest ending counts.
const UNITS: [(&str, &str); 28] = [
    ("_a_m2", "A m²"),
    ("_a_m2_s_per_t", "A m² s/T"),
    ("_hz", "Hz"),
    ("_j", "J"),
    ("_kg", "kg"),
    ("_kg_m2", "kg m²"),
    ("_kg_m3", "kg/m³"),
    ("_kg_per_m", "kg/m"),
    ("_kg_per_s", "kg/s"),
    ("_m", "m"),
    ("_m2", "m²"),
    ("_m_s", "m/s"),
    ("_m_s2", "m/s²"),
    ("_n", "N"),
    ("_n_m", "N m"),
    ("_n_m_per_rad", "N m/rad"),
    ("_n_m_s", "N m s"),
    ("_n_m_s2", "N m s²"),
    ("_n_m_s_per_rad", "N m s/rad"),
    ("_n_per_m", "N/m"),
    ("_n_s_per_m", "N s/m"),
    ("_pa_s", "Pa s"),
    ("_per_s", "1/s"),
    ("_rad", "rad"),
    ("_rad_s", "rad/s"),
    ("_s", "s"),
    ("_t", "T"),
    ("_w", "W"),
];

/// The unit of the key called `name`, by its ending; `None` of a number without unit, or whose unit depends.
pub fn unit(name: &str) -> Option<&'static str> {
    let endings = UNITS.iter().filter(|(ending, _)| name.ends_with(ending));
    endings.max_by_key(|(ending, _)| ending.len()).map(|(_, unit)| *unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_end_in_their_units() {
        let names = ["duration_s", "mean_motion_rad_s", "angular_momentum_n_m_s", "gravity_m_s2", "density_kg_m3"];
        let units = names.map(|name| unit(name).unwrap_or_default());
        assert_eq!(units, ["s", "rad/s", "N m s", "m/s²", "kg/m³"]);
        assert_eq!([unit("attitude"), unit("tolerance"), unit("metres_per_unit")], [None; 3]);
    }
}
