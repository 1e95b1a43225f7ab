use crate::telemetry::{BodySamples, Channel};

/// Largest numbers from the first to below the second are handy on an axis; others fill it with noughts or powers.
const HANDY: (f64, f64) = (1e-2, 1e5);

/// Energies share a plot, and so its unit.
const ENERGIES: [Channel; 4] =
    [Channel::RotationalEnergy, Channel::TranslationalEnergy, Channel::PotentialEnergy, Channel::TotalEnergy];

/// The channels that are plotted in powers of ten of their unit, and which: multiples of three that leave 1 to 999.
///
/// `sizes` are the largest numbers of each body's channels.
pub fn choose(sizes: &[(Channel, f64)]) -> Vec<(Channel, i32)> {
    let largest = |of: &dyn Fn(Channel) -> bool| {
        sizes.iter().filter(|(channel, _)| of(*channel)).map(|(_, size)| *size).fold(0.0, f64::max)
    };
    let power_of = |channel: Channel| {
        let is_energy = ENERGIES.contains(&channel);
        power(largest(&|other| other == channel || is_energy && ENERGIES.contains(&other)))
    };
    let powers = Channel::ALL.into_iter().map(|channel| (channel, power_of(channel)));
    powers.filter(|(channel, power)| *power != 0 && has_unit(*channel)).collect()
}

/// Whether the channel counts in a unit: drifts have a power of their own, quaternions need none.
pub fn has_unit(channel: Channel) -> bool {
    !channel.row().unit.starts_with('1')
}

/// The largest component, over all samples.
pub fn size(samples: &BodySamples, channel: Channel) -> f64 {
    let columns = samples.channel(channel).unwrap_or_default();
    columns.iter().flatten().fold(0.0, |largest, value| largest.max(value.abs()))
}

#[expect(clippy::cast_possible_truncation, reason = "the power of an f64 is between -324 and 308")]
fn power(largest: f64) -> i32 {
    if !largest.is_normal() || (HANDY.0..HANDY.1).contains(&largest) {
        return 0;
    }
    // A hair up, so that 1000 is 1 of the next.
    let thousands = (libm::log10(largest * (1.0 + 1e-9)) / 3.0).floor();
    3 * thousands as i32
}

#[cfg(test)]
mod tests {
    use super::power;

    #[test]
    fn an_axis_counts_in_thousands_and_leaves_handy_numbers_alone() {
        assert_eq!([0.0, 0.01, 4.0, 99_999.0].map(power), [0; 4]);
        assert_eq!([2.2e29, 5.8e33, 1e6, 999e3].map(power), [27, 33, 6, 3]);
        assert_eq!([4.1e-4, 3e-3, 7.3e-5].map(power), [-6, -3, -6]);
    }
}
