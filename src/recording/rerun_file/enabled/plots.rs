use std::io::Write;

use re_sdk_types::archetypes::{Scalars, SeriesLines, TextDocument};
use re_sdk_types::components::{Color, Name};

use super::columns::{scalars, timelines};
use super::palette;
use super::plot_views::shares_plot;
use super::stream::{Rows, Store, Stream};
use super::words;
use crate::recording::{RecordedBody, RecordingError, Sampling, Subject};
use crate::scenario::nanoseconds;
use crate::telemetry::{Channel, Samples};

/// Entity of the exact times, where the grid is a list, s.
pub(super) const TIME: &str = "/time/time_s";

/// Entity of the exact sampling interval, where it is one, s.
pub(super) const INTERVAL: &str = "/time/interval_s";

/// Entity of the line at zero that energies are seen against.
pub(super) const ZERO: &str = "/zero";

/// Every channel of every body, every sample, to the last bit.
pub(super) struct Plots {
    entities: Vec<Vec<(Channel, String)>>,
    lists_times: bool,
}

/// Where the columns of `channel` are logged.
pub(super) fn entity(body: &str, channel: Channel) -> String {
    format!("/body/{body}/plots/{}", channel.row().name)
}

/// Of which body and channel the columns at `entity` are; `None` where there are none.
pub(super) fn channel_of(entity: &str) -> Option<(&str, Channel)> {
    let (body, channel) = entity.strip_prefix("/body/")?.rsplit_once("/plots/")?;
    Some((body, Channel::from_name(channel)?))
}

impl Plots {
    /// Logs the bodies, the curves' names and colours, and the sampling interval.
    ///
    /// # Errors
    /// If they cannot be written.
    pub(super) fn begin<W: Write>(
        stream: &mut Stream<W>,
        store: Store,
        subject: &Subject,
    ) -> Result<Self, RecordingError> {
        let (heading, sampling) = (&subject.heading, subject.sampling);
        let of_body = |body: &RecordedBody| -> Vec<_> {
            body.channels.iter().map(|channel| (*channel, entity(&body.name, *channel))).collect()
        };
        let entities: Vec<_> = heading.bodies.iter().map(of_body).collect();
        if subject.is_compact {
            stream.once(store, words::COLUMNS, &[], &TextDocument::new(words::columns(&heading.bodies)))?;
        } else {
            for (number, (body, entities)) in heading.bodies.iter().zip(&entities).enumerate() {
                let method = TextDocument::new(words::method(&heading.provenance, &body.name));
                stream.once(store, &words::body(&body.name), &[], &method)?;
                for (channel, entity) in entities {
                    stream.once(store, entity, &[], &curves(*channel, number, &heading.bodies))?;
                }
            }
            write_zero(stream, store, sampling)?;
        }
        if let Some(interval) = sampling.interval_s {
            stream.once(store, INTERVAL, &[], &Scalars::new([interval]))?;
        }
        Ok(Self { entities, lists_times: sampling.interval_s.is_none() })
    }

    /// Logs one batch.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(super) fn write<W: Write>(
        &self,
        stream: &mut Stream<W>,
        store: Store,
        rows: Rows<'_>,
        samples: &Samples,
    ) -> Result<(), RecordingError> {
        if self.lists_times {
            stream.columns(store, TIME, rows, [scalars(std::slice::from_ref(&samples.times_s))])?;
        }
        for (entities, body) in self.entities.iter().zip(&samples.bodies) {
            for (channel, entity) in entities {
                if let Some(columns) = body.channel(*channel) {
                    stream.columns(store, entity, rows, [scalars(columns)])?;
                }
            }
        }
        Ok(())
    }
}

/// Logs a line from the first to the last sample.
fn write_zero<W: Write>(stream: &mut Stream<W>, store: Store, sampling: Sampling) -> Result<(), RecordingError> {
    let [red, green, blue] = palette::ZERO;
    let style = SeriesLines::new().with_names(["0"]).with_colors([Color::from_rgb(red, green, blue)]);
    stream.once(store, ZERO, &[], &style)?;
    let stamps = [sampling.from_s, sampling.to_s].map(nanoseconds);
    let steps = [0, sampling.samples.saturating_sub(1).cast_signed()];
    let times = timelines(stamps.to_vec(), steps.to_vec());
    stream.columns(store, ZERO, Rows { count: 2, times: &times }, [scalars(&[vec![0.0; 2]])])
}

