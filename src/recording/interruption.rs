/// Where a run was stopped that was to go on, by whatever.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interruption {
    /// Samples that were recorded.
    pub samples: u64,
    /// Samples that there were to be, if that is known.
    pub planned: Option<u64>,
    /// Time of the last recorded, s.
    pub to_s: f64,
}

impl Interruption {
    /// How much of the run there is, in words.
    #[must_use]
    pub fn in_words(&self) -> String {
        let planned = self.planned.map_or_else(|| "an unknown number of".to_owned(), |planned| planned.to_string());
        format!("the first {} of {planned} samples, to {} s", self.samples, self.to_s)
    }
}
