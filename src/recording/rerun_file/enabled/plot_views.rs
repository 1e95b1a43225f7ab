use std::io::Write;

use re_sdk_types::blueprint::archetypes::{PlotLegend, TimeAxis};
use re_sdk_types::blueprint::components::{self, ContainerKind, Corner2D, LinkAxis};
use re_sdk_types::datatypes::{TimeInt, TimeRange, TimeRangeBoundary};

use super::blueprint::{Blueprint, Container, Part, View};
use super::plots::{ZERO, entity};
use super::{markers, scaled};
use crate::recording::picture::Picture;
use crate::recording::{RecordedBody, RecordingError, Sampling};
use crate::scenario::nanoseconds;
use crate::telemetry::Channel;

/// Channels that share a plot, and its title: what people look at first comes first. Never a drift beside its quantity.
const PLOTS: [(&str, &[Channel]); 29] = [
    ("ω in body axes (rad/s)", &[Channel::AngularVelocity]),
    ("accelerometer (m/s²)", &[Channel::Accelerometer]),
    ("gyroscope (rad/s)", &[Channel::Gyroscope]),
    ("tilt (rad)", &[Channel::Tilt]),
    ("precession rate (rad/s)", &[Channel::PrecessionRate]),
    ("L in world axes (N m s)", &[Channel::AngularMomentumWorld]),
    ("τ in body axes (N m)", &[Channel::MomentBody]),
    (
        "energy (J)",
        &[
            Channel::RotationalEnergy,
            Channel::TranslationalEnergy,
            Channel::PotentialEnergy,
            Channel::TotalEnergy,
            Channel::KineticEnergy,
            Channel::JacobiIntegral,
        ],
    ),
    ("drift, relative (1e-15)", &[Channel::EnergyDrift, Channel::MomentumDrift, Channel::Slip]),
    ("position in world axes (m)", &[Channel::Position]),
    ("velocity in world axes (m/s)", &[Channel::Velocity]),
    ("acceleration in world axes (m/s²)", &[Channel::Acceleration]),
    ("position in body axes (m)", &[Channel::PositionBody]),
    ("velocity in body axes (m/s)", &[Channel::VelocityBody]),
    ("acceleration in body axes (m/s²)", &[Channel::AccelerationBody]),
    ("force in world axes (N)", &[Channel::ForceWorld]),
    ("ω in world axes (rad/s)", &[Channel::AngularVelocityWorld]),
    ("L in body axes (N m s)", &[Channel::AngularMomentumBody]),
    ("τ in world axes (N m)", &[Channel::MomentWorld]),
    ("attitude quaternion, world from body", &[Channel::Attitude]),
    ("precession, nutation, spin (rad)", &[Channel::FigureAngles]),
    ("rates of precession, nutation, spin (rad/s)", &[Channel::FigureRates]),
    ("tilt from L, phase on the polhode (rad)", &[Channel::MomentumTilt, Channel::PolhodePhase]),
    ("distance from the separatrix (1)", &[Channel::SeparatrixDistance]),
    ("Kovalevskaya's integral (rad⁴/s⁴)", &[Channel::KovalevskayaIntegral]),
    ("Euler angles about z, x, z (rad)", &[Channel::EulerZxz]),
    ("Euler angles about z, y, z (rad)", &[Channel::EulerZyz]),
    ("Euler angles about z, y, x (rad)", &[Channel::EulerZyx]),
    ("Euler angles about x, y, z (rad)", &[Channel::EulerXyz]),
];

/// How tops lean and go round: of several bodies one tab, the first, as they differ in nothing else.
const LEANING: [Channel; 2] = [Channel::Tilt, Channel::PrecessionRate];

/// Plots on the screen at once; the rest are tabs of the last.
const VISIBLE: usize = 4;

/// Room that a legend takes, in units of the run.
const LEGEND: f64 = 0.17;

/// Bodies that get a plot each; more share one.
const SEPARATE: usize = 4;

/// The plots of what is recorded, or `None` if nothing is.
///
/// One body has its plots below each other, the first of them above those of its points. Several have a tab for each
/// quantity, and in it a plot for each body: nine curves in one plot are no longer told apart. Points are told after them.
///
/// # Errors
/// If they cannot be written.
pub(super) fn write<W: Write>(
    blueprint: &mut Blueprint<'_, W>,
    bodies: &[RecordedBody],
    sampling: Sampling,
    picture: Option<&Picture>,
) -> Result<Option<Part>, RecordingError> {
    let mut plots = PlotViews { blueprint, picture, times: whole_run(sampling) };
    let first_point = bodies.iter().position(RecordedBody::is_point).unwrap_or(bodies.len());
    let (bodies, points) = bodies.split_at(first_point);
    let mut parts = Vec::new();
    let leaning = if bodies.len() > 1 { plots.leaning(bodies)? } else { None };
    for (title, channels) in PLOTS {
        let is_leaning = LEANING.iter().any(|channel| channels.contains(channel));
        if !(is_leaning && leaning.is_some()) {
            parts.extend(plots.quantity(title, channels, bodies)?);
        }
    }
    if let Some(leaning) = leaning {
        parts.insert(0, leaning);
    }
    let of_points = plots.of_points(points)?;
    let place = if bodies.len() > 1 { parts.len() } else { parts.len().min(1) };
    parts.splice(place..place, of_points);
    if parts.len() <= 1 {
        return Ok(parts.pop());
    }
    if bodies.len() > 1 {
        return plots.container(ContainerKind::Tabs, "", &parts).map(Some);
    }
    if parts.len() > VISIBLE {
        let rest = parts.split_off(VISIBLE - 1);
        parts.push(plots.container(ContainerKind::Tabs, "", &rest)?);
    }
    plots.container(ContainerKind::Vertical, "", &parts).map(Some)
}

