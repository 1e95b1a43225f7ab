use crate::scenario::{Method, nearest};

/// The method that a flag names.
pub fn method(name: &str) -> Result<Method, String> {
    let found = Method::ALL.into_iter().find(|method| method.key() == name);
    found.ok_or_else(|| format!("--methods: {name:?} is no method: {}", hint(name, &Method::ALL.map(Method::key))))
}

/// What to say of a name that is none of `names`.
pub fn hint(name: &str, names: &[&str]) -> String {
    match nearest(name, names.iter().copied()) {
        Some(near) => format!("did you mean {near:?}?"),
        None => format!("take {}", names.join(", ")),
    }
}
