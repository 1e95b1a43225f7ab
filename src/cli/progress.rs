use std::fmt;
use std::io::IsTerminal;

use indicatif::{MultiProgress, ProgressBar, ProgressState, ProgressStyle};
use terminal_size::{Width, terminal_size_of};

/// Bars on stderr, one a scene, on a terminal only, and only where a line of them fits into one of the terminal's.
pub struct Progress {
    /// With what a bar looks like.
    bars: Option<(MultiProgress, &'static str)>,
}

impl Progress {
    /// Bars, if they are wanted and somebody can see them.
    pub fn new(wanted: bool) -> Self {
        let is_seen = wanted && std::io::stderr().is_terminal();
        // A terminal that does not say how wide it is has the width of a teletype.
        let columns = terminal_size_of(std::io::stderr()).map_or(80, |(Width(columns), _)| columns);
        let template = is_seen.then(|| template(columns)).flatten();
        Self { bars: template.map(|template| (MultiProgress::new(), template)) }
    }

    /// A bar for one scene of `samples` samples.
    pub fn bar(&self, name: &str, samples: u64) -> ProgressBar {
        let Some((bars, template)) = &self.bars else { return ProgressBar::hidden() };
        let rate = |state: &ProgressState, text: &mut dyn fmt::Write| {
            // A bar has nowhere to report that it could not be drawn.
            let _ = write!(text, "{:.0} samples/s", state.per_sec());
        };
        let style = ProgressStyle::with_template(template)
            .unwrap_or_else(|_| ProgressStyle::default_bar())
            .with_key("rate", rate);
        bars.add(ProgressBar::new(samples)).with_style(style).with_message(name.to_owned())
    }
}

/// What fits on a line, with a column to spare: a line that reaches the last one is two to some terminals.
const fn template(columns: u16) -> Option<&'static str> {
    match columns {
        0..8 => None,
        8..32 => Some("{percent:>3} %"),
        32..80 => Some("{msg:16!} {bar:8} {percent:>3} %"),
        80..112 => Some("{msg:16!} {bar:16} {percent:>3} %  {rate:>18!}  {eta:>8!} left"),
        112.. => Some("{msg:24!} {bar:32} {percent:>3} %  {rate:>20!}  {eta:>8!} left"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bar_is_no_wider_than_its_terminal() {
        // Letters of a template that stand for themselves, and the widths of its keys.
        let width = |template: &str| {
            let parts = template.split(['{', '}']).enumerate();
            let of_key = |key: &str| match key.split_once(':') {
                Some((_, width)) => width.trim_matches(['!', '>']).parse().expect("a width"),
                None => panic!("{key} may be of any width"),
            };
            parts.map(|(number, part)| if number % 2 == 1 { of_key(part) } else { part.len() }).sum::<usize>()
        };
        for columns in 1..300 {
            if let Some(template) = template(columns) {
                assert!(width(template) < usize::from(columns), "{columns}: {template}");
                assert!(ProgressStyle::with_template(template).is_ok(), "{template}");
            }
        }
        assert!(template(7).is_none(), "there is no room for a percentage");
    }
}
