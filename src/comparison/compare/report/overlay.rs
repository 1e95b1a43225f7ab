use std::fmt::Write as _;

use super::found::{BodyReport, ChannelReport, Report};
use crate::body::Surface;
use crate::recording::{DifferenceCurve, OverlaidBody, Overlay, Poses};
use crate::scenario::Plan;

/// What the bodies of a side look like, by name, as far as it is known.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Shapes(Vec<(String, Vec<Surface>)>);

impl Shapes {
    pub(in crate::comparison) fn of(plan: &Plan) -> Self {
        Self(plan.bodies.iter().map(|body| (body.name.clone(), body.surfaces.clone())).collect())
    }

    /// Of the body of that name, or of the only one.
    fn get(&self, name: &str) -> Option<&Vec<Surface>> {
        let (_, surfaces) = match self.0.as_slice() {
            [only] => Some(only),
            several => several.iter().find(|(known, _)| known == name),
        }?;
        (!surfaces.is_empty()).then_some(surfaces)
    }
}

impl Report {
    /// Both motions over each other, with what was found: `poses` are those of
    /// [`Comparison::run_with_poses`](crate::comparison::Comparison::run_with_poses).
    #[must_use]
    pub fn overlay(&self, poses: Vec<Poses>, shapes: &[Shapes; 2]) -> Overlay {
        let shape = |body: &BodyReport| {
            let known = (0..2).find_map(|side| shapes[side].get(&body.names[side]));
            known.cloned().unwrap_or_default()
        };
        let bodies = self.bodies.iter().zip(poses);
        let bodies =
            bodies.map(|(body, poses)| OverlaidBody { name: body.name().to_owned(), surfaces: shape(body), poses });
        let mut channels: Vec<_> = self.channels().collect();
        channels.sort_by(|one, other| other.1.severity().total_cmp(&one.1.severity()));
        let differing = channels.into_iter().filter(|(_, channel)| channel.worst_difference() > 0.0);
        let [a, b] = &self.sides;
        Overlay {
            title: format!("{} and {}", a.name, b.name),
            words: self.in_markdown(),
            from_s: self.common.from_s,
            to_s: self.common.to_s,
            bodies: bodies.collect(),
            differences: differing.map(|(body, channel)| curve(body, channel)).collect(),
        }
    }

    fn in_markdown(&self) -> String {
        let [a, b] = &self.sides;
        let mut text = format!("### {}\n\n", plain(&self.verdict()));
        // Writing to a string cannot fail.
        let _ =
            write!(text, "* **A**, solid blue: {}\n* **B**, translucent orange: {}\n", plain(&a.name), plain(&b.name));
        let common = self.common;
        let _ = writeln!(text, "* {} times, {} to {} s\n", common.samples, common.from_s, common.to_s);
        for difference in &self.differences {
            let _ = writeln!(text, "* {}", plain(&self.describe(difference)));
        }
        text += "\n| body | channel | worst | limit | unit | at s | growth |\n|---|---|---|---|---|---|---|\n";
        for (body, channel) in self.channels() {
            let limit = channel.limit.map_or("–".to_owned(), |limit| format!("{limit:.1e}"));
            let at = channel.worst.map_or("–".to_owned(), |worst| format!("{:.6}", worst.time_s));
            let growth = channel.growth.as_ref().map_or("–".to_owned(), crate::comparison::Growth::in_words);
            let (name, worst) = (plain(channel.channel.row().name), channel.worst_difference());
            let row = [plain(body.name()), name, format!("{worst:.1e}"), limit, channel.unit().into(), at, growth];
            let _ = writeln!(text, "| {} |", row.join(" | "));
        }
        text
    }
}

fn curve(body: &BodyReport, channel: &ChannelReport) -> DifferenceCurve {
    DifferenceCurve {
        body: body.name().to_owned(),
        channel: channel.channel.row().name.to_owned(),
        unit: channel.unit().to_owned(),
        limit: channel.limit,
        points: channel.trace.points().collect(),
    }
}

/// Without what Markdown takes for marks.
fn plain(text: &str) -> String {
    let is_mark = |letter: char| "\\`*_[]<>|#".contains(letter);
    text.chars().flat_map(|letter| is_mark(letter).then_some('\\').into_iter().chain([letter])).collect()
}
