//! Rules that many keys share.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::body::Attitude;
use crate::scenario::{Key, Refusal};

pub fn positive(key: &Key, value: f64) -> Result<f64, Refusal> {
    if value.is_finite() && value > 0.0 {
        return Ok(value);
    }
    Err(key.refuse(format_args!("{value:?} must be positive and finite")))
}

pub fn not_negative(key: &Key, value: f64) -> Result<f64, Refusal> {
    if value.is_finite() && value >= 0.0 {
        return Ok(value);
    }
    Err(key.refuse(format_args!("{value:?} must be finite and not negative")))
}

pub fn finite(key: &Key, value: f64) -> Result<f64, Refusal> {
    if value.is_finite() {
        return Ok(value);
    }
    Err(key.refuse(format_args!("{value:?} must be finite")))
}

pub fn vector(key: &Key, value: [f64; 3]) -> Result<Vector3<f64>, Refusal> {
    if value.iter().all(|component| component.is_finite()) {
        return Ok(Vector3::from(value));
    }
    Err(key.refuse(format_args!("{value:?}: every component must be finite")))
}

/// The vector at a key that may be left out: then zero.
pub fn optional_vector(key: &Key, value: Option<[f64; 3]>) -> Result<Vector3<f64>, Refusal> {
    value.map_or(Ok(Vector3::zeros()), |value| vector(key, value))
}

/// A direction: of unit length within what typing rounds away.
pub fn unit_vector(key: &Key, value: [f64; 3]) -> Result<Vector3<f64>, Refusal> {
    let length = vector(key, value)?.norm();
    if (length - 1.0).abs() <= Attitude::LENGTH_TOLERANCE {
        return Ok(Vector3::from(value) / length);
    }
    let unit = Vector3::from(value) / length;
    let advice =
        if unit.iter().all(|c| c.is_finite()) { format!("; normalised: {:?}", unit.as_slice()) } else { String::new() };
    Err(key.refuse(format_args!("{value:?} has length {length}: a direction has length 1{advice}")))
}

/// A rotation, where the key may be left out: then none.
pub fn rotation(key: &Key, wxyz: Option<[f64; 4]>) -> Result<Attitude, Refusal> {
    let Some(wxyz) = wxyz else { return Ok(Attitude::identity()) };
    Attitude::new(wxyz).map_err(|error| {
        let [w, x, y, z] = wxyz;
        let unit = UnitQuaternion::try_new(Quaternion::new(w, x, y, z), f64::MIN_POSITIVE)
            .filter(|_| wxyz.iter().all(|component| component.is_finite()));
        let advice = unit.map_or(String::new(), |q| format!("; normalised: {:?}", [q.w, q.i, q.j, q.k]));
        key.refuse(format_args!("{error}{advice}"))
    })
}

/// Refuses a key that is given though nothing uses it.
pub fn unused<T>(key: &Key, value: Option<&T>, rule: &str) -> Result<(), Refusal> {
    value.map_or(Ok(()), |_| Err(key.refuse(format_args!("not used: {rule}"))))
}
