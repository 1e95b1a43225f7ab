use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::panel::{Drawn, FONT};

/// Of a line, and of a swatch, pixels.
const LINE: i32 = 30;
const SWATCH: i32 = 30;

/// What stands for a curve, a mark or a line.
pub struct Entry {
    pub label: String,
    pub mark: Mark,
}

/// How it looks.
pub enum Mark {
    Line(ShapeStyle),
    Dashed(ShapeStyle),
    Ring(ShapeStyle),
}

/// Entries one under another, beside the axes so that no curve is hidden.
pub fn draw<B: DrawingBackend>(area: &DrawingArea<B, Shift>, entries: &[Entry]) -> Drawn<B> {
    let text = (FONT, 17).into_text_style(area).pos(Pos::new(HPos::Left, VPos::Center));
    let mut y = 76;
    for Entry { label, mark } in entries {
        match mark {
            Mark::Line(style) => area.draw(&PathElement::new([(0, y), (SWATCH, y)], *style))?,
            Mark::Dashed(style) => {
                for start in (0..SWATCH).step_by(11) {
                    area.draw(&PathElement::new([(start, y), (start + 6, y)], *style))?;
                }
            }
            Mark::Ring(style) => area.draw(&Circle::new((SWATCH / 2, y), 9, *style))?,
        }
        area.draw(&Text::new(label.clone(), (SWATCH + 12, y), text.clone()))?;
        y += LINE;
    }
    Ok(())
}
