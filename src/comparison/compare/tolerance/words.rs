use super::error::ToleranceError;
use super::rule::{Rule, Tolerance, Tolerances};
use crate::telemetry::Channel;

impl Tolerances {
    /// The same with what `assignment` says: `attitude=1e-9`, `angular_velocity=1e-12,1e-9` (absolute, in the channel's
    /// unit, and of its largest size), `slip=shown`, `tilt=exact`.
    ///
    /// # Errors
    /// If it is of another form, names no channel, or has a number that is no tolerance.
    pub fn assign(self, assignment: &str) -> Result<Self, ToleranceError> {
        let wrong = || ToleranceError::Form { text: assignment.to_owned() };
        let (name, value) = assignment.split_once('=').ok_or_else(wrong)?;
        let (name, value) = (name.trim(), value.trim());
        let channel = channel_named(name)?;
        let number = |text: &str| text.trim().parse::<f64>().map_err(|_| wrong());
        let rule = match (Rule::named(value), value.split_once(',')) {
            (Some(rule), _) => rule,
            (None, None) => Rule::Within(Tolerance::new(number(value)?, 0.0)?),
            (None, Some((absolute, relative))) => Rule::Within(Tolerance::new(number(absolute)?, number(relative)?)?),
        };
        Ok(self.with(channel, rule))
    }

    /// What counts as the same, in words; of the channels `compared`.
    #[must_use]
    pub fn in_words(&self, compared: &[Channel]) -> String {
        if self.are_exact() {
            return "every bit counts".into();
        }
        let standard = Self::default();
        let is_other = |channel: &&Channel| self.of(**channel) != standard.of(**channel);
        let others: Vec<_> = compared.iter().filter(is_other).collect();
        let words = |channel: &&Channel| format!("{} {}", channel.row().name, self.of(**channel).in_words(**channel));
        let words: Vec<_> = others.iter().map(words).collect();
        let rest =
            "1e-9 rad between attitudes and tilts, 1e-9 of the largest size of the rest; drifts and slip are shown";
        match (others.len(), compared.len()) {
            (0, _) => rest.to_owned(),
            (some, all) if some == all => words.join("; "),
            _ => format!("{}; else {rest}", words.join("; ")),
        }
    }
}

/// The channel called `name`.
///
/// # Errors
/// If there is none: what may have been meant.
pub fn channel_named(name: &str) -> Result<Channel, ToleranceError> {
    let name_of = |channel: Channel| channel.row().name.to_owned();
    Channel::from_name(name).ok_or_else(|| ToleranceError::unknown(name, name_of))
}

impl Rule {
    /// By a word.
    pub(in crate::comparison) fn named(word: &str) -> Option<Self> {
        match word {
            "exact" => Some(Self::Exact),
            "shown" => Some(Self::Shown),
            _ => None,
        }
    }

    fn in_words(self, channel: Channel) -> String {
        let unit = unit(channel);
        match self {
            Self::Exact => "to the bit".into(),
            Self::Shown => "shown only".into(),
            Self::Within(tolerance) => match (tolerance.absolute(), tolerance.relative()) {
                (absolute, 0.0) => format!("within {absolute:e} {unit}"),
                (0.0, relative) => format!("within {relative:e} of its largest"),
                (absolute, relative) => format!("within {absolute:e} {unit} and {relative:e} of its largest"),
            },
        }
    }
}

/// In what differences of a channel are told: rad between attitudes.
pub(in crate::comparison) const fn unit(channel: Channel) -> &'static str {
    if matches!(channel, Channel::Attitude) { "rad" } else { channel.row().unit }
}
