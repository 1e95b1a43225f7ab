use super::clip::clipped;
use super::drawing::{Anchor, Drawing, Ink, Line, Point, Rectangle};
use super::scale::Scale;
use super::simplify::simplified;

/// Two scales in a frame on a sheet: values to the right and upwards.
#[derive(Debug, Clone, PartialEq)]
pub struct Axes {
    /// The frame.
    pub frame: Rectangle,
    /// From left to right.
    pub across: Scale,
    /// From below upwards.
    pub up: Scale,
}

/// Of the numbers at ticks, pixels.
const NUMBERS: f64 = 12.0;
/// Of the words along axes, pixels.
const WORDS: f64 = 13.0;
/// A curve may be so far from its points, pixels.
const HAIR: f64 = 0.05;

impl Axes {
    /// Where a pair of values is.
    #[must_use]
    pub fn place(&self, [x, y]: [f64; 2]) -> Point {
        let Rectangle { left, width, height, .. } = self.frame;
        [left + width * self.across.fraction(x), self.frame.bottom() - height * self.up.fraction(y)]
    }

    /// Grid, frame, ticks with numbers, and the words along both axes; empty words take no room.
    pub fn draw(&self, sheet: &mut Drawing, across: &str, up: &str) {
        let Rectangle { left, top, width, height } = self.frame;
        let (right, bottom) = (self.frame.right(), self.frame.bottom());
        let at_x = |value| left + width * self.across.fraction(value);
        let at_y = |value| bottom - height * self.up.fraction(value);
        let grid: Vec<Vec<Point>> = (self.across.ticks.iter())
            .map(|tick| vec![[at_x(tick.value), top], [at_x(tick.value), bottom]])
            .chain(self.up.ticks.iter().map(|tick| vec![[left, at_y(tick.value)], [right, at_y(tick.value)]]))
            .collect();
        sheet.strokes(grid, Line::new(Ink::Grid, 1.0));
        let minor: Vec<Vec<Point>> = (self.across.minor_ticks.iter())
            .map(|value| vec![[at_x(*value), bottom], [at_x(*value), bottom - 4.0]])
            .chain(self.up.minor_ticks.iter().map(|value| vec![[left, at_y(*value)], [left + 4.0, at_y(*value)]]))
            .collect();
        sheet.strokes(minor, Line::new(Ink::Faint, 0.8));
        sheet.line([[left, top], [left, bottom], [right, bottom]], Line::new(Ink::Faint, 1.0));
        for tick in &self.across.ticks {
            let at = [at_x(tick.value), bottom + 16.0];
            sheet.text(at, Anchor::Middle, NUMBERS, Ink::Faint, tick.label.clone());
        }
        for tick in &self.up.ticks {
            let at = [left - 7.0, at_y(tick.value) + 0.36 * NUMBERS];
            sheet.text(at, Anchor::End, NUMBERS, Ink::Faint, tick.label.clone());
        }
        if !across.is_empty() {
            sheet.text([left + 0.5 * width, bottom + 36.0], Anchor::Middle, WORDS, Ink::Text, across);
        }
        if !up.is_empty() {
            sheet.upright_text([left - 50.0, top + 0.5 * height], Anchor::Middle, WORDS, Ink::Text, up);
        }
    }

    /// A curve through pairs of values, as far as it is within the frame; broken where one is no number.
    pub fn curve(&self, sheet: &mut Drawing, values: impl Iterator<Item = [f64; 2]>, line: Line) {
        let strokes = clipped(values.map(|pair| self.place(pair)), &self.frame);
        sheet.strokes(strokes.iter().map(|stroke| simplified(stroke, HAIR)).collect(), line);
    }

    /// A line from one side of the frame to the other at a value, if it is within.
    pub fn level(&self, sheet: &mut Drawing, value: f64, line: Line) {
        self.curve(sheet, [[self.across.from, value], [self.across.to, value]].into_iter(), line);
    }

    /// A line from top to bottom at a value, if it is within.
    pub fn mark(&self, sheet: &mut Drawing, value: f64, line: Line) {
        self.curve(sheet, [[value, self.up.from], [value, self.up.to]].into_iter(), line);
    }
}
