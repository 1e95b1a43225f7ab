use super::{Combined, DynamicsError, Load, Problem, Torque};

/// Time from 0 on, cut where a load starts or ends and where a function of time has a knot: within a span the equations
/// of motion are smooth.
///
/// Spans are made when they are asked for, so that a table of many knots costs no more than its knots.
#[derive(Debug, Clone, PartialEq)]
pub struct Schedule {
    problem: Problem,
    /// The first instant of each span, s: from 0, ascending.
    starts: Vec<f64>,
}

/// `start ≤ t < end`, and what acts in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Span {
    /// First instant, s.
    pub start: f64,
    /// First instant after it, s; infinity in the last span.
    pub end: f64,
    /// All that acts.
    pub loads: Combined,
}

impl Schedule {
    /// Cuts [0, ∞) at the edges of the problem's windows and at the knots within them, exactly.
    ///
    /// # Errors
    /// If a force moves a body of unknown mass, or two different orbits act at once.
    pub fn new(problem: &Problem) -> Result<Self, DynamicsError> {
        let acting =
            || problem.loads.iter().filter(|load| load.window.start < load.window.end && load.window.end > 0.0);
        if problem.wants_translation && problem.mass.is_none() && acting().any(|load| load.torque.is_force()) {
            return Err(DynamicsError::NoMass);
        }
        let mut starts = vec![0.0];
        for load in acting() {
            let window = load.window;
            starts.extend([window.start, window.end]);
            let knots = load.torque.profile().map_or(&[][..], |profile| profile.knots());
            starts.extend(knots.iter().filter(|knot| window.contains(**knot)));
        }
        starts.retain(|start| *start >= 0.0 && start.is_finite());
        starts.sort_by(f64::total_cmp);
        // -0 and 0 are one instant.
        starts.dedup_by(|later, earlier| later == earlier);
        one_orbit(acting())?;
        Ok(Self { problem: problem.clone(), starts })
    }

    /// How many spans there are; at least one.
    #[must_use]
    pub fn count(&self) -> usize {
        self.starts.len()
    }

    /// Span number `index`, in order of time: the first starts at 0, and the last, which stands for all after it, goes on
    /// for ever.
    #[must_use]
    pub fn span(&self, index: usize) -> Span {
        let (start, end) = self.bounds(index);
        Span { start, end, loads: Combined::at(&self.problem, start) }
    }

    /// First instant of span number `index`, s, and the first after it.
    #[must_use]
    pub fn bounds(&self, index: usize) -> (f64, f64) {
        let index = index.min(self.count() - 1);
        (self.starts[index], self.starts.get(index + 1).copied().unwrap_or(f64::INFINITY))
    }

    /// Whether the attitude has to be propagated for the loads' sake.
    #[must_use]
    pub fn needs_attitude(&self) -> bool {
        let moves = self.problem.wants_translation;
        let acts = |load: &Load| load.window.start < load.window.end && load.window.end > 0.0;
        self.problem.loads.iter().any(|load| acts(load) && load.torque.needs_attitude(moves))
    }
}

/// That no two gravity gradients of different orbits overlap.
fn one_orbit<'a>(loads: impl Iterator<Item = &'a Load>) -> Result<(), DynamicsError> {
    let mut orbits: Vec<(f64, f64, f64)> = loads
        .filter_map(|load| match load.torque {
            Torque::GravityGradient { mean_motion } => Some((load.window.start.max(0.0), load.window.end, mean_motion)),
            _ => None,
        })
        .collect();
    orbits.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Those so far that act longest: of one mean motion, as any two that overlapped have been refused.
    let mut latest: Option<(f64, f64)> = None;
    for (start, end, mean_motion) in orbits {
        match &mut latest {
            Some((until, same)) if start < *until => {
                if *same != mean_motion {
                    return Err(DynamicsError::TwoOrbits);
                }
                *until = until.max(end);
            }
            _ => latest = Some((end, mean_motion)),
        }
    }
    Ok(())
}
