use tiny_skia::{Color, FillRule, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform};

use super::drawing::{Anchor, Drawing, Fill, Ink, Line, Point, Shape};
use super::font::{outline, text_width};
use super::format::PlotError;

/// Pixels of a picture to one of the drawing: sharp on fine screens and in print.
pub const PIXELS: f32 = 2.0;
/// Pixels of a side at most: a gigabyte, and not more.
const LARGEST: f64 = 16_384.0;

impl Drawing {
    /// As a PNG of two pixels to one of the drawing, on white.
    ///
    /// # Errors
    /// If it has no area or a side of more than 16384 pixels.
    pub fn png(&self) -> Result<Vec<u8>, PlotError> {
        let [width, height] = [self.width, self.height].map(|side| (side * f64::from(PIXELS)).ceil());
        let sides = [width, height].map(|side| (1.0..=LARGEST).contains(&side).then(|| whole(side)));
        let [Some(across), Some(down)] = sides else { return Err(PlotError::Size { width, height }) };
        let mut sheet = Pixmap::new(across, down).ok_or(PlotError::Size { width, height })?;
        sheet.fill(Color::WHITE);
        for shape in &self.shapes {
            add(&mut sheet, shape);
        }
        sheet.encode_png().map_err(|error| PlotError::Png(error.to_string()))
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within 1 to 16384")]
const fn whole(side: f64) -> u32 {
    side as u32
}

#[expect(clippy::cast_possible_truncation, reason = "places on a sheet, to a fraction of a pixel")]
const fn single(value: f64) -> f32 {
    value as f32
}

fn add(sheet: &mut Pixmap, shape: &Shape) {
    match shape {
        Shape::Path { strokes, is_closed, line, fill } => {
            lay(sheet, path(strokes, *is_closed), line.as_ref(), fill.as_ref(), Transform::identity());
        }
        Shape::Circle { centre: [x, y], radius, line, fill } => {
            let path = PathBuilder::from_circle(single(*x), single(*y), single(*radius));
            lay(sheet, path, line.as_ref(), fill.as_ref(), Transform::identity());
        }
        Shape::Text { at: [x, y], anchor, size, ink, is_upright, text } => {
            let back = match anchor {
                Anchor::Start => 0.0,
                Anchor::Middle => 0.5,
                Anchor::End => 1.0,
            } * text_width(text, *size);
            // A quarter of a turn without the roundings of sines.
            let turn = if *is_upright {
                Transform::from_row(0.0, -1.0, 1.0, 0.0, single(*x), single(y + back))
            } else {
                Transform::from_translate(single(x - back), single(*y))
            };
            lay(sheet, letters(text, *size), None, Some(&Fill::new(*ink)), turn);
        }
    }
}

fn lay(sheet: &mut Pixmap, path: Option<Path>, line: Option<&Line>, fill: Option<&Fill>, turn: Transform) {
    let Some(path) = path else { return };
    let turn = turn.post_scale(PIXELS, PIXELS);
    if let Some(Fill { ink, opacity }) = fill {
        sheet.fill_path(&path, &paint(*ink, *opacity), FillRule::Winding, turn, None);
    }
    if let Some(Line { ink, width, opacity, dash }) = line {
        let lengths = dash.pattern().iter().map(|length| single(length * width)).collect();
        let dash = StrokeDash::new(lengths, 0.0);
        let stroke = Stroke { width: single(*width), line_join: LineJoin::Round, dash, ..Stroke::default() };
        sheet.stroke_path(&path, &paint(*ink, *opacity), &stroke, turn, None);
    }
}

fn paint(ink: Ink, opacity: f64) -> Paint<'static> {
    let [red, green, blue] = ink.on_paper().map(|part| f32::from(part) / 255.0);
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    // Always a colour: opacities are within 0 and 1.
    if let Some(colour) = Color::from_rgba(red, green, blue, single(opacity.clamp(0.0, 1.0))) {
        paint.set_color(colour);
    }
    paint
}

fn path(strokes: &[Vec<Point>], is_closed: bool) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for stroke in strokes {
        for (index, [x, y]) in stroke.iter().enumerate() {
            if index == 0 {
                builder.move_to(single(*x), single(*y));
            } else {
                builder.line_to(single(*x), single(*y));
            }
        }
        if is_closed {
            builder.close();
        }
    }
    builder.finish()
}

fn letters(text: &str, size: f64) -> Option<Path> {
    let mut builder = PathBuilder::new();
    let mut pen: Option<Point> = None;
    outline(text, size, &mut |curve| {
        if pen != Some(curve.from) {
            if pen.is_some() {
                builder.close();
            }
            builder.move_to(single(curve.from[0]), single(curve.from[1]));
        }
        let [x, y] = curve.to.map(single);
        match curve.by.as_slice() {
            [a, b] => builder.cubic_to(single(a[0]), single(a[1]), single(b[0]), single(b[1]), x, y),
            [a] => builder.quad_to(single(a[0]), single(a[1]), x, y),
            _ => builder.line_to(x, y),
        }
        pen = Some(curve.to);
    });
    if pen.is_some() {
        builder.close();
    }
    builder.finish()
}
