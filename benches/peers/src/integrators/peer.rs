use polhode::propagation::States;

use crate::cases::Case;

/// A way to use somebody else's crate. Of several ways to use one crate, the fastest counts.
pub trait Peer {
    /// The crate.
    fn name(&self) -> &'static str;

    /// Which way, for people.
    fn way(&self) -> String;

    /// What it can be told for `case`, from loose to tight.
    fn settings(&self, case: &Case) -> Vec<f64>;

    /// The motion at the case's times; `None` where it gives up.
    fn states(&self, case: &Case, setting: f64) -> Option<States>;
}

/// Tolerances, relative and absolute alike, in half decades.
pub fn tolerances() -> Vec<f64> {
    (6..=30).map(|half| 10_f64.powf(-f64::from(half) / 2.0)).collect()
}

/// As many empty rows as `case` has outputs.
pub fn empty_states(case: &Case) -> States {
    let mut states = States::default();
    states.reset(case.times().len(), true, false);
    states
}

/// Keeps w, x, y, z and the rates in body axes.
pub fn keep(states: &mut States, row: usize, [w, x, y, z, p, q, r]: [f64; 7]) {
    for (column, value) in states.attitude.iter_mut().zip([w, x, y, z]) {
        column[row] = value;
    }
    for (column, value) in states.angular_velocity.iter_mut().zip([p, q, r]) {
        column[row] = value;
    }
}
