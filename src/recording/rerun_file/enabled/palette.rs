//! Okabe and Ito's colours, told apart with any kind of colour vision, and the greys between them.

use re_sdk_types::components::Color;

/// Of x, in plots and of axes.
pub(super) const X: [u8; 3] = [213, 94, 0];
/// Of y.
pub(super) const Y: [u8; 3] = [0, 158, 115];
/// Of z.
pub(super) const Z: [u8; 3] = [86, 180, 233];
/// Of w, and of single curves.
pub(super) const W: [u8; 3] = [240, 228, 66];
/// Of a further body.
pub(super) const V: [u8; 3] = [204, 121, 167];
/// Of the trail.
pub(super) const TRAIL: [u8; 3] = [240, 228, 66];
/// Of the path of the reference point.
pub(super) const PATH: [u8; 3] = [150, 150, 150];
/// Of the springs that hold a body.
pub(super) const CORD: [u8; 3] = [222, 205, 170];
/// Of a body's point number `number`: its place and its way.
pub(super) fn of_point(number: usize) -> [u8; 3] {
    const HUES: [[u8; 3]; 4] = [V, POLHODE, [120, 200, 190], [230, 190, 120]];
    HUES[number % HUES.len()]
}
/// Of the world's axes.
pub(super) const WORLD: [u8; 3] = [170, 170, 170];
/// Of the bodies' names.
pub(super) const NAMES: [u8; 3] = [230, 230, 230];
/// Of the floor's grid: red, green, blue, opacity.
pub(super) const GRID: [u8; 4] = [140, 150, 160, 50];
/// Of what is behind everything.
pub(super) const BACKGROUND: [u8; 3] = [21, 23, 27];
/// Of the line at zero in plots.
pub(super) const ZERO: [u8; 3] = [90, 90, 90];

/// Of ω, as its arrow.
pub(super) const RATE: [u8; 3] = [240, 150, 20];
/// Of L, as its arrow.
pub(super) const MOMENTUM: [u8; 3] = [0, 145, 230];
/// Of the curve that ω and L draw in the body.
pub(super) const POLHODE: [u8; 3] = [235, 130, 190];
/// Of the energy ellipsoids.
pub(super) const ENERGY: [u8; 3] = [196, 200, 206];
/// Of the sphere of all L of one size.
pub(super) const SPHERE: [u8; 3] = [60, 120, 170];

/// As the viewer takes it.
pub(super) fn opaque([red, green, blue]: [u8; 3]) -> Color {
    Color::from_rgb(red, green, blue)
}

/// Of the scalars of body `number`, by number of curve: a hue for each body, darker from curve to curve.
pub(super) fn of_body(number: usize, curve: usize) -> [u8; 3] {
    const HUES: [[u8; 3]; 5] = [X, Y, Z, W, V];
    const EIGHTHS: [u16; 4] = [8, 6, 4, 7];
    let eighths = EIGHTHS[curve % EIGHTHS.len()];
    HUES[number % HUES.len()].map(|part| u8::try_from(u16::from(part) * eighths / 8).unwrap_or(part))
}
