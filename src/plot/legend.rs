use super::Anchor;
use super::drawing::{Drawing, Fill, Ink, Line, Point};
use super::font::text_width;

/// What stands for a curve, a mark or a line.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// What it is.
    pub label: String,
    /// How it looks.
    pub sign: Sign,
}

/// How it looks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sign {
    /// As a piece of its line.
    Line(Line),
    /// As a circle of its line.
    Ring(Line),
    /// As a filled dot.
    Dot(Fill),
}

/// Of the letters, pixels.
const SIZE: f64 = 12.5;
/// Of a sign, and from it to its label, pixels.
const SIGN: f64 = 22.0;
const GAP: f64 = 6.0;

impl Entry {
    /// A curve.
    #[must_use]
    pub fn line(label: impl Into<String>, line: Line) -> Self {
        Self { label: label.into(), sign: Sign::Line(line) }
    }

    /// With its sign and the room to the next, pixels.
    #[must_use]
    pub fn width(&self) -> f64 {
        SIGN + GAP + text_width(&self.label, SIZE) + 14.0
    }

    /// Draws it from `at`, on the line under its letters.
    pub fn draw(&self, sheet: &mut Drawing, at: Point) {
        let [x, y] = [at[0], at[1] - 0.34 * SIZE];
        match self.sign {
            Sign::Line(line) => sheet.line([[x, y], [x + SIGN, y]], line),
            Sign::Ring(line) => sheet.circle([x + 0.5 * SIGN, y], 6.0, None, Some(line)),
            Sign::Dot(fill) => sheet.circle([x + 0.5 * SIGN, y], 3.5, Some(fill), None),
        }
        sheet.text([x + SIGN + GAP, at[1]], Anchor::Start, SIZE, Ink::Text, self.label.clone());
    }
}

/// Entries one under another, from the line under the first one's letters.
pub fn legend(sheet: &mut Drawing, at: Point, entries: &[Entry]) {
    let mut y = at[1];
    for entry in entries {
        entry.draw(sheet, [at[0], y]);
        y += 1.7 * SIZE;
    }
}
