/// States at many times, as columns. A group that nobody wants stays empty.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct States {
    /// World from principal axes: w, x, y, z. Unit to rounding.
    pub attitude: [Vec<f64>; 4],
    /// In principal axes, rad/s.
    pub angular_velocity: [Vec<f64>; 3],
    /// Of the reference point, world axes, m.
    pub position: [Vec<f64>; 3],
    /// Of the reference point, world axes, m/s.
    pub velocity: [Vec<f64>; 3],
    /// Of a sphere inside the body relative to it, in principal axes, rad/s; empty without one.
    pub inner: [Vec<f64>; 3],
    /// Of the particles that the body is made of, where springs join them; empty without.
    pub cloud: CloudStates,
}

/// Particles on springs at many times.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct CloudStates {
    /// In the order of the cloud.
    pub particles: Vec<ParticleColumns>,
    /// L of all particles about their centre of mass, world axes, N m s.
    pub momentum: [Vec<f64>; 3],
    /// Of all particles relative to their centre of mass, J.
    pub kinetic_energy: Vec<f64>,
    /// Of all springs, J.
    pub elastic_energy: Vec<f64>,
}

/// One particle at many times, world axes.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ParticleColumns {
    /// From the centre of mass of all, m.
    pub arm: [Vec<f64>; 3],
    /// Relative to the centre of mass, m/s.
    pub velocity: [Vec<f64>; 3],
    /// Of all springs on it together, N.
    pub force: [Vec<f64>; 3],
}

impl CloudStates {
    /// Makes room for `count` states (contents unspecified) of so many particles, keeping what was allocated.
    pub fn reset(&mut self, particles: usize, count: usize) {
        self.particles.resize_with(particles, ParticleColumns::default);
        for ParticleColumns { arm, velocity, force } in &mut self.particles {
            for column in arm.iter_mut().chain(velocity).chain(force) {
                column.resize(count, 0.0);
            }
        }
        for column in &mut self.momentum {
            column.resize(count, 0.0);
        }
        self.kinetic_energy.resize(count, 0.0);
        self.elastic_energy.resize(count, 0.0);
    }
}

impl States {
    /// Makes room for `count` states (contents unspecified), keeping what was allocated.
    pub fn reset(&mut self, count: usize, with_attitude: bool, with_translation: bool) {
        let room = |columns: &mut [Vec<f64>], wanted: bool| {
            for column in columns {
                column.resize(if wanted { count } else { 0 }, 0.0);
            }
        };
        room(&mut self.attitude, with_attitude);
        room(&mut self.angular_velocity, true);
        room(&mut self.position, with_translation);
        room(&mut self.velocity, with_translation);
    }

    /// How many states.
    #[must_use]
    pub fn len(&self) -> usize {
        self.angular_velocity[0].len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
