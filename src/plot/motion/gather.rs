use super::body::BodyMotion;
use super::wanted::Wanted;
use crate::plot::{Drawing, PlotError, grid};
use crate::recording::Heading;
use crate::scenario::{Plan, nearest};
use crate::telemetry::Samples;

/// What to draw of a motion.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Request {
    /// Which panels; empty: those that tell most.
    pub wanted: Vec<Wanted>,
    /// Of which bodies, by name; empty: of all.
    pub bodies: Vec<String>,
    /// From when, s.
    pub from_s: Option<f64>,
    /// Until when, s.
    pub to_s: Option<f64>,
}

/// A motion, thinned as it is read to what a sheet can show: memory is flat at any length.
///
/// ```
/// use polhode::plot::{Format, Motion, Request};
/// use polhode::recording::Subject;
/// use polhode::scenario::{BodySpec, Plan, Scenario};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let body = BodySpec {
///     principal_moments_kg_m2: Some([1.0, 2.0, 3.0]),
///     angular_velocity_rad_s: Some([0.01, 5.0, 0.01]),
///     ..BodySpec::default()
/// };
/// let scenario =
///     Scenario { duration_s: Some(9.0), sample_every_s: Some(0.01), body: vec![body], ..Scenario::default() };
/// let plan = Plan::new(&scenario)?;
/// let mut motion = Motion::new(&Subject::of(&plan).heading, Some(&plan), &Request::default())?;
/// let mut run = plan.start()?;
/// while let Some(samples) = run.next_batch()? {
///     motion.add(samples);
/// }
/// let png = Format::Png.bytes(&motion.draw("a T-handle", &[]))?;
/// # assert!(png.len() > 50_000);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone)]
pub struct Motion {
    bodies: Vec<BodyMotion>,
    is_one_of_one: bool,
    from_s: f64,
    to_s: f64,
}

/// Bodies below each other at most: more are side by side, as a picture has no room for sheets of any height.
const MOST_BELOW: usize = 8;
/// Of a chart on a sheet, pixels.
const CHART: (f64, f64) = (600.0, 250.0);

impl Motion {
    /// Nothing yet of the recording with this heading; `plan`, if it is known, tells moments of inertia and events.
    ///
    /// # Errors
    /// If a body asked for is not there, or a panel that no body has the columns for.
    pub fn new(heading: &Heading, plan: Option<&Plan>, request: &Request) -> Result<Self, PlotError> {
        let names = || heading.bodies.iter().map(|body| body.name.as_str());
        for name in &request.bodies {
            if !names().any(|known| known == name) {
                let hint = nearest(name, names()).map_or_else(
                    || format!("there are {}", names().collect::<Vec<_>>().join(", ")),
                    |near| format!("did you mean {near:?}?"),
                );
                return Err(PlotError::UnknownBody { name: name.clone(), hint });
            }
        }
        let numbered = heading.bodies.iter().enumerate();
        let is_chosen = |name: &String| request.bodies.is_empty() || request.bodies.contains(name);
        let chosen = numbered.filter(|(_, body)| is_chosen(&body.name));
        let bodies: Vec<BodyMotion> =
            chosen.map(|(index, body)| BodyMotion::new(index, body, plan, &request.wanted)).collect();
        for wanted in &request.wanted {
            if !bodies.iter().any(|body| body.can_show(*wanted)) {
                let recorded: Vec<_> = bodies.iter().flat_map(BodyMotion::recorded).map(|one| one.row().name).collect();
                return Err(PlotError::NotRecorded { what: wanted.name(), recorded: recorded.join(", ") });
            }
        }
        Ok(Self {
            bodies,
            is_one_of_one: heading.bodies.len() == 1,
            from_s: request.from_s.unwrap_or(f64::NEG_INFINITY),
            to_s: request.to_s.unwrap_or(f64::INFINITY),
        })
    }

    /// The next samples.
    pub fn add(&mut self, samples: &Samples) {
        let from = samples.times_s.partition_point(|time| *time < self.from_s);
        let to = samples.times_s.partition_point(|time| *time <= self.to_s);
        for body in &mut self.bodies {
            body.add(&samples.times_s, &samples.bodies[body.index], from..to.max(from));
        }
    }

    /// Whether any sample was within the times asked for.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.bodies.iter().all(BodyMotion::is_empty)
    }

    /// What could not be drawn, and why not.
    #[must_use]
    pub fn remarks(&self) -> Vec<String> {
        self.bodies.iter().flat_map(BodyMotion::remarks).collect()
    }

    /// The panels of each body, by name; charts of so many pixels across and down.
    #[must_use]
    pub fn panels(&self, chart: (f64, f64)) -> Vec<(&str, Vec<Drawing>)> {
        self.bodies.iter().map(|body| (body.name.as_str(), body.panels(chart))).collect()
    }

    /// All of it on one sheet under a title and lines of words.
    #[must_use]
    pub fn draw(&self, title: &str, words: &[String]) -> Drawing {
        if self.is_one_of_one {
            return grid(title, words, self.panels(CHART).into_iter().flat_map(|(_, panels)| panels).collect(), 2);
        }
        let blocks = self.panels(CHART).into_iter().map(|(name, panels)| grid(name, &[], panels, 2));
        grid(title, words, blocks.collect(), self.bodies.len().div_ceil(MOST_BELOW))
    }
}
