use std::collections::BTreeMap;

use super::stamped::{Stamped, start_of};
use super::{Place, Statement};
use crate::recording::foreign::{Mapping, Observation, attitudes};
use crate::recording::{Axes, Observed, Track};

/// Most bodies.
pub(in crate::recording) const MOST_BODIES: usize = 65_535;

/// The bodies that messages tell of.
#[derive(Debug, Default)]
pub(in crate::recording) struct Gathering {
    /// Where each stands among the bodies.
    places: BTreeMap<Place, usize>,
    pub(super) bodies: Vec<Gathered>,
    pub(super) remarks: Vec<String>,
    only: Option<String>,
    world: Option<String>,
}

/// What is told of one body.
#[derive(Debug, Default)]
pub(super) struct Gathered {
    pub place: Place,
    pub attitude: Stamped<4>,
    pub position: Stamped<3>,
    pub angular_velocity: Stamped<3>,
    pub moment: Stamped<3>,
    pub velocity: Stamped<3>,
    /// Of the last three; `None` where frames do not tell.
    pub axes: Option<Axes>,
    /// Whether the signs of its attitudes are open.
    pub is_of_either_sign: bool,
    /// Half a unit in the last place of its numbers, relative.
    pub resolution: f64,
}

impl Gathering {
    /// Of what the mapping asks for.
    pub fn new(mapping: &Mapping) -> Self {
        Self { only: mapping.frame.clone(), world: mapping.world.clone(), ..Self::default() }
    }

    /// Takes in what a message says.
    ///
    /// # Errors
    /// If it is not finite, or there are too many bodies.
    pub fn take(&mut self, statement: &Statement) -> Result<(), String> {
        if self.world.is_some() && statement.place.fixed.is_some() && statement.place.fixed != self.world {
            return Ok(());
        }
        if !statement.tells() {
            return Ok(());
        }
        let number = match self.places.get(&statement.place) {
            Some(number) => *number,
            None if self.bodies.len() == MOST_BODIES => return Err(format!("more than {MOST_BODIES} bodies")),
            None => {
                let place = statement.place.clone();
                self.bodies.push(Gathered { place: place.clone(), ..Gathered::default() });
                self.places.insert(place, self.bodies.len() - 1);
                self.bodies.len() - 1
            }
        };
        let body = &mut self.bodies[number];
        body.resolution = body.resolution.max(statement.resolution);
        body.is_of_either_sign |= statement.is_of_either_sign;
        let (stamp, log) = (statement.stamp_ns.unwrap_or(0), statement.log_ns);
        let taken = [
            statement.attitude.map(|value| ("attitude", body.attitude.push(stamp, log, value))),
            statement.position.map(|value| ("position", body.position.push(stamp, log, value))),
            statement.angular_velocity.map(|value| ("angular velocity", body.angular_velocity.push(stamp, log, value))),
            statement.moment.map(|value| ("moment", body.moment.push(stamp, log, value))),
            statement.velocity.map(|value| ("velocity", body.velocity.push(stamp, log, value))),
        ];
        match taken.into_iter().flatten().find_map(|(what, taken)| Some((what, taken.err()?))) {
            Some((what, reason)) => Err(format!("the {what} of {:?} {reason}", body.place.name())),
            None => Ok(()),
        }
    }

    /// A sentence for the reader.
    pub fn remark(&mut self, remark: String) {
        if !self.remarks.contains(&remark) {
            self.remarks.push(remark);
        }
    }

