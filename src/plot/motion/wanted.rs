use crate::scenario::nearest;
use crate::telemetry::Channel;

/// What a panel can show: a channel against time, or a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wanted {
    /// Against time.
    Channel(Channel),
    /// The path of ω on the ellipsoid.
    Polhode,
    /// The path of ω on the invariable plane.
    Herpolhode,
    /// The path of a body axis in the world.
    AxisPath,
}

impl Wanted {
    /// Figures by name.
    const FIGURES: [(&'static str, Self); 3] =
        [("polhode", Self::Polhode), ("herpolhode", Self::Herpolhode), ("axis_path", Self::AxisPath)];

    /// As flags call it.
    #[must_use]
    pub fn name(self) -> &'static str {
        let figure = Self::FIGURES.iter().find(|(_, figure)| *figure == self).map(|(name, _)| *name);
        match self {
            Self::Channel(channel) => channel.row().name,
            _ => figure.unwrap_or_default(),
        }
    }

    /// The channels that it is drawn from.
    #[must_use]
    pub fn needs(&self) -> &[Channel] {
        match self {
            Self::Channel(channel) => std::slice::from_ref(channel),
            Self::Polhode => &[Channel::AngularVelocity],
            Self::Herpolhode => &[Channel::Attitude, Channel::AngularVelocity, Channel::AngularMomentumWorld],
            Self::AxisPath => &[Channel::Attitude],
        }
    }

    /// What `name` asks for.
    ///
    /// # Errors
    /// If nothing is called so; the message names what comes near.
    pub fn named(name: &str) -> Result<Self, String> {
        let figure = Self::FIGURES.iter().find(|(known, _)| *known == name).map(|(_, figure)| *figure);
        let known = figure.or_else(|| Channel::from_name(name).map(Self::Channel));
        known.ok_or_else(|| {
            let names = || Channel::ALL.map(|channel| channel.row().name).into_iter();
            let figures = || Self::FIGURES.iter().map(|(name, _)| *name);
            let hint = nearest(name, names().chain(figures())).map_or_else(
                || format!("known are {}", names().chain(figures()).collect::<Vec<_>>().join(", ")),
                |near| format!("did you mean {near:?}?"),
            );
            format!("{name:?} is no channel and no figure; {hint}")
        })
    }
}
