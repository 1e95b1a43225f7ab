use super::found::{ChannelReport, Difference, Finding, Report};
use crate::comparison::compare::tolerance::Rule;
use crate::comparison::compare::tolerance::unit;

impl Report {
    /// Same or not, and why, in a line.
    #[must_use]
    pub fn verdict(&self) -> String {
        let is_out = |channel: &ChannelReport| channel.finding() == Finding::Different;
        let out = self.channels().filter(|(_, channel)| is_out(channel)).count();
        let others = (out + self.differences.len()).saturating_sub(1);
        let others = if others == 0 { String::new() } else { format!(" (and {others} more)") };
        if let Some((body, channel)) = self.worst().filter(|(_, channel)| is_out(channel)) {
            return format!("differs: {}{others}", leaves(body.name(), channel));
        }
        if let Some(difference) = self.differences.first() {
            return format!("differs: {}{others}", self.describe(difference));
        }
        if self.is_same_to_the_bit() {
            return format!("same to the bit, at {} times", self.common.samples);
        }
        let Some((body, channel)) = self.worst() else { return "same".into() };
        let Some(limit) = channel.limit else { return "same in all that is judged".into() };
        let (name, unit, worst) = (channel.channel.row().name, channel.unit(), channel.worst_difference());
        let of = format!("{name} of {}", body.name());
        match channel.interpolation {
            Some(error) if channel.finding() == Finding::Undecided => format!(
                "cannot tell: {of} is {worst:.1e} {unit} apart, of which interpolation may make {error:.1e}: more than the \
                 limit of {limit:.1e} {unit}"
            ),
            _ => format!("same: nearest to its limit is {of}, {worst:.1e} of {limit:.1e} {unit}"),
        }
    }

    /// A difference other than of values, in words.
    #[must_use]
    pub fn describe(&self, difference: &Difference) -> String {
        let name = |side: usize| &self.sides[side].name;
        match difference {
            Difference::Body { side, name: body } => format!("body {body} is in {} only", name(*side)),
            Difference::Channel { side, body, channel } => {
                format!("{} of {body} is in {} only", channel.row().name, name(*side))
            }
            Difference::Span => {
                let [a, b] = self.sides.each_ref().map(|side| side.coverage);
                let (a, b) = (format!("{} to {} s", a.from_s, a.to_s), format!("{} to {} s", b.from_s, b.to_s));
                format!("{} has samples from {a}, {} from {b}", name(0), name(1))
            }
            Difference::Times { side } => {
                let alone = self.sides[*side].alone;
                format!("{} times are in {} only, the first at {} s", alone.samples, name(*side), alone.from_s)
            }
        }
    }
}

impl ChannelReport {
    /// In what differences are told: rad between attitudes.
    #[must_use]
    pub const fn unit(&self) -> &'static str {
        unit(self.channel)
    }
}

/// What is out of tolerance, and since when.
fn leaves(body: &str, channel: &ChannelReport) -> String {
    let name = channel.channel.row().name;
    let from_s = plain(channel.first_out_s.unwrap_or_default());
    if let (Rule::Within(_), Some(limit)) = (channel.rule, channel.limit) {
        return format!("{name} of {body} leaves {limit:.1e} {} at {from_s} s", channel.unit());
    }
    let ulps = match channel.bits.most_ulps {
        u64::MAX => "no number on one side".to_owned(),
        1 => "1 ulp at most".to_owned(),
        ulps @ 0..1_000_000 => format!("{ulps} ulps at most"),
        _ => "far apart".to_owned(),
    };
    format!("{name} of {body} has other bits from {from_s} s on, {ulps}")
}

/// A time without the noise of its making: 0.3, not 0.30000000000000004.
fn plain(time_s: f64) -> String {
    let text = format!("{time_s:.9}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