    /// Whether nothing was said of any body.
    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }

    /// The bodies that move, rates joined to the frames that they belong to.
    ///
    /// # Errors
    /// If none is left, or the times of one do not ascend.
    pub fn observation(mut self) -> Result<Observation, String> {
        self.join_rates();
        self.leave_what_rests();
        self.leave_what_is_not_asked_for()?;
        let first = self.bodies.iter().filter_map(Gathered::first_ns).min().ok_or("no body in it moves")?;
        let start_ns = start_of(first);
        let names = self.names();
        let bodies = self.bodies.into_iter().zip(names).map(|(body, name)| body.into_observed(name, start_ns));
        let observation = Observation {
            bodies: bodies.collect::<Result<_, _>>()?,
            start_ns,
            time_resolution_s: 5e-10,
            remarks: self.remarks,
        };
        observation.claim_names()?;
        Ok(observation)
    }

    /// What the bodies are called: with the frame that they are told in, where they are told in several.
    fn names(&self) -> Vec<String> {
        let mut counts: BTreeMap<String, usize> = BTreeMap::new();
        for body in &self.bodies {
            *counts.entry(body.place.name()).or_default() += 1;
        }
        let name = |body: &Gathered| match (body.place.name(), &body.place.fixed) {
            (name, Some(fixed)) if counts.get(&name).is_some_and(|count| *count > 1) => format!("{name} in {fixed}"),
            (name, _) => name,
        };
        self.bodies.iter().map(name).collect()
    }

    /// A frame that is told once is fixed to another, as `/tf_static` says it.
    fn leave_what_rests(&mut self) {
        let rests = |body: &Gathered| body.longest() < 2;
        if self.bodies.iter().all(rests) {
            return;
        }
        let names: Vec<_> = self.bodies.iter().filter(|body| rests(body)).map(|body| body.place.name()).collect();
        if !names.is_empty() {
            self.remark(format!("told once, so taken to rest: {}", names.join(", ")));
        }
        self.bodies.retain(|body| !rests(body));
    }

    fn leave_what_is_not_asked_for(&mut self) -> Result<(), String> {
        let Some(only) = &self.only else { return Ok(()) };
        let is_it = |body: &Gathered| body.place.name() == *only || body.place.moving.as_ref() == Some(only);
        if !self.bodies.iter().any(is_it) {
            let names: Vec<_> = self.bodies.iter().map(|body| body.place.name()).collect();
            return Err(format!("it tells of no {only:?}, only of {}", names.join(", ")));
        }
        self.bodies.retain(is_it);
        Ok(())
    }
}

impl Gathered {
    /// How many values the quantity has that is told most often.
    fn longest(&self) -> usize {
        let vectors = [&self.position, &self.angular_velocity, &self.moment, &self.velocity];
        vectors.into_iter().map(Stamped::len).fold(self.attitude.len(), usize::max)
    }

    fn first_ns(&self) -> Option<i64> {
        let vectors = [&self.position, &self.angular_velocity, &self.moment, &self.velocity];
        let stamps = vectors.into_iter().filter_map(|vector| vector.stamps().iter().min());
        stamps.chain(self.attitude.stamps().iter().min()).min().copied()
    }

    fn into_observed(mut self, name: String, start_ns: i64) -> Result<Observed, String> {
        let resolution = self.resolution;
        if self.is_of_either_sign {
            attitudes::continue_signs(self.attitude.columns_mut());
        }
        let wrong = |what: &str, reason: String| format!("the {what} of {name:?} {reason}");
        let vector = |what: &str, stamped: Stamped<3>, axes| -> Result<Option<Track<3>>, String> {
            let is_told = stamped.len() > 0;
            let track = stamped.into_track(start_ns, axes, resolution).map_err(|reason| wrong(what, reason))?;
            Ok(is_told.then_some(track))
        };
        let has_attitude = self.attitude.len() > 0;
        let attitude = self.attitude.into_track(start_ns, None, resolution);
        let attitude = attitude.map_err(|reason| wrong("attitude", reason))?;
        Ok(Observed {
            attitude: has_attitude.then_some(attitude),
            angular_velocity: vector("angular velocity", self.angular_velocity, self.axes)?,
            angular_momentum: None,
            moment: vector("moment", self.moment, self.axes)?,
            position: vector("position", self.position, Some(Axes::World))?,
            velocity: vector("velocity", self.velocity, self.axes)?,
            name,
        })
    }
}
