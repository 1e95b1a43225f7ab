use super::axes::Axes;
use super::drawing::{Anchor, Dash, Drawing, Ink, Line, Rectangle};
use super::font::text_width;
use super::legend::Entry;
use super::scale::{Scale, extremes};

/// Several series against time, with lines to hold them against and marks of what happened.
///
/// ```
/// use polhode::plot::{Series, Surroundings, TimeChart};
///
/// let points = vec![[0.0, 1e-15], [10.0, 3e-14]];
/// let chart = TimeChart {
///     title: "attitude error".into(),
///     unit: "rad".into(),
///     series: vec![Series::new("body", points)],
///     is_logarithmic: true,
///     ..TimeChart::default()
/// };
/// let svg = chart.draw(560.0, 240.0).svg(Surroundings::Paper);
/// assert!(svg.contains("attitude error, rad"));
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TimeChart {
    /// What is drawn.
    pub title: String,
    /// In which unit.
    pub unit: String,
    /// The curves.
    pub series: Vec<Series>,
    /// Values to hold them against.
    pub limits: Vec<Limit>,
    /// Times at which something happened.
    pub marks: Vec<Mark>,
    /// Whether equal ratios are equally far; zeros and negative values are then not drawn.
    pub is_logarithmic: bool,
    /// From when to when, s; left out: as the series are.
    pub times_s: Option<(f64, f64)>,
}

/// One curve of a chart.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Series {
    /// What it is; a chart with one nameless series has no legend.
    pub label: String,
    /// Times in s and values, times ascending. A value that is no number leaves a gap.
    pub points: Vec<[f64; 2]>,
}

/// A horizontal line.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Limit {
    /// What it is.
    pub label: String,
    /// Where.
    pub value: f64,
}

/// A vertical line.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mark {
    /// What happened, in words; may be empty.
    pub label: String,
    /// When, s.
    pub time_s: f64,
}

impl Series {
    /// A curve.
    #[must_use]
    pub fn new(label: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self { label: label.into(), points }
    }
}

/// Of the words over a chart, pixels.
const TITLE: f64 = 14.0;
/// Left for the numbers, over the frame, beside it and under it, pixels.
const LEFT: f64 = 62.0;
const TOP: f64 = 34.0;
const RIGHT: f64 = 22.0;
const BOTTOM: f64 = 48.0;

impl TimeChart {
    /// A sheet of that many pixels with it.
    #[must_use]
    pub fn draw(&self, width: f64, height: f64) -> Drawing {
        let mut sheet = Drawing::new(width, height);
        let across = self.across(ticks(width, 80.0));
        let entries = self.entries(&across);
        let legend: f64 = entries.iter().map(Entry::width).sum();
        let up = self.up(ticks(height, 46.0));
        let words = match up.counted(&self.unit).as_str() {
            "" | "1" => self.title.clone(),
            unit => format!("{}, {unit}", self.title),
        };
        // The legend stands beside the title, or under it where there is no room.
        let has_room = LEFT + text_width(&words, TITLE) + 20.0 + legend <= width - RIGHT;
        let top = if has_room || entries.is_empty() { TOP } else { TOP + 20.0 };
        let axes = Axes {
            frame: Rectangle { left: LEFT, top, width: width - LEFT - RIGHT, height: height - top - BOTTOM },
            across,
            up,
        };
        axes.draw(&mut sheet, "time, s", "");
        sheet.text([LEFT, 20.0], Anchor::Start, TITLE, Ink::Text, words);
        let mut x = if has_room { width - RIGHT + 14.0 - legend } else { LEFT };
        for entry in &entries {
            entry.draw(&mut sheet, [x, top - 14.0]);
            x += entry.width();
        }
        self.curves(&mut sheet, &axes);
        sheet
    }

    fn curves(&self, sheet: &mut Drawing, axes: &Axes) {
        for mark in &self.marks {
            axes.mark(sheet, mark.time_s, MARK);
        }
        for limit in &self.limits {
            axes.level(sheet, limit.value, LIMIT);
        }
        for (index, series) in self.series.iter().enumerate() {
            let is_drawn = |value: f64| !self.is_logarithmic || value > 0.0;
            let gap = |[time, value]: [f64; 2]| [time, if is_drawn(value) { value } else { f64::NAN }];
            let line = if is_noise(axes, &series.points) { Line { width: 0.8, ..curve(index) } } else { curve(index) };
            axes.curve(sheet, series.points.iter().map(|point| gap(*point)), line);
            if let [only] = series.points.as_slice() {
                sheet.circle(axes.place(*only), 3.0, Some(super::Fill::new(Ink::Series(index))), None);
            }
        }
    }

    fn entries(&self, across: &Scale) -> Vec<Entry> {
        let named = self.series.iter().enumerate().filter(|(_, series)| !series.label.is_empty());
        let curves = named.map(|(index, series)| Entry::line(series.label.clone(), curve(index)));
        let limits = self.limits.iter().filter(|limit| !limit.label.is_empty());
        let mut entries: Vec<Entry> =
            curves.chain(limits.map(|limit| Entry::line(limit.label.clone(), LIMIT))).collect();
        // Marks of one kind are told once.
        let drawn = self.marks.iter().filter(|mark| (across.from..=across.to).contains(&mark.time_s));
        let mut told: Vec<&str> = drawn.map(|mark| mark.label.as_str()).filter(|label| !label.is_empty()).collect();
        told.sort_unstable();
        told.dedup();
        if let [only] = told.as_slice() {
            entries.push(Entry::line(*only, MARK));
        }
        entries
    }

    fn across(&self, most_ticks: usize) -> Scale {
        let times = self.series.iter().flat_map(|series| &series.points).map(|point| point[0]);
        let (from, to) = self.times_s.unwrap_or_else(|| extremes(times));
        Scale::linear(from, to, most_ticks)
    }

    fn up(&self, most_ticks: usize) -> Scale {
        let drawn = self.series.iter().flat_map(|series| &series.points).map(|point| point[1]);
        let values = drawn.chain(self.limits.iter().map(|limit| limit.value));
        if self.is_logarithmic {
            let (least, greatest) = extremes(values.filter(|value| *value > 0.0));
            return Scale::logarithmic(least, greatest, most_ticks);
        }
        Scale::around(values, most_ticks)
    }
}

/// Of a limit.
const LIMIT: Line = Line { ink: Ink::Text, width: 1.2, opacity: 0.8, dash: Dash::Dashed };
/// Of a mark.
const MARK: Line = Line { ink: Ink::Text, width: 1.0, opacity: 0.6, dash: Dash::Dotted };

/// Of the n-th series.
fn curve(index: usize) -> Line {
    Line::new(Ink::Series(index), 1.6)
}

/// Whether a curve goes up and down so much that a thick line would be a stain.
fn is_noise(axes: &Axes, points: &[[f64; 2]]) -> bool {
    let heights = points.iter().map(|point| axes.place(*point)[1]);
    let climbed: f64 =
        heights.clone().zip(heights.skip(1)).map(|(a, b)| (a - b).abs()).filter(|way| way.is_finite()).sum();
    climbed > NOISE * axes.frame.width
}

/// Pixels up and down for each pixel from side to side.
const NOISE: f64 = 12.0;

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a handful")]
fn ticks(length: f64, each: f64) -> usize {
    (length / each).clamp(3.0, 12.0) as usize
}
