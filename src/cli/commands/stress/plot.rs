use super::execute::Matrix;
use crate::plot::{Anchor, Drawing, Fill, Ink, Line, Rectangle};
use crate::study::{Cell, Depth, Verdict};

/// Of a cell, pixels.
const CELL: (f64, f64) = (34.0, 20.0);
/// Where the first cell is, pixels.
const CORNER: (f64, f64) = (330.0, 196.0);
const GAP: Line = Line::new(Ink::Paper, 1.0);

/// Cases down, methods across: the greener, the more digits are right.
pub fn draw(matrix: &Matrix) -> Drawing {
    let (columns, rows) = (place(matrix.methods.len()), place(matrix.rows.len()));
    let (width, height) = (CORNER.0 + columns * CELL.0 + 24.0, CORNER.1 + rows * CELL.1 + 76.0);
    let mut sheet = Drawing::new(width, height);
    let depth = if matrix.depth == Depth::Quick { "quick" } else { "full" };
    sheet.text([16.0, 30.0], Anchor::Start, 17.0, Ink::Text, "What each method makes of hard motions");
    let words = format!("polhode stress --{depth}: right digits of the attitude at the finest setting");
    sheet.text([16.0, 50.0], Anchor::Start, 12.0, Ink::Faint, words);
    for (number, method) in matrix.methods.iter().enumerate() {
        let x = CORNER.0 + (place(number) + 0.62) * CELL.0;
        sheet.upright_text([x, CORNER.1 - 8.0], Anchor::Start, 12.0, Ink::Text, method.key());
    }
    for (number, row) in matrix.rows.iter().enumerate() {
        let top = CORNER.1 + place(number) * CELL.1;
        sheet.text([CORNER.0 - 8.0, top + 14.5], Anchor::End, 12.0, Ink::Text, row.case.title);
        for (number, cell) in row.cells.iter().enumerate() {
            draw_cell(&mut sheet, [CORNER.0 + place(number) * CELL.0, top], cell);
        }
    }
    let below = CORNER.1 + rows * CELL.1 + 24.0;
    let words = [
        "= within its limit   ~ follows the motion   c chaotic   x loses the motion   !! must never be given",
        "– refused before the run, with a reason   . would take too many steps   ? nothing to measure it by",
    ];
    for (line, top) in words.into_iter().zip([below, below + 18.0]) {
        sheet.text([16.0, top], Anchor::Start, 12.0, Ink::Faint, line);
    }
    sheet
}

fn draw_cell(sheet: &mut Drawing, [left, top]: [f64; 2], cell: &Cell) {
    let of = Rectangle { left, top, width: CELL.0, height: CELL.1 };
    let ink = Ink::Given(colour(cell));
    sheet.rectangle(of, Some(Fill::new(ink)), Some(GAP));
    let at = [left + 0.5 * CELL.0, top + 14.5];
    sheet.text(at, Anchor::Middle, 11.0, Ink::Given([20, 24, 28]), cell.sign());
}

/// From red over yellow to green by digits; grey where nothing was run.
fn colour(cell: &Cell) -> [u8; 3] {
    match cell.verdict {
        Verdict::Refused | Verdict::TooLong | Verdict::Unjudged => [222, 224, 226],
        Verdict::Wrong => [255, 40, 90],
        Verdict::Lost => [222, 122, 100],
        Verdict::Chaotic => [206, 190, 230],
        Verdict::Kept => [96, 190, 130],
        Verdict::Coarse => {
            let error = cell.best().map_or(1.0, |trial| trial.error_rad);
            let part = (-libm::log10(error.max(1e-16)) / 15.0).clamp(0.0, 1.0);
            let from_to = [(240.0, 200.0), (190.0, 226.0), (110.0, 140.0)];
            from_to.map(|(from, to)| byte(from + part * (to - from)))
        }
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within 0 to 255")]
fn byte(value: f64) -> u8 {
    value.round() as u8
}

#[expect(clippy::cast_precision_loss, reason = "a few dozen")]
fn place(number: usize) -> f64 {
    number as f64
}
