use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};

use super::panel;
use crate::cli::commands::bench::execute::Studies;
use crate::study::WorkPrecision;

/// `DejaVu` Sans: Latin, Greek, superscripts. Text looks the same everywhere, and no system needs to have a font.
const FONT: &[u8] = include_bytes!("../../../../plot/fonts/DejaVuSans-subset.ttf");
/// Of one panel, pixels.
const PANEL: (u32, u32) = (1140, 640);

/// What a plot can be written as.
#[derive(Debug, Clone, Copy)]
pub enum Format {
    Svg,
    Png,
}

impl Format {
    /// That a file's name asks for.
    pub fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()? {
            "svg" => Some(Self::Svg),
            "png" => Some(Self::Png),
            _ => None,
        }
    }
}

/// Draws a panel for each body of each scene, in the format that the file's name asks for.
pub fn draw(path: &Path, studies: &Studies) -> Result<(), String> {
    register_font("sans-serif", FontStyle::Normal, FONT).map_err(|_| "its font cannot be read".to_owned())?;
    let panels: Vec<(&str, &WorkPrecision)> =
        studies.iter().flat_map(|(scene, bodies)| bodies.iter().map(|study| (scene.as_str(), study))).collect();
    let columns = if panels.len() > 1 { 2 } else { 1 };
    let rows = panels.len().div_ceil(columns);
    // Bodies of a scene, counted in dozens at most.
    let count = |number: usize| u32::try_from(number).unwrap_or(u32::MAX / PANEL.0);
    let size = (PANEL.0 * count(columns), PANEL.1 * count(rows));
    match Format::of(path) {
        Some(Format::Svg) => fill(&SVGBackend::new(path, size).into_drawing_area(), &panels, (rows, columns)),
        Some(Format::Png) => fill(&BitMapBackend::new(path, size).into_drawing_area(), &panels, (rows, columns)),
        None => Err("a plot's name ends in .svg or .png".to_owned()),
    }
}

fn fill<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    panels: &[(&str, &WorkPrecision)],
    grid: (usize, usize),
) -> Result<(), String> {
    let words = |error: DrawingAreaErrorKind<B::ErrorType>| error.to_string();
    area.fill(&WHITE).map_err(words)?;
    for (part, (scene, study)) in area.split_evenly(grid).iter().zip(panels) {
        panel::draw(part, scene, study).map_err(words)?;
    }
    area.present().map_err(words)
}
