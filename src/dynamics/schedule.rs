use super::{Combined, DynamicsError, Problem};

/// Time from 0 on, cut where a load starts or ends: within a span the equations of motion are smooth.
#[derive(Debug, Clone, PartialEq)]
pub struct Schedule {
    spans: Vec<Span>,
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
    /// Cuts [0, ∞) at the edges of the problem's windows, exactly.
    ///
    /// # Errors
    /// If the loads of a span do not make an equation of motion.
    pub fn new(problem: &Problem) -> Result<Self, DynamicsError> {
        let mut edges: Vec<f64> = problem
            .loads
            .iter()
            .filter(|load| load.window.start < load.window.end)
            .flat_map(|load| [load.window.start, load.window.end])
            .filter(|edge| *edge > 0.0 && edge.is_finite())
            .chain([0.0, f64::INFINITY])
            .collect();
        edges.sort_by(f64::total_cmp);
        edges.dedup();
        let spans = edges
            .windows(2)
            .map(|pair| Ok(Span { start: pair[0], end: pair[1], loads: Combined::at(problem, pair[0])? }))
            .collect::<Result<_, _>>()?;
        Ok(Self { spans })
    }

    /// The spans, in order; at least one, the first from 0 and the last for ever.
    #[must_use]
    pub fn spans(&self) -> &[Span] {
        &self.spans
    }

    /// Whether the attitude has to be propagated for the loads' sake.
    #[must_use]
    pub fn needs_attitude(&self) -> bool {
        self.spans.iter().any(|span| span.loads.needs_attitude())
    }
}
