/// x to the right, y downwards, pixels.
pub type Point = [f64; 2];

/// Lines, areas and words on a sheet, in the order in which they are laid on it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Drawing {
    /// Of the sheet, pixels.
    pub width: f64,
    /// Of the sheet, pixels.
    pub height: f64,
    /// What is on it.
    pub shapes: Vec<Shape>,
}

/// One thing on a sheet.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// Straight pieces from point to point.
    Path {
        /// The corners of each stroke of the pen.
        strokes: Vec<Vec<Point>>,
        /// Whether each ends where it began.
        is_closed: bool,
        /// How it is drawn, if it is.
        line: Option<Line>,
        /// How it is filled, if it is.
        fill: Option<Fill>,
    },
    /// A circle.
    Circle {
        /// Its centre.
        centre: Point,
        /// Its radius.
        radius: f64,
        /// How it is drawn, if it is.
        line: Option<Line>,
        /// How it is filled, if it is.
        fill: Option<Fill>,
    },
    /// Words on one line.
    Text {
        /// Where they stand, on the line under the letters.
        at: Point,
        /// What of them stands there.
        anchor: Anchor,
        /// Of the letters: their em, pixels.
        size: f64,
        /// Their colour.
        ink: Ink,
        /// Whether they are read from below upwards.
        is_upright: bool,
        /// The words.
        text: String,
    },
}

/// A colour by what it is for: a page may be light or dark.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ink {
    /// Of the sheet.
    Paper,
    /// Of titles and curves without a name.
    Text,
    /// Of axes and lesser words.
    Faint,
    /// Of the lines behind the curves.
    Grid,
    /// Of the n-th curve: the colours of Okabe and Ito, which the colour-blind tell apart, over and over.
    Series(usize),
    /// Red, green and blue, whatever the sheet.
    Given([u8; 3]),
}

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Its colour.
    pub ink: Ink,
    /// Pixels.
    pub width: f64,
    /// 0 to 1.
    pub opacity: f64,
    /// Whether it has gaps.
    pub dash: Dash,
}

/// How an area is filled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fill {
    /// Its colour.
    pub ink: Ink,
    /// 0 to 1.
    pub opacity: f64,
}

/// Gaps of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dash {
    /// None.
    Solid,
    /// Longer pieces.
    Dashed,
    /// Short pieces.
    Dotted,
}

/// What of some words stands at their place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// Where they begin.
    Start,
    /// Their middle.
    Middle,
    /// Where they end.
    End,
}

/// A part of a sheet, pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    /// Of its left side.
    pub left: f64,
    /// Of its upper side.
    pub top: f64,
    /// From left to right.
    pub width: f64,
    /// From top to bottom.
    pub height: f64,
}

impl Rectangle {
    /// Of its right side.
    #[must_use]
    pub fn right(&self) -> f64 {
        self.left + self.width
    }

    /// Of its lower side.
    #[must_use]
    pub fn bottom(&self) -> f64 {
        self.top + self.height
    }
}

impl Line {
    /// Without gaps.
    #[must_use]
    pub const fn new(ink: Ink, width: f64) -> Self {
        Self { ink, width, opacity: 1.0, dash: Dash::Solid }
    }

    /// The same, seen through.
    #[must_use]
    pub const fn faded(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }

    /// The same with gaps.
    #[must_use]
    pub const fn dashed(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }
}

impl Fill {
    /// That hides what is behind it.
    #[must_use]
    pub const fn new(ink: Ink) -> Self {
        Self { ink, opacity: 1.0 }
    }
}

impl Drawing {
    /// An empty sheet.
    #[must_use]
    pub const fn new(width: f64, height: f64) -> Self {
        Self { width, height, shapes: Vec::new() }
    }

    /// Straight pieces from point to point.
    pub fn line(&mut self, points: impl Into<Vec<Point>>, line: Line) {
        self.strokes(vec![points.into()], line);
    }

    /// Several of them that look alike.
    pub fn strokes(&mut self, mut strokes: Vec<Vec<Point>>, line: Line) {
        strokes.retain(|stroke| stroke.len() > 1);
        if !strokes.is_empty() {
            self.shapes.push(Shape::Path { strokes, is_closed: false, line: Some(line), fill: None });
        }
    }

    /// A closed area.
    pub fn area(&mut self, points: impl Into<Vec<Point>>, fill: Option<Fill>, line: Option<Line>) {
        self.shapes.push(Shape::Path { strokes: vec![points.into()], is_closed: true, line, fill });
    }

    /// A rectangle.
    pub fn rectangle(&mut self, of: Rectangle, fill: Option<Fill>, line: Option<Line>) {
        let Rectangle { left, top, .. } = of;
        self.area([[left, top], [of.right(), top], [of.right(), of.bottom()], [left, of.bottom()]], fill, line);
    }

    /// A circle.
    pub fn circle(&mut self, centre: Point, radius: f64, fill: Option<Fill>, line: Option<Line>) {
        self.shapes.push(Shape::Circle { centre, radius, line, fill });
    }

    /// Words on one line, on the line under the letters.
    pub fn text(&mut self, at: Point, anchor: Anchor, size: f64, ink: Ink, text: impl Into<String>) {
        self.shapes.push(Shape::Text { at, anchor, size, ink, is_upright: false, text: text.into() });
    }

    /// The same, read from below upwards.
    pub fn upright_text(&mut self, at: Point, anchor: Anchor, size: f64, ink: Ink, text: impl Into<String>) {
        self.shapes.push(Shape::Text { at, anchor, size, ink, is_upright: true, text: text.into() });
    }

    /// Lays another sheet on this one, its upper left corner at `at`.
    pub fn place(&mut self, at: Point, other: Self) {
        let moved = |[x, y]: Point| [x + at[0], y + at[1]];
        self.shapes.extend(other.shapes.into_iter().map(|shape| match shape {
            Shape::Path { mut strokes, is_closed, line, fill } => {
                strokes.iter_mut().flatten().for_each(|point| *point = moved(*point));
                Shape::Path { strokes, is_closed, line, fill }
            }
            Shape::Circle { centre, radius, line, fill } => Shape::Circle { centre: moved(centre), radius, line, fill },
            Shape::Text { at, anchor, size, ink, is_upright, text } => {
                Shape::Text { at: moved(at), anchor, size, ink, is_upright, text }
            }
        }));
    }
}
