use polhode::propagation::States;
use rapier3d_f64::math::{Rotation, Vector};
use rapier3d_f64::prelude::{MassProperties, PhysicsWorld, RigidBody, RigidBodyBuilder, RigidBodyHandle};

use crate::cases::Case;
use crate::peer::{Peer, empty_states, keep};

/// One body without a shape: its moments about principal axes, gyroscopic forces on, no damping, no sleep, no limit on
/// fast turns; no gravity, every moment as a torque that is held over a step. Case C, too: its moments are about the
/// pivot and gravity is its torque about it, so no joint adds an error of its own.
pub struct Rapier {
    /// Parts of a step; 4 where nothing is said.
    pub substeps: usize,
}

/// Steps between outputs double; a run of more substeps than this is not tried.
const SUBSTEPS_MAX: u64 = 1 << 23;

impl Peer for Rapier {
    fn name(&self) -> &'static str {
        "rapier3d-f64"
    }

    fn way(&self) -> String {
        format!("substeps {}", self.substeps)
    }

    /// Steps between outputs.
    fn settings(&self, case: &Case) -> Vec<f64> {
        let in_one = (case.times().len() * self.substeps) as u64;
        let fits = |steps: &u32| u64::from(*steps) * in_one <= SUBSTEPS_MAX;
        (0..31).map(|doublings| 1 << doublings).take_while(fits).map(f64::from).collect()
    }

    fn states(&self, case: &Case, steps: f64) -> Option<States> {
        let mut states = empty_states(case);
        let (mut world, handle) = world(case);
        world.integration_parameters.num_solver_iterations = self.substeps;
        world.integration_parameters.dt = case.end_s / states.len() as f64 / steps;
        for row in 0..states.len() {
            for _ in 0..steps as u32 {
                act(case, &mut world.bodies[handle]);
                world.step();
            }
            keep(&mut states, row, state(&world.bodies[handle]));
        }
        Some(states)
    }
}

fn world(case: &Case) -> (PhysicsWorld, RigidBodyHandle) {
    let [w, x, y, z] = case.attitude;
    let attitude = Rotation::from_xyzw(x, y, z, w);
    let mass = MassProperties::new(Vector::ZERO, 1.0, Vector::from_array(case.moments));
    let mut body = RigidBodyBuilder::dynamic()
        .additional_mass_properties(mass)
        .angvel(attitude * Vector::from_array(case.rates))
        .linear_damping(0.0)
        .angular_damping(0.0)
        .gyroscopic_forces_enabled(true)
        .allow_fast_rotation(true)
        .can_sleep(false)
        .build();
    body.set_rotation(attitude, true);
    let mut world = PhysicsWorld { gravity: Vector::ZERO, ..PhysicsWorld::default() };
    let handle = world.insert_body(body);
    (world, handle)
}

/// The case's moment, in world axes as it is now.
fn act(case: &Case, body: &mut RigidBody) {
    let moment = case.moment_at(state(body));
    if moment != [0.0; 3] {
        let moment = *body.rotation() * Vector::from_array(moment);
        body.reset_torques(true);
        body.add_torque(moment, true);
    }
}

fn state(body: &RigidBody) -> [f64; 7] {
    let attitude = *body.rotation();
    let rates = attitude.inverse() * body.angvel();
    [attitude.w, attitude.x, attitude.y, attitude.z, rates.x, rates.y, rates.z]
}
