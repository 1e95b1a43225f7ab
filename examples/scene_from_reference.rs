//! Turns a reference case (`tests/reference/*.json`) into a scene that samples at the case's times.
//!
//! ```text
//! cargo run --example scene_from_reference tests/reference/torque_pulses.json > torque_pulses.toml
//! cargo run -- run torque_pulses.toml --format csv --out .
//! python3 tests/reference/check.py torque_pulses.csv tests/reference/torque_pulses.json --factor 100
//! ```

use std::error::Error;
use std::fmt::Write as _;

use serde_json::Value;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("usage: scene_from_reference CASE.json")?;
    let case: Value = serde_json::from_str(&std::fs::read_to_string(&path)?)?;
    print!("{}", scene(&case)?);
    Ok(())
}

fn scene(case: &Value) -> Result<String, Box<dyn Error>> {
    let samples = case["samples"].as_array().ok_or("no samples")?;
    let times: Vec<String> = samples.iter().map(|sample| sample["t"].to_string()).collect();
    let mut scene = String::new();
    writeln!(scene, "title = {}", case["description"])?;
    writeln!(scene, "sample_times_s = [{}]\n", times.join(", "))?;
    writeln!(scene, "[[body]]")?;
    writeln!(scene, "mass_kg = {}", case["mass"])?;
    writeln!(scene, "principal_moments_kg_m2 = {}", case["inertia"])?;
    writeln!(scene, "attitude = {}", unit(&case["q0_unit"])?)?;
    writeln!(scene, "angular_velocity_rad_s = {}", case["omega0_body"])?;
    if !case["x0"].is_null() {
        writeln!(scene, "position_m = {}\nvelocity_m_s = {}", case["x0"], case["v0"])?;
    }
    // Keys of the body itself come before its tables.
    let torques = case["torques"].as_array().ok_or("no torques")?;
    for torque in torques.iter().filter(|torque| torque["kind"] == "heavy_top") {
        writeln!(scene, "centre_of_mass_m = {}", torque["r_cm_body"])?;
        writeln!(scene, "gravity_m_s2 = {}", torque["gravity_world"])?;
        writeln!(scene, "\n[body.pivot]\ninertia_about_pivot = true")?;
    }
    for torque in torques {
        let kind = torque["kind"].as_str().ok_or("a torque without kind")?;
        match kind {
            "heavy_top" => continue,
            "constant_body" | "constant_world" => {
                writeln!(scene, "\n[[body.torque.{kind}]]\nmoment_n_m = {}", torque["torque"])?;
            }
            "linear_damping" => {
                writeln!(scene, "\n[[body.torque.linear_damping]]\ncoefficient_n_m_s = {}", torque["c"])?;
            }
            "gravity_gradient" => {
                writeln!(scene, "\n[[body.torque.gravity_gradient]]\nmean_motion_rad_s = {}", torque["n"])?;
            }
            "point_force_world" | "point_force_body" => {
                let frame = if kind.ends_with("world") { "world" } else { "body" };
                writeln!(scene, "\n[[body.force.constant_{frame}]]\nforce_n = {}", torque["force"])?;
                writeln!(scene, "point_m = {}", torque["point_body"])?;
            }
            other => return Err(format!("the torque kind {other:?} has no counterpart").into()),
        }
        for (theirs, ours) in [("t_start", "start_s"), ("t_end", "end_s")] {
            if !torque[theirs].is_null() {
                writeln!(scene, "{ours} = {}", torque[theirs])?;
            }
        }
    }
    Ok(scene)
}

/// The case's exactly normalised quaternion, rounded to f64.
fn unit(strings: &Value) -> Result<String, Box<dyn Error>> {
    let components = strings.as_array().ok_or("no q0_unit")?;
    let rounded = components.iter().map(|component| Ok(component.as_str().ok_or("q0_unit holds strings")?.parse()?));
    Ok(format!("{:?}", rounded.collect::<Result<Vec<f64>, Box<dyn Error>>>()?))
}
