use serde_json::{Value, json};

use crate::comparison::{Growth, Law};

/// By which law a difference grows, as docs/comparison.md tells it.
pub fn growth_as_json(growth: &Growth) -> Value {
    let (law, exponent, rate_per_s) = match growth.law {
        Law::Bounded => ("bounded", None, None),
        Law::Power { exponent } => ("power", Some(exponent), None),
        Law::Exponential { rate_per_s } => ("exponential", None, Some(rate_per_s)),
        Law::Irregular => ("irregular", None, None),
    };
    json!({
        "law": law,
        "exponent": exponent,
        "rate_per_s": rate_per_s,
        "factor": growth.factor,
        "from_s": growth.from_s,
        "until_s": growth.until_s,
        "is_saturated": growth.is_saturated,
        "words": growth.in_words(),
    })
}
