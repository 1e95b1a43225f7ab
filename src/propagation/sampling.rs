use super::PropagationError;

/// Refuses sample times that go back, or that no state can be given for.
pub(super) fn check_times(times: &[f64], latest: f64) -> Result<(), PropagationError> {
    let mut previous = latest;
    for &time in times {
        // Written so that NaN is refused too.
        if !(time >= previous && time < f64::INFINITY) {
            return Err(PropagationError::NotAscending { time, previous });
        }
        previous = time;
    }
    Ok(())
}
