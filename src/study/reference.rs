use crate::propagation::States;
use crate::scenario::{Method, PlannedBody, ScenarioError, Setting};

/// The motion that errors are measured from.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// In principal axes.
    pub states: States,
    /// The method that made it.
    pub method: Method,
    /// The independent method that it was compared with.
    pub witness: Method,
    /// How far the witness is from it, rad: errors below this are not resolved.
    pub doubt_rad: f64,
}

/// The best motion known of `body` at `times`, s, and how far a second, independent method is from it.
///
/// The closed form where one is known, with Taylor series as the witness; elsewhere Taylor series at their tightest,
/// with DOP853 at its tightest as the witness. Most of the doubt is the witness's own error.
///
/// # Errors
/// If the motion ceases to be finite or a step cannot be made small enough.
pub fn reference_states(body: &PlannedBody, times: &[f64]) -> Result<Reference, ScenarioError> {
    let is_known = tightest(body, Method::ClosedForm).is_ok();
    let (method, witness) =
        if is_known { (Method::ClosedForm, Method::Taylor) } else { (Method::Taylor, Method::Dop853) };
    let states = states(&tightest(body, method)?, times)?;
    let other = self::states(&tightest(body, witness)?, times)?;
    Ok(Reference { doubt_rad: attitude_distance(&states, &other), states, method, witness })
}

/// `body` by `method` at full accuracy; the rules of scenes take no tolerance as the tightest there is.
fn tightest(body: &PlannedBody, method: Method) -> Result<PlannedBody, ScenarioError> {
    debug_assert_ne!(method.setting(), Setting::Step, "a fixed step has no tightest");
    body.clone().by(method, None)
}

fn states(body: &PlannedBody, times: &[f64]) -> Result<States, ScenarioError> {
    let mut states = States::default();
    body.propagator()?.fill(times, &mut states)?;
    Ok(states)
}

/// The largest angle between two motions at the same times, rad, however small; infinite where one is not finite.
#[must_use]
pub fn attitude_distance(one: &States, other: &States) -> f64 {
    let at = |states: &States, index: usize| -> [f64; 4] { std::array::from_fn(|k| states.attitude[k][index]) };
    (0..one.len()).map(|index| angle(at(one, index), at(other, index))).fold(0.0, |most, angle| {
        // NaN is as wrong as can be, where f64::max would drop it.
        if angle.is_nan() { f64::INFINITY } else { most.max(angle) }
    })
}

/// 2 atan2(|Im|, |Re|) of q̄ p, with Im from the difference p − q so that nothing large cancels.
fn angle(q: [f64; 4], p: [f64; 4]) -> f64 {
    let dot: f64 = q.iter().zip(&p).map(|(a, b)| a * b).sum();
    let p = if dot < 0.0 { p.map(|component| -component) } else { p };
    let [w, x, y, z] = q;
    let [a, b, c, d] = std::array::from_fn(|k| p[k] - q[k]);
    let imaginary = [w * b - x * a - y * d + z * c, w * c - y * a - z * b + x * d, w * d - z * a - x * c + y * b];
    2.0 * libm::atan2(imaginary.iter().map(|part| part * part).sum::<f64>().sqrt(), dot.abs())
}

#[cfg(test)]
mod tests {
    use super::angle;

    #[test]
    fn angles_are_true_however_small_and_blind_to_sign() {
        for half in [1e-12, 1e-3, 0.7, 1.5] {
            let turned = [libm::cos(half), 0.6 * libm::sin(half), 0.0, -0.8 * libm::sin(half)];
            let found = angle([1.0, 0.0, 0.0, 0.0], turned);
            assert!((found - 2.0 * half).abs() < 1e-15 * half.max(0.5), "{found} is not twice {half}");
            assert_eq!(angle([1.0, 0.0, 0.0, 0.0], turned.map(|component| -component)), found);
        }
    }
}
