use super::drawing::{Anchor, Drawing, Ink};
use super::font::text_width;

/// Of a title, pixels.
const TITLE: f64 = 20.0;
/// Of the words under a title, pixels.
const WORDS: f64 = 13.0;
/// Around everything, pixels.
const MARGIN: f64 = 16.0;

/// Panels from left to right and from above, so many in a row, each row as high as its highest, under a title and lines
/// of words.
#[must_use]
pub fn grid(title: &str, words: &[String], panels: Vec<Drawing>, columns: usize) -> Drawing {
    let columns = columns.max(1);
    let widths: Vec<f64> = (0..columns.min(panels.len()))
        .map(|column| panels.iter().skip(column).step_by(columns).map(|panel| panel.width).fold(0.0, f64::max))
        .collect();
    let least = text_width(title, TITLE).max(words.iter().map(|line| text_width(line, WORDS)).fold(0.0, f64::max));
    let mut sheet = Drawing::new(2.0 * MARGIN + widths.iter().sum::<f64>().max(least), 0.0);
    let mut y = MARGIN;
    if !title.is_empty() {
        sheet.text([MARGIN, y + TITLE], Anchor::Start, TITLE, Ink::Text, title);
        y += 1.5 * TITLE;
    }
    for line in words {
        sheet.text([MARGIN, y + WORDS], Anchor::Start, WORDS, Ink::Faint, line.clone());
        y += 1.5 * WORDS;
    }
    if y > MARGIN {
        y += 10.0;
    }
    let mut rest = panels.into_iter();
    loop {
        let row: Vec<Drawing> = rest.by_ref().take(columns).collect();
        if row.is_empty() {
            break;
        }
        let height = row.iter().map(|panel| panel.height).fold(0.0, f64::max);
        let mut x = MARGIN;
        for (panel, width) in row.into_iter().zip(&widths) {
            sheet.place([x, y], panel);
            x += width;
        }
        y += height;
    }
    sheet.height = y + MARGIN;
    sheet
}
