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
