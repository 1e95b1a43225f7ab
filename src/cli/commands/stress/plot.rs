use super::execute::Matrix;
use crate::plot::{Anchor, Drawing, Fill, Ink, Line, Point, Rectangle};
use crate::study::{Cell, Depth, Verdict};

/// Of a cell, pixels.
const CELL: (f64, f64) = (34.0, 20.0);
/// Where the methods end and the cases begin, pixels.
const CORNER: (f64, f64) = (330.0, 176.0);
/// Between the upper edges of a group's title and of its first case, pixels.
const TITLE: f64 = 26.0;
const GAP: Line = Line::new(Ink::Paper, 1.0);
/// On every colour of a cell but that of [`Verdict::Wrong`].
const DARK: Ink = Ink::Given([20, 24, 28]);
/// On that.
const BRIGHT: Ink = Ink::Given([255; 3]);
const NOTHING: [u8; 3] = [232, 234, 236];
const LOST: [u8; 3] = [240, 152, 84];
const CHAOTIC: [u8; 3] = [204, 184, 232];
const WRONG: [u8; 3] = [24, 24, 28];
/// Of the attitude: from none to all.
const MOST_DIGITS: f64 = 16.0;

/// Cases down, methods across: the bluer, the more digits are right. Blue and orange are told apart by the colour-blind,
/// and every cell says in signs what it says in colour.
pub fn draw(matrix: &Matrix) -> Drawing {
    let columns = place(matrix.methods.len());
    let groups: Vec<_> = matrix.rows.chunk_by(|a, b| a.case.group == b.case.group).collect();
    let body = place(groups.len()) * TITLE + place(matrix.rows.len()) * CELL.1;
    let width = (CORNER.0 + columns * CELL.0 + 24.0).max(620.0);
    let mut sheet = Drawing::new(width, CORNER.1 + body + 136.0);
    let depth = if matrix.depth == Depth::Quick { "quick" } else { "full" };
    sheet.text([16.0, 30.0], Anchor::Start, 17.0, Ink::Text, "What each method makes of hard motions");
    let words = format!("polhode stress --{depth}: right digits of the attitude at the best of the settings");
    sheet.text([16.0, 50.0], Anchor::Start, 12.0, Ink::Faint, words);
    for (number, method) in matrix.methods.iter().enumerate() {
        let x = CORNER.0 + (place(number) + 0.62) * CELL.0;
        sheet.upright_text([x, CORNER.1 - 4.0], Anchor::Start, 12.0, Ink::Text, method.key());
    }
    let mut top = CORNER.1;
    for rows in groups {
        let title = rows.first().map_or("", |row| row.case.group);
        sheet.text([CORNER.0 - 8.0, top + TITLE - 7.0], Anchor::End, 12.0, Ink::Faint, title.to_uppercase());
        top += TITLE;
        for row in rows {
            sheet.text([CORNER.0 - 8.0, top + 14.5], Anchor::End, 12.0, Ink::Text, row.case.title);
            for (number, cell) in row.cells.iter().enumerate() {
                let ink = if cell.verdict == Verdict::Wrong { BRIGHT } else { DARK };
                swatch(&mut sheet, [CORNER.0 + place(number) * CELL.0, top], colour(cell), ink, cell.sign());
            }
            top += CELL.1;
        }
    }
    legend(&mut sheet, top + 22.0);
    sheet
}

fn legend(sheet: &mut Drawing, top: f64) {
    let mut left = 16.0;
    for digits in (0..=16).step_by(2) {
        swatch(sheet, [left, top], blue(f64::from(digits)), DARK, digits.to_string());
        left += CELL.0;
    }
    sheet.text([left + 8.0, top + 14.5], Anchor::Start, 12.0, Ink::Text, "right digits: −log₁₀ of the error in rad");
    let words = "= within its limit        ~ follows the motion, less exactly than f64 allows";
    sheet.text([16.0, top + 42.0], Anchor::Start, 12.0, Ink::Text, words);
    let swatches = [
        (LOST, "x", "loses the motion", 150.0),
        (CHAOTIC, "c", "chaotic", 96.0),
        (WRONG, "!!", "must never be given", 0.0),
    ];
    let mut left = 16.0;
    for (colour, sign, words, width) in swatches {
        let ink = if colour == WRONG { BRIGHT } else { DARK };
        swatch(sheet, [left, top + 54.0], colour, ink, sign.to_owned());
        sheet.text([left + CELL.0 + 6.0, top + 68.5], Anchor::Start, 12.0, Ink::Text, words);
        left += CELL.0 + width;
    }
    let mut left = 16.0;
    let greys = [
        ("–", "refused before the run", 150.0),
        (".", "too many steps", 118.0),
        ("?", "nothing to measure it by", 0.0),
    ];
    for (sign, words, width) in greys {
        swatch(sheet, [left, top + 80.0], NOTHING, DARK, sign.to_owned());
        sheet.text([left + CELL.0 + 6.0, top + 94.5], Anchor::Start, 12.0, Ink::Text, words);
        left += CELL.0 + width;
    }
}

fn swatch(sheet: &mut Drawing, [left, top]: Point, colour: [u8; 3], ink: Ink, sign: String) {
    let of = Rectangle { left, top, width: CELL.0, height: CELL.1 };
    sheet.rectangle(of, Some(Fill::new(Ink::Given(colour))), Some(GAP));
    sheet.text([left + 0.5 * CELL.0, top + 14.5], Anchor::Middle, 11.0, ink, sign);
}

fn colour(cell: &Cell) -> [u8; 3] {
    match cell.verdict {
        Verdict::Refused | Verdict::TooLong | Verdict::Unjudged => NOTHING,
        Verdict::Wrong => WRONG,
        Verdict::Lost => LOST,
        Verdict::Chaotic => CHAOTIC,
        Verdict::Kept | Verdict::Coarse => blue(f64::from(cell.digits())),
    }
}

/// From a pale yellow over white to blue: a scale in lightness too, so that it reads in grey.
fn blue(digits: f64) -> [u8; 3] {
    let part = (digits / MOST_DIGITS).clamp(0.0, 1.0);
    [(255.0, 92.0), (246.0, 164.0), (214.0, 230.0)].map(|(from, to)| byte(from + part * (to - from)))
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within 0 to 255")]
fn byte(value: f64) -> u8 {
    value.round() as u8
}

#[expect(clippy::cast_precision_loss, reason = "a few dozen")]
fn place(number: usize) -> f64 {
    number as f64
}
