//! Surfaces of revolution around z.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::Vector3;

use super::Surface;

/// A point of a profile, and the outward normal there.
#[derive(Debug, Clone, Copy)]
pub(super) struct ProfilePoint {
    /// Distance from the axis, m; exactly zero on it.
    pub radius: f64,
    /// m.
    pub height: f64,
    /// Away from the axis, and along it.
    pub normal: [f64; 2],
}

impl ProfilePoint {
    pub fn new([radius, height]: [f64; 2], normal: [f64; 2]) -> Self {
        Self { radius, height, normal }
    }
}

impl Surface {
    /// Adds the strip that `profile`, smooth and going up where its normals point away from the axis, sweeps in
    /// `around` steps. Where the profile meets the axis, triangles instead of quadrangles.
    pub(super) fn sweep(&mut self, profile: &[ProfilePoint], around: u32) {
        for [lower, upper] in profile.array_windows() {
            for step in 0..around {
                let [here, next] = [step, step + 1].map(|step| circle(step % around, around));
                let corner = |surface: &mut Self, point: &ProfilePoint, [cosine, sine]: [f64; 2]| {
                    let position = Vector3::new(point.radius * cosine, point.radius * sine, point.height);
                    let [away, along] = point.normal;
                    surface.add_vertex(&position, &Vector3::new(away * cosine, away * sine, along))
                };
                let a = corner(self, lower, here);
                let b = corner(self, lower, next);
                let c = corner(self, upper, next);
                let d = corner(self, upper, here);
                if lower.radius > 0.0 {
                    self.triangles.push([a, b, c]);
                }
                if upper.radius > 0.0 {
                    self.triangles.push([a, c, d]);
                }
            }
        }
    }

    /// Adds a flat disc at `height`, seen from above (`facing` = 1) or below (−1).
    pub(super) fn sweep_disc(&mut self, radius: f64, height: f64, facing: f64, around: u32) {
        let rim = ProfilePoint::new([radius, height], [0.0, facing]);
        let middle = ProfilePoint::new([0.0, height], [0.0, facing]);
        let profile = if facing > 0.0 { [rim, middle] } else { [middle, rim] };
        self.sweep(&profile, around);
    }
}

/// Cosine and sine of `step` / `steps` of a turn; exact on the axes, so that opposite halves close.
pub(super) fn circle(step: u32, steps: u32) -> [f64; 2] {
    match 4 * step {
        0 => [1.0, 0.0],
        quarter if quarter == steps => [0.0, 1.0],
        quarter if quarter == 2 * steps => [-1.0, 0.0],
        quarter if quarter == 3 * steps => [0.0, -1.0],
        _ => {
            let angle = TAU * f64::from(step) / f64::from(steps);
            [libm::cos(angle), libm::sin(angle)]
        }
    }
}

/// A quarter of a circle of this radius around height `centre`: from the lower pole to the equator (`facing` = −1), or
/// from the equator to the upper pole (1), in `steps` steps.
pub(super) fn quarter_circle(radius: f64, centre: f64, facing: f64, steps: u32) -> Vec<ProfilePoint> {
    let point = |step: u32| {
        let latitude = FRAC_PI_2 * f64::from(step) / f64::from(steps);
        let [away, along] =
            if step == steps { [0.0, facing] } else { [libm::cos(latitude), facing * libm::sin(latitude)] };
        ProfilePoint::new([radius * away, centre + radius * along], [away, along])
    };
    if facing > 0.0 { (0..=steps).map(point).collect() } else { (0..=steps).rev().map(point).collect() }
}

/// The circle of a tube, once around, going up outside.
pub(super) fn whole_circle(major_radius: f64, minor_radius: f64, steps: u32) -> Vec<ProfilePoint> {
    let point = |step: u32| {
        let [away, along] = circle(step % steps, steps);
        ProfilePoint::new([major_radius + minor_radius * away, minor_radius * along], [away, along])
    };
    (0..=steps).map(point).collect()
}
