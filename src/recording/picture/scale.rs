use super::Quantity;

/// Label and m per unit of an arrow that is about `length` m long where its quantity is `largest`.
///
/// The label names a round length and the round value it stands for: `ω (10 cm = 5 rad/s)`.
pub fn choose(quantity: Quantity, length: f64, largest: f64) -> (String, f64) {
    let (symbol, unit, _) = quantity.words();
    let metres = round_down(0.5 * length);
    let value = round_up(largest * metres / length, &[1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0]);
    (format!("{symbol} ({} = {} {unit})", length_in_words(metres), plain(value)), metres / value)
}

/// The next of `rounds` × 10ⁿ that is not below `value`; `rounds` from 1 to below 10.
fn round_up(value: f64, rounds: &[f64]) -> f64 {
    let decade = libm::pow(10.0, libm::log10(value).floor());
    let digits = value / decade;
    let round = rounds.iter().find(|round| digits <= **round * (1.0 + 1e-12)).unwrap_or(&10.0);
    round * decade
}

/// The last of 1, 2, 5 × 10ⁿ that is not above `value`, which is positive.
pub fn round_down(value: f64) -> f64 {
    1.0 / round_up(1.0 / value, &[1.0, 2.0, 5.0])
}

fn length_in_words(metres: f64) -> String {
    let (factor, unit) = [(1e-3, "km"), (1.0, "m"), (1e2, "cm"), (1e3, "mm")]
        .into_iter()
        .find(|(factor, _)| metres * factor > 0.999)
        .unwrap_or((1e6, "µm"));
    format!("{} {unit}", plain(metres * factor))
}

/// A round number without the noise of its making.
fn plain(value: f64) -> String {
    if (1e-3..1e5).contains(&value) {
        let text = format!("{value:.6}");
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    let text = format!("{value:.1e}");
    text.replace(".0e", "e")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_name_round_numbers() {
        let (label, scale) = choose(Quantity::AngularVelocity, 0.23, 9.1);
        assert_eq!(label, "ω (10 cm = 4 rad/s)");
        assert!((scale - 0.025).abs() < 1e-15);
        let (label, _) = choose(Quantity::AngularMomentum, 4e6, 7.2e37);
        assert_eq!(label, "L (2000 km = 4e37 N m s)");
    }
}
