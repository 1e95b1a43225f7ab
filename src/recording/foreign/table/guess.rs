use crate::recording::foreign::BodyMapping;

/// Names of the column of time, s.
const TIMES: [&str; 3] = ["time_s", "time", "t"];
/// Names that say which number of a quaternion is which. `q0` to `q3` do not: some begin with w, some end with it.
const QUATERNIONS: [[&str; 4]; 5] = [
    ["qw", "qx", "qy", "qz"],
    ["q_w", "q_x", "q_y", "q_z"],
    ["quat_w", "quat_x", "quat_y", "quat_z"],
    ["attitude_w", "attitude_x", "attitude_y", "attitude_z"],
    ["orientation.w", "orientation.x", "orientation.y", "orientation.z"],
];
const UNCLEAR: [[&str; 4]; 4] =
    [["q0", "q1", "q2", "q3"], ["q1", "q2", "q3", "q4"], ["q_0", "q_1", "q_2", "q_3"], ["e0", "e1", "e2", "e3"]];
const RATES: [[&str; 3]; 6] = [
    ["wx", "wy", "wz"],
    ["w_x", "w_y", "w_z"],
    ["omega_x", "omega_y", "omega_z"],
    ["angular_velocity_x", "angular_velocity_y", "angular_velocity_z"],
    ["angular_velocity_x_rad_s", "angular_velocity_y_rad_s", "angular_velocity_z_rad_s"],
    ["angular_velocity.x", "angular_velocity.y", "angular_velocity.z"],
];
const POSITIONS: [[&str; 3]; 4] = [
    ["px", "py", "pz"],
    ["pos_x", "pos_y", "pos_z"],
    ["position_x", "position_y", "position_z"],
    ["position_x_m", "position_y_m", "position_z_m"],
];

/// The column of time.
///
/// # Errors
/// If none is called so.
pub(super) fn time(names: &[String]) -> Result<String, String> {
    let found = TIMES.into_iter().find(|name| names.iter().any(|known| known == name));
    found.map(str::to_owned).ok_or_else(|| format!("no column is called {}: time = … names it", TIMES.join(" or ")))
}

/// The body whose columns have names that leave no doubt.
///
/// # Errors
/// If there is no attitude and no angular velocity among them, or a quaternion of unclear order.
pub(super) fn body(names: &[String]) -> Result<BodyMapping, String> {
    let quaternion = first_of(names, &QUATERNIONS);
    if quaternion.is_none()
        && let Some(unclear) = first_of(names, &UNCLEAR)
    {
        return Err(format!(
            "{}: which of them is w? Some programs begin with it, some end with it: quaternion = … names w, x, y, z in \
             this order",
            unclear.join(", "),
        ));
    }
    let angular_velocity = first_of(names, &RATES);
    if quaternion.is_none() && angular_velocity.is_none() {
        return Err("no columns are called qw, qx, qy, qz or wx, wy, wz or the like: a mapping has to name them".into());
    }
    Ok(BodyMapping { quaternion, angular_velocity, position: first_of(names, &POSITIONS), ..BodyMapping::default() })
}

fn first_of<const N: usize>(names: &[String], candidates: &[[&str; N]]) -> Option<[String; N]> {
    let is_there = |candidate: &&[&str; N]| candidate.iter().all(|name| names.iter().any(|known| known == name));
    candidates.iter().find(is_there).map(|candidate| candidate.map(str::to_owned))
}
