use std::fmt::Write;

use super::drawing::{Anchor, Dash, Drawing, Fill, Ink, Line, Point, Shape};
use super::font::{FAMILY, text_width};

/// Where a drawing stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Surroundings {
    /// On white paper of its own: a file.
    Paper,
    /// In a page that gives the colours, as the style sheet's variables `--paper`, `--text`, `--faint`, `--grid` and
    /// `--series-0` to `--series-6`.
    Page,
}

/// Okabe and Ito's colours, strongest first. `[OkabeIto08]`
pub const SERIES: [[u8; 3]; 7] =
    [[0, 114, 178], [213, 94, 0], [0, 158, 115], [204, 121, 167], [230, 159, 0], [86, 180, 233], [80, 80, 80]];

impl Ink {
    /// Red, green and blue on white paper.
    #[must_use]
    pub const fn on_paper(self) -> [u8; 3] {
        match self {
            Self::Paper => [255, 255, 255],
            Self::Text => [26, 26, 26],
            Self::Faint => [95, 95, 95],
            Self::Grid => [228, 228, 228],
            Self::Series(index) => SERIES[index % SERIES.len()],
            Self::Given(colour) => colour,
        }
    }

    fn css(self, surroundings: Surroundings) -> String {
        let [red, green, blue] = self.on_paper();
        let colour = format!("#{red:02x}{green:02x}{blue:02x}");
        let variable = match self {
            _ if surroundings == Surroundings::Paper => return colour,
            Self::Paper => "paper".to_owned(),
            Self::Text => "text".to_owned(),
            Self::Faint => "faint".to_owned(),
            Self::Grid => "grid".to_owned(),
            Self::Series(index) => format!("series-{}", index % SERIES.len()),
            Self::Given(_) => return colour,
        };
        format!("var(--{variable},{colour})")
    }
}

impl Dash {
    /// Lengths of pieces and gaps in widths of the line; empty without gaps.
    #[must_use]
    pub const fn pattern(self) -> &'static [f64] {
        match self {
            Self::Solid => &[],
            Self::Dashed => &[5.0, 4.0],
            Self::Dotted => &[1.5, 2.5],
        }
    }
}

impl Drawing {
    /// As an SVG element, which is a whole file too. Words keep the width that they have in the font that the program
    /// carries, whichever a browser finds.
    #[must_use]
    pub fn svg(&self, surroundings: Surroundings) -> String {
        let (width, height) = (number(self.width), number(self.height));
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
             height=\"{height}\" font-family=\"{FAMILY}\" stroke-linejoin=\"round\">\n"
        );
        if surroundings == Surroundings::Paper {
            let _ = writeln!(svg, "<rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>");
        }
        for shape in &self.shapes {
            add(&mut svg, shape, surroundings);
        }
        svg.push_str("</svg>\n");
        svg
    }
}

// Text goes into a string, which takes all there is: what `write!` returns says nothing.
fn add(svg: &mut String, shape: &Shape, surroundings: Surroundings) {
    match shape {
        Shape::Path { strokes, is_closed, line, fill } => {
            svg.push_str("<path d=\"");
            for stroke in strokes {
                path(svg, stroke);
                if *is_closed {
                    svg.push('z');
                }
            }
            svg.push('"');
            style(svg, line.as_ref(), fill.as_ref(), surroundings);
            svg.push_str("/>\n");
        }
        Shape::Circle { centre: [x, y], radius, line, fill } => {
            let _ = write!(svg, "<circle cx=\"{}\" cy=\"{}\" r=\"{}\"", number(*x), number(*y), number(*radius));
            style(svg, line.as_ref(), fill.as_ref(), surroundings);
            svg.push_str("/>\n");
        }
        Shape::Text { at: [x, y], anchor, size, ink, is_upright, text } => {
            let (x, y) = (number(*x), number(*y));
            let place = if *is_upright {
                format!("transform=\"translate({x} {y}) rotate(-90)\"")
            } else {
                format!("x=\"{x}\" y=\"{y}\"")
            };
            let anchor = match anchor {
                Anchor::Start => "",
                Anchor::Middle => " text-anchor=\"middle\"",
                Anchor::End => " text-anchor=\"end\"",
            };
            let (length, size, ink) = (number(text_width(text, *size)), number(*size), ink.css(surroundings));
            let _ = writeln!(
                svg,
                "<text {place}{anchor} font-size=\"{size}\" fill=\"{ink}\" textLength=\"{length}\" \
                 lengthAdjust=\"spacingAndGlyphs\">{}</text>",
                escaped(text)
            );
        }
    }
}

fn path(svg: &mut String, stroke: &[Point]) {
    for (index, [x, y]) in stroke.iter().enumerate() {
        let letter = match index {
            0 => "M",
            1 => "L",
            _ => " ",
        };
        let _ = write!(svg, "{letter}{} {}", number(*x), number(*y));
    }
}

fn style(svg: &mut String, line: Option<&Line>, fill: Option<&Fill>, surroundings: Surroundings) {
    match fill {
        None => svg.push_str(" fill=\"none\""),
        Some(Fill { ink, opacity }) => {
            let _ = write!(svg, " fill=\"{}\"", ink.css(surroundings));
            if *opacity < 1.0 {
                let _ = write!(svg, " fill-opacity=\"{}\"", number(*opacity));
            }
        }
    }
    if let Some(Line { ink, width, opacity, dash }) = line {
        let _ = write!(svg, " stroke=\"{}\" stroke-width=\"{}\"", ink.css(surroundings), number(*width));
        if *opacity < 1.0 {
            let _ = write!(svg, " stroke-opacity=\"{}\"", number(*opacity));
        }
        let lengths: Vec<_> = dash.pattern().iter().map(|length| number(length * width)).collect();
        if !lengths.is_empty() {
            let _ = write!(svg, " stroke-dasharray=\"{}\"", lengths.join(" "));
        }
    }
}

/// With two places at most, which is finer than any screen.
fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

/// As text in XML and HTML: no letter of it is markup, and none is there that XML forbids.
#[must_use]
pub fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            '\n' | '\t' => safe.push(letter),
            letter if letter.is_control() || matches!(letter, '\u{fffe}' | '\u{ffff}') => safe.push('\u{fffd}'),
            letter => safe.push(letter),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let shown = [1.0, -0.001, 0.126, 100.0, -3.5].map(number);
        assert_eq!(shown, ["1", "0", "0.13", "100", "-3.5"]);
    }

    #[test]
    fn no_letter_of_a_text_is_markup() {
        assert_eq!(escaped("<a href=\"x\">&'\u{1b}"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;\u{fffd}");
    }
}
