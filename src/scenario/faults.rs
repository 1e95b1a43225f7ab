/// Faults that are told of one scene: more than these nobody reads.
pub const MOST_FAULTS: usize = 50;

/// One thing that is wrong, and perhaps others.
#[derive(Debug, Clone)]
pub struct Faults<T> {
    /// What is met first.
    pub first: T,
    /// What is met besides.
    pub others: Vec<T>,
}

impl<T> Faults<T> {
    /// Those of `faults`, if there are any.
    pub fn of(faults: Vec<T>) -> Option<Self> {
        let mut faults = faults.into_iter();
        Some(Self { first: faults.next()?, others: faults.collect() })
    }

    /// Each turned into something else.
    pub fn map<U>(self, mut turn: impl FnMut(T) -> U) -> Faults<U> {
        Faults { first: turn(self.first), others: self.others.into_iter().map(turn).collect() }
    }

    /// All of them, in order.
    pub fn all(self) -> Vec<T> {
        [self.first].into_iter().chain(self.others).collect()
    }
}

impl<T> From<T> for Faults<T> {
    fn from(first: T) -> Self {
        Self { first, others: Vec::new() }
    }
}
