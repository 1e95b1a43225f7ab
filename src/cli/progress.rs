use std::fmt;
use std::io::IsTerminal;

use indicatif::{MultiProgress, ProgressBar, ProgressState, ProgressStyle};

/// Bars on stderr, one a scene, on a terminal only.
pub struct Progress {
    bars: Option<MultiProgress>,
}

impl Progress {
    /// Bars, if they are wanted and somebody can see them.
    pub fn new(wanted: bool) -> Self {
        Self { bars: (wanted && std::io::stderr().is_terminal()).then(MultiProgress::new) }
    }

    /// A bar for one scene of `samples` samples.
    pub fn bar(&self, name: &str, samples: u64) -> ProgressBar {
        let Some(bars) = &self.bars else { return ProgressBar::hidden() };
        let rate = |state: &ProgressState, text: &mut dyn fmt::Write| {
            // A bar has nowhere to report that it could not be drawn.
            let _ = write!(text, "{:.0} samples/s", state.per_sec());
        };
        let style = ProgressStyle::with_template("{msg:24!} {bar:32} {percent:>3} %  {rate}  {eta} left")
            .unwrap_or_else(|_| ProgressStyle::default_bar())
            .with_key("rate", rate);
        bars.add(ProgressBar::new(samples)).with_style(style).with_message(name.to_owned())
    }
}
