use std::f64::consts::TAU;

use super::scale;

/// Pictures in a second of playback: more than the eye and viewers follow.
const RATE: f64 = 60.0;
/// A body never turns by more from picture to picture, rad: it would seem to stand or to turn back.
const LARGEST_TURN: f64 = TAU / 24.0;

/// Seconds of motion in a second of playback: as it is if that takes 10 s to 2 min, else 20 s to 50 s in all.
pub fn playback_speed(duration: f64) -> f64 {
    if !duration.is_finite() || duration <= 0.0 || (10.0..=120.0).contains(&duration) {
        return 1.0;
    }
    let speed = duration / 20.0;
    if speed.is_normal() { scale::round_down(speed) } else { 1.0 }
}

/// Every how many samples, `interval` s apart, a picture is drawn: at most 60 in a second of playback at `speed`, but as
/// many as it takes to follow a body that turns at `fastest` rad/s.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 1 … 1e9")]
pub fn stride(interval: f64, speed: f64, fastest: f64) -> u64 {
    // The hair keeps a tenth of 1/60 s from being a little too short ten times.
    let for_the_eye = (speed / RATE / interval * (1.0 - 1e-9)).ceil();
    let to_follow = (LARGEST_TURN / fastest / interval).floor();
    for_the_eye.min(to_follow).clamp(1.0, 1e9) as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sixty_pictures_in_a_second_of_playback() {
        assert_eq!(stride(1e-3, 1.0, 9.0), 17);
        assert_eq!(stride(1.0 / 600.0, 1.0, 0.0), 10);
        assert_eq!(stride(1e-3, playback_speed(1.32), 9.0), 1);
        assert_eq!(stride(2.0, playback_speed(7900.0), 1e-3), 2);
    }

    #[test]
    fn a_fast_body_is_followed() {
        let stride = stride(1e-5, 1.0, 1000.0);
        assert_eq!(stride, 26);
        assert!(f64::from(u32::try_from(stride).expect("small")) * 1e-5 * 1000.0 <= LARGEST_TURN);
        assert_eq!(super::stride(1436.0, 1e6, 7.3e-5), 2);
    }
}