/// The curves of a channel: their names (the view's title says the unit) and colours.
pub(super) fn curves(channel: Channel, number: usize, bodies: &[RecordedBody]) -> SeriesLines {
    let row = channel.row();
    let is_alike = |other: &&RecordedBody| other.is_point() == bodies[number].is_point();
    let is_shared = shares_plot(&[channel], bodies.iter().filter(is_alike).count());
    let owner = if is_shared { bodies[number].name.as_str() } else { "" };
    let names = row.components.iter().map(|component| {
        // Of several bodies, how they lean is in one plot and nothing else: the names tell them apart.
        let is_told = is_shared && matches!(channel, Channel::Tilt | Channel::PrecessionRate);
        let parts = [owner, if is_told { "" } else { symbol(channel) }, component];
        let words: Vec<_> = parts.into_iter().filter(|part| !part.is_empty()).collect();
        Name::from(words.join(" "))
    });
    let mut colours = colours(channel).to_vec();
    if let (true, [colour]) = (is_shared, colours.as_mut_slice()) {
        *colour = palette::of_body(number, companion(channel));
    }
    let colours = colours.into_iter().map(|[red, green, blue]| Color::from_rgb(red, green, blue));
    SeriesLines::new().with_names(names).with_colors(colours).with_widths(vec![1.5_f32; row.components.len()])
}

/// Place of a scalar among those that share its plot.
fn companion(channel: Channel) -> usize {
    match channel {
        Channel::TranslationalEnergy | Channel::MomentumDrift | Channel::PolhodePhase => 1,
        Channel::PotentialEnergy | Channel::Slip => 2,
        Channel::TotalEnergy => 3,
        Channel::KineticEnergy => 4,
        Channel::JacobiIntegral => 5,
        _ => 0,
    }
}

/// What a legend has room for.
fn symbol(channel: Channel) -> &'static str {
    match channel {
        Channel::Attitude => "q",
        Channel::AngularVelocity | Channel::AngularVelocityWorld | Channel::Gyroscope => "ω",
        Channel::AngularMomentumWorld | Channel::AngularMomentumBody => "L",
        Channel::MomentBody | Channel::MomentWorld => "τ",
        Channel::Position | Channel::PositionBody => "r",
        Channel::Velocity | Channel::VelocityBody => "v",
        Channel::ForceWorld => "F",
        Channel::RotationalEnergy => "rotational",
        Channel::TranslationalEnergy => "translational",
        Channel::PotentialEnergy => "potential",
        Channel::TotalEnergy => "total",
        Channel::EnergyDrift => "energy",
        Channel::MomentumDrift => "momentum",
        Channel::Slip => "slip",
        Channel::Tilt => "tilt",
        Channel::PrecessionRate => "precession",
        Channel::EulerZxz | Channel::EulerZyz | Channel::EulerZyx | Channel::EulerXyz => "angle",
        // Their components say it.
        Channel::FigureAngles | Channel::FigureRates => "",
        Channel::MomentumTilt => "tilt from L",
        Channel::PolhodePhase => "phase",
        Channel::SeparatrixDistance => "distance",
        Channel::KineticEnergy => "kinetic",
        Channel::JacobiIntegral => "Jacobi",
        Channel::KovalevskayaIntegral => "Kovalevskaya",
        Channel::Acceleration | Channel::AccelerationBody => "a",
        Channel::Accelerometer => "f",
    }
}

/// Of a channel's curves: x, y, z as the axes in the picture, and four scalars that may share a plot.
fn colours(channel: Channel) -> &'static [[u8; 3]] {
    match channel {
        Channel::Attitude => &[palette::W, palette::X, palette::Y, palette::Z],
        Channel::RotationalEnergy | Channel::EnergyDrift | Channel::KineticEnergy | Channel::PolhodePhase => {
            &[palette::X]
        }
        Channel::TranslationalEnergy | Channel::Slip | Channel::JacobiIntegral => &[palette::Y],
        Channel::PotentialEnergy | Channel::MomentumDrift => &[palette::Z],
        Channel::TotalEnergy
        | Channel::Tilt
        | Channel::PrecessionRate
        | Channel::MomentumTilt
        | Channel::SeparatrixDistance
        | Channel::KovalevskayaIntegral => &[palette::W],
        _ => &[palette::X, palette::Y, palette::Z],
    }
}
