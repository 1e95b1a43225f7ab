//! A free rigid body in rapier, for its test in `tests/free_rotation.rs`.

use rapier3d_f64::math::{Rotation, Vector};
use rapier3d_f64::prelude::{MassProperties, PhysicsWorld, RigidBodyBuilder, RigidBodyHandle};

/// One body without a shape and without loads, as exact as rapier turns it: gyroscopic forces on, no damping, no sleep, no
/// limit on fast turns.
pub struct FreeBody {
    world: PhysicsWorld,
    handle: RigidBodyHandle,
    steps: u64,
}

impl FreeBody {
    /// Moments about the body's axes, kg m²; attitude w, x, y, z, world from body; angular velocity in world axes, rad/s;
    /// the step, s, and the parts that rapier divides it into (4 where nothing is said).
    #[must_use]
    pub fn new(
        moments: [f64; 3],
        [w, x, y, z]: [f64; 4],
        angular_velocity: [f64; 3],
        step_s: f64,
        substeps: usize,
    ) -> Self {
        let mut body = RigidBodyBuilder::dynamic()
            .additional_mass_properties(MassProperties::new(Vector::ZERO, 1.0, Vector::from_array(moments)))
            .angvel(Vector::from_array(angular_velocity))
            .linear_damping(0.0)
            .angular_damping(0.0)
            .gyroscopic_forces_enabled(true)
            .allow_fast_rotation(true)
            .can_sleep(false)
            .build();
        body.set_rotation(Rotation::from_xyzw(x, y, z, w), true);
        let mut world = PhysicsWorld { gravity: Vector::ZERO, ..PhysicsWorld::default() };
        world.integration_parameters.dt = step_s;
        world.integration_parameters.num_solver_iterations = substeps;
        let handle = world.insert_body(body);
        Self { world, handle, steps: 0 }
    }

    /// Steps to the time `time_s` or to the step next to it.
    pub fn advance_to(&mut self, time_s: f64) {
        let steps = (time_s / self.world.integration_parameters.dt).round() as u64;
        while self.steps < steps {
            self.world.step();
            self.steps += 1;
        }
    }

    /// Attitude w, x, y, z, world from body.
    #[must_use]
    pub fn attitude(&self) -> [f64; 4] {
        let attitude = self.world.bodies[self.handle].rotation();
        [attitude.w, attitude.x, attitude.y, attitude.z]
    }

    /// In world axes, rad/s.
    #[must_use]
    pub fn angular_velocity(&self) -> [f64; 3] {
        self.world.bodies[self.handle].angvel().to_array()
    }
}
