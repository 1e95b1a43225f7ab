use polhode::scenario::{Plan, Scenario, ScenarioError};

/// Attitude, position, ω, L, τ, energies, drifts: 22 numbers a sample, with its time 23.
const CHANNELS: &str = "channels=[\"attitude\", \"position\", \"angular_velocity\", \"angular_momentum_world\", \
     \"moment_body\", \"rotational_energy\", \"translational_energy\", \"potential_energy\", \"total_energy\", \
     \"energy_drift\", \"momentum_drift\"]";
const INTERVAL_S: f64 = 0.005;

/// The Dzhanibekov scene, in closed form: next to nothing is spent on the motion itself.
pub fn plan(samples: u32) -> Result<Plan, ScenarioError> {
    let duration_s = INTERVAL_S * f64::from(samples - 1);
    let assignments = [CHANNELS.to_owned(), format!("duration_s={duration_s}"), format!("sample_every_s={INTERVAL_S}")];
    Plan::new(&Scenario::named("dzhanibekov", &assignments)?)
}
