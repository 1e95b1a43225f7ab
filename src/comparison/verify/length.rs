use super::series::resolution;
use crate::recording::Observed;

/// Are the quaternions unit, and one curve?
#[derive(Debug, Clone, PartialEq)]
pub struct Length {
    /// The largest deviation of |q| from 1.
    pub off: f64,
    /// At which time, s.
    pub off_at_s: f64,
    /// What rounding of the file leaves of it.
    pub floor: f64,
    /// How often q goes on as −q: the same attitude, and harmless.
    pub sign_flips: usize,
}

/// Roundings of four components.
const ROUNDINGS: f64 = 4.0;

impl Length {
    pub(super) fn of(observed: &Observed) -> Option<Self> {
        let track = observed.attitude.as_ref()?;
        let at = |k: usize| track.columns.each_ref().map(|column| column[k]);
        let dot = |a: [f64; 4], b: [f64; 4]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let floor = ROUNDINGS * resolution(track);
        let mut found =
            Self { off: 0.0, off_at_s: track.times_s.first().copied().unwrap_or(0.0), floor, sign_flips: 0 };
        for (k, time) in track.times_s.iter().enumerate() {
            let q = at(k);
            let off = (dot(q, q).sqrt() - 1.0).abs();
            // Not a number is as far off as can be.
            if off > found.off || off.is_nan() {
                (found.off, found.off_at_s) = (if off.is_nan() { f64::INFINITY } else { off }, *time);
            }
            found.sign_flips += usize::from(k > 0 && dot(q, at(k - 1)) < 0.0);
        }
        Some(found)
    }
}
