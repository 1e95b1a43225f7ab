use std::sync::OnceLock;

use ab_glyph::{Font, FontRef, OutlineCurve};

use super::Point;

/// `DejaVu` Sans: Latin, Greek, superscripts. No system needs to have a font.
pub const FILE: &[u8] = include_bytes!("fonts/DejaVuSans-subset.ttf");
/// As style sheets name it, and what has the same letters or nearly so.
pub const FAMILY: &str = "'DejaVu Sans',Verdana,sans-serif";
/// In the place of letters that the font does not have.
const ABSENT: char = '?';

fn font() -> Option<&'static FontRef<'static>> {
    static FONT: OnceLock<Option<FontRef<'static>>> = OnceLock::new();
    // Tests read it, so that it is there.
    FONT.get_or_init(|| FontRef::try_from_slice(FILE).ok()).as_ref()
}

/// Whether every letter of `text` is in the font.
#[cfg(test)]
pub fn covers(text: &str) -> bool {
    font().is_some_and(|font| text.chars().all(|letter| font.glyph_id(letter).0 != 0))
}

/// How far `text` reaches, pixels, in letters of an em of `size` pixels.
#[must_use]
pub fn text_width(text: &str, size: f64) -> f64 {
    let Some(font) = font() else { return 0.0 };
    let scale = scale(font, size);
    glyphs(font, text).map(|glyph| f64::from(font.h_advance_unscaled(glyph)) * scale).sum()
}

/// The outlines of `text` from the origin, y downwards, as curves for `pen`.
pub fn outline(text: &str, size: f64, pen: &mut impl FnMut(Curve)) {
    let Some(font) = font() else { return };
    let scale = scale(font, size);
    let mut start = 0.0;
    for glyph in glyphs(font, text) {
        let place = |point: ab_glyph::Point| [start + f64::from(point.x) * scale, -f64::from(point.y) * scale];
        for curve in font.outline(glyph).into_iter().flat_map(|outline| outline.curves) {
            pen(match curve {
                OutlineCurve::Line(a, b) => Curve { from: place(a), by: Vec::new(), to: place(b) },
                OutlineCurve::Quad(a, b, c) => Curve { from: place(a), by: vec![place(b)], to: place(c) },
                OutlineCurve::Cubic(a, b, c, d) => Curve { from: place(a), by: vec![place(b), place(c)], to: place(d) },
            });
        }
        start += f64::from(font.h_advance_unscaled(glyph)) * scale;
    }
}

/// A piece of an outline: Bézier's curve with as many control points.
pub struct Curve {
    pub from: Point,
    pub by: Vec<Point>,
    pub to: Point,
}

fn scale(font: &FontRef<'_>, size: f64) -> f64 {
    size / f64::from(font.units_per_em().unwrap_or(2048.0))
}

fn glyphs<'a>(font: &'a FontRef<'_>, text: &'a str) -> impl Iterator<Item = ab_glyph::GlyphId> + 'a {
    text.chars().map(|letter| match font.glyph_id(letter) {
        ab_glyph::GlyphId(0) => font.glyph_id(ABSENT),
        known => known,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::telemetry::Channel;

    #[test]
    fn the_font_has_every_letter_of_titles_and_units() {
        for row in Channel::ALL.map(Channel::row) {
            assert!(covers(row.title) && covers(row.unit), "{row:?}");
        }
        assert!(covers("10⁻¹⁵ ωLτF|·±≤×−²³√≈°"));
    }

    #[test]
    fn words_are_as_wide_as_their_letters() {
        assert!((text_width("00", 10.0) - 2.0 * text_width("0", 10.0)).abs() < 1e-12);
        // An en of digits is 1303 of 2048 units of DejaVu Sans.
        assert!((text_width("0", 2048.0) - 1303.0).abs() < 1e-9);
        assert_eq!(text_width("漢", 10.0), text_width("?", 10.0), "a letter that is not there");
    }
}