/// Whether `bodies` bodies have these channels in one plot: all scalars, and vectors of many.
pub(super) fn shares_plot(channels: &[Channel], bodies: usize) -> bool {
    let are_scalars = channels.iter().all(|channel| channel.width() == 1);
    bodies > 1 && (are_scalars || bodies > SEPARATE)
}

/// A time axis from the first to the last sample, and room for the legend after it: what the viewer would show is a
/// minute around the cursor.
pub(super) fn whole_run(sampling: Sampling) -> TimeAxis {
    let at = |time| TimeRangeBoundary::Absolute(TimeInt(nanoseconds(time)));
    let (start, end) = (sampling.from_s, sampling.to_s);
    let range = TimeRange { start: at(start), end: at(end + LEGEND * (end - start)) };
    TimeAxis::new().with_link(LinkAxis::Independent).with_view_range(components::TimeRange(range))
}

/// A number as an exponent is written.
fn raised(power: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let letter = |letter: char| letter.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize]);
    power.to_string().chars().map(letter).collect()
}

/// Adds plots to a layout.
struct PlotViews<'a, 'b, W> {
    blueprint: &'a mut Blueprint<'b, W>,
    picture: Option<&'a Picture>,
    times: TimeAxis,
}

impl<W: Write> PlotViews<'_, '_, W> {
    fn container(&mut self, kind: ContainerKind, name: &str, parts: &[Part]) -> Result<Part, RecordingError> {
        self.blueprint.container(&Container { kind, name, parts, shares: &[] })
    }

    /// One quantity of all bodies, or `None` if no body has it.
    fn quantity(
        &mut self,
        title: &str,
        channels: &[Channel],
        bodies: &[RecordedBody],
    ) -> Result<Option<Part>, RecordingError> {
        let is_recorded = |body: &&RecordedBody| channels.iter().any(|channel| body.channels.contains(channel));
        let having: Vec<_> = bodies.iter().filter(is_recorded).collect();
        if having.is_empty() {
            return Ok(None);
        }
        let title = &self.counted(title, channels, &having);
        if having.len() == 1 || shares_plot(channels, bodies.len()) {
            return self.view(title, channels, &having).map(Some);
        }
        let mut views = Vec::with_capacity(having.len());
        for body in having {
            views.push(self.view(&format!("{}: {title}", body.name), channels, &[body])?);
        }
        self.container(ContainerKind::Vertical, title, &views).map(Some)
    }

    /// Every quantity of points of bodies: each point has a plot, but for very many.
    fn of_points(&mut self, points: &[RecordedBody]) -> Result<Vec<Part>, RecordingError> {
        let mut parts = Vec::new();
        for (title, channels) in PLOTS {
            let is_recorded = |point: &&RecordedBody| channels.iter().any(|channel| point.channels.contains(channel));
            let having: Vec<_> = points.iter().filter(is_recorded).collect();
            let title = &self.counted(title, channels, &having);
            if !having.is_empty() && shares_plot(channels, points.len()) {
                parts.push(self.view(&format!("points: {title}"), channels, &having)?);
                continue;
            }
            for point in having {
                parts.push(self.view(&format!("{}: {title}", point.name), channels, &[point])?);
            }
        }
        Ok(parts)
    }

    /// How several bodies lean and go round, or `None` if none does.
    fn leaning(&mut self, bodies: &[RecordedBody]) -> Result<Option<Part>, RecordingError> {
        let mut views = Vec::new();
        for (title, channels) in PLOTS.iter().filter(|(_, channels)| LEANING.contains(&channels[0])) {
            views.extend(self.quantity(title, channels, bodies)?);
        }
        match views.len() {
            0 | 1 => Ok(views.pop()),
            _ => self.container(ContainerKind::Vertical, "tilt and precession", &views).map(Some),
        }
    }

    /// The title with the power of ten that the plot counts its unit in.
    fn counted(&self, title: &str, channels: &[Channel], bodies: &[&RecordedBody]) -> String {
        let is_recorded = |channel: &&Channel| bodies.iter().any(|body| body.channels.contains(channel));
        let power = channels.iter().find(is_recorded).map_or(0, |channel| self.power(*channel));
        if power == 0 { title.to_owned() } else { title.replace('(', &format!("(10{} ", raised(power))) }
    }

    fn power(&self, channel: Channel) -> i32 {
        self.picture.map_or(0, |picture| picture.power(channel))
    }

    /// One plot.
    fn view(&mut self, name: &str, channels: &[Channel], bodies: &[&RecordedBody]) -> Result<Part, RecordingError> {
        let mut contents = Vec::new();
        for body in bodies {
            let recorded = channels.iter().filter(|channel| body.channels.contains(channel));
            contents.extend(recorded.map(|channel| match self.power(*channel) {
                0 => entity(&body.name, *channel),
                _ => scaled::entity(&body.name, *channel),
            }));
            if channels.contains(&Channel::AngularVelocity) {
                contents.push(format!("{}/**", markers::entities(&body.name)));
            }
        }
        if channels.contains(&Channel::TotalEnergy) || LEANING.contains(&channels[0]) {
            // Alone, a constant would fill its plot with rounding errors.
            contents.push(ZERO.to_owned());
        }
        let view = View { class: "TimeSeries", name, origin: "/", contents: &contents };
        let part = self.blueprint.view(&view)?;
        let legend = PlotLegend::new().with_corner(Corner2D::RightTop);
        self.blueprint.set(&part.property("PlotLegend"), &legend)?;
        self.blueprint.set(&part.property("TimeAxis"), &self.times)?;
        Ok(part)
    }
}
