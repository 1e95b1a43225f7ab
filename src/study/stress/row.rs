use super::cases::{Case, Depth};
use super::cell::Cell;
use super::truth::Truth;
use crate::scenario::{Method, Plan};

/// One case by every method.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The motion.
    pub case: Case,
    /// What errors are measured from; or why there is nothing to measure.
    pub truth: Result<Truth, NoTruth>,
    /// In the order of the methods asked for.
    pub cells: Vec<Cell>,
}

/// Why there is nothing to measure.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NoTruth {
    /// In words.
    pub reason: String,
    /// Whether the scene is refused by its plan, before any run, rather than the reference at a loss.
    pub is_planned: bool,
}

/// Runs `methods` on `case`.
#[must_use]
pub fn stress(case: &Case, methods: &[Method], depth: Depth) -> Row {
    let row = Row::begin(case);
    let cells = methods.iter().map(|method| row.cell(*method, depth)).collect();
    Row { cells, ..row }
}

impl Row {
    /// With its truth, and no cells yet.
    #[must_use]
    pub fn begin(case: &Case) -> Self {
        Self { case: case.clone(), truth: truth(case), cells: Vec::new() }
    }

    /// Runs `method`: cells know nothing of each other, and may be run side by side.
    #[must_use]
    pub fn cell(&self, method: Method, depth: Depth) -> Cell {
        Cell::of(&self.case, method, depth, self.truth.as_ref())
    }
}

fn truth(case: &Case) -> Result<Truth, NoTruth> {
    let plan = Plan::new(&case.scenario).map_err(|error| NoTruth { reason: error.to_string(), is_planned: true })?;
    let mut times = Vec::new();
    plan.grid.fill(0, usize::MAX, &mut times);
    let truth = plan.bodies.first().map(|body| Truth::of(body, times));
    let lost = |reason: String| NoTruth { reason, is_planned: false };
    truth.ok_or_else(|| lost("no body".to_owned()))?.map_err(|error| lost(error.to_string()))
}
