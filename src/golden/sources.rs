use std::path::Path;

use super::{GoldenError, Pose};
use crate::recording::{Heading, RecordedBody, Recording};
use crate::scenario::{BodySpec, Plan, PlannedBody, Scenario};
use crate::telemetry::{BodySamples, Channel};

/// The motion that a simulation is held to: when, and how the body stands and turns then.
#[derive(Debug, Clone, PartialEq)]
pub struct Golden {
    pub(super) name: String,
    pub(super) times_s: Vec<f64>,
    pub(super) poses: Vec<Pose>,
}

impl Golden {
    /// The recording at `path`, of its only body.
    ///
    /// # Errors
    /// If it cannot be read, is cut off, or of a format that this build leaves out; if it holds several bodies, no sample,
    /// or no attitude.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, GoldenError> {
        Self::read(path.as_ref(), None)
    }

    /// The same of the body called `body`.
    ///
    /// # Errors
    /// As [`Self::open`]; if there is no such body.
    pub fn open_body(path: impl AsRef<Path>, body: &str) -> Result<Self, GoldenError> {
        Self::read(path.as_ref(), Some(body))
    }

    /// The motion of `body` of `plan`, computed at the plan's sample times.
    ///
    /// # Errors
    /// If there is no such body, or its motion cannot be computed.
    pub fn planned(plan: &Plan, body: &str) -> Result<Self, GoldenError> {
        let names = || plan.bodies.iter().map(|body| body.name.clone()).collect();
        let found = plan.bodies.iter().find(|planned| planned.name == body);
        let found = found.ok_or_else(|| GoldenError::WhichBody { golden: plan.name.clone(), names: names() })?;
        Self::computed(plan, found)
    }

    /// The scene that comes with the crate under `name`, of its only body.
    ///
    /// # Errors
    /// If there is no such scene, it has several bodies, or its motion cannot be computed.
    #[cfg(feature = "serde")]
    pub fn scene(name: &str) -> Result<Self, GoldenError> {
        Self::only(&Plan::new(&Scenario::named(name, &[])?)?)
    }

    /// The scene in the TOML file at `path`, of its only body.
    ///
    /// # Errors
    /// If it cannot be read or planned, has several bodies, or its motion cannot be computed.
    #[cfg(feature = "serde")]
    pub fn scene_file(path: impl AsRef<Path>) -> Result<Self, GoldenError> {
        Self::only(&Plan::new(&Scenario::read(path.as_ref(), &[])?)?)
    }

    /// The exact motion of a body with these moments about its principal axes, kg m², on which no torque acts: it starts
    /// as `start` says and is compared every `every_s` for `duration_s`, s.
    ///
    /// # Errors
    /// If `start` does not say how it turns; if a number breaks a rule of scenes, such as moments that no body has.
    pub fn free(
        principal_moments_kg_m2: [f64; 3],
        start: Pose,
        duration_s: f64,
        every_s: f64,
    ) -> Result<Self, GoldenError> {
        let rates = start.angular_velocity_in_body().ok_or(GoldenError::NoAngularVelocity)?;
        let body = BodySpec {
            principal_moments_kg_m2: Some(principal_moments_kg_m2),
            attitude: Some(start.unit_wxyz()),
            angular_velocity_rad_s: Some(rates),
            ..BodySpec::default()
        };
        Self::only(&Plan::new(&Scenario {
            name: "a free body".into(),
            duration_s: Some(duration_s),
            sample_every_s: Some(every_s),
            body: vec![body],
            ..Scenario::default()
        })?)
    }

    /// What reports call it.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// When it is compared, s, ascending.
    #[must_use]
    pub fn times_s(&self) -> &[f64] {
        &self.times_s
    }

    /// How the body stands and turns at each of the times: the first is how a simulation is to start. The angular velocity
    /// is in body axes; a recording without one does not tell it.
    #[must_use]
    pub fn poses(&self) -> &[Pose] {
        &self.poses
    }

    fn read(path: &Path, body: Option<&str>) -> Result<Self, GoldenError> {
        let mut recording = Recording::open(path)?;
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let number = number_of(recording.heading(), &name, body)?;
        let mut golden = Self { name, times_s: Vec::new(), poses: Vec::new() };
        let called = recording.heading().bodies[number].name.clone();
        if bodies(recording.heading()).count() > 1 {
            golden.name = format!("{} ({called})", golden.name);
        }
        while let Some(samples) = recording.next_batch()? {
            golden.append(&samples.times_s, &samples.bodies[number], &called)?;
        }
        if !recording.is_whole() {
            return Err(GoldenError::Unfinished { path: path.into() });
        }
        golden.filled()
    }

    fn only(plan: &Plan) -> Result<Self, GoldenError> {
        match plan.bodies.as_slice() {
            [body] => Self::computed(plan, body),
            bodies => {
                let names = bodies.iter().map(|body| body.name.clone()).collect();
                Err(GoldenError::WhichBody { golden: plan.name.clone(), names })
            }
        }
    }

    fn computed(plan: &Plan, body: &PlannedBody) -> Result<Self, GoldenError> {
        let times_s: Vec<_> = (0..plan.grid.len()).map(|index| plan.grid.time(index)).collect();
        let samples = body.sample(&[Channel::Attitude, Channel::AngularVelocity], &times_s)?;
        let mut golden = Self { name: plan.name.clone(), times_s: Vec::new(), poses: Vec::new() };
        golden.append(&times_s, &samples, &body.name)?;
        golden.filled()
    }

    fn append(&mut self, times_s: &[f64], samples: &BodySamples, body: &str) -> Result<(), GoldenError> {
        let Some([w, x, y, z]) = samples.channel(Channel::Attitude) else {
            return Err(GoldenError::NoAttitude { golden: self.name.clone(), body: body.to_owned() });
        };
        let (rates, in_world) =
            (samples.channel(Channel::AngularVelocity), samples.channel(Channel::AngularVelocityWorld));
        self.times_s.extend_from_slice(times_s);
        self.poses.extend((0..times_s.len()).map(|row| {
            let pose = Pose::wxyz([w[row], x[row], y[row], z[row]]);
            match (rates, in_world) {
                (Some([x, y, z]), _) => pose.turning_in_body([x[row], y[row], z[row]]),
                (_, Some([x, y, z])) => pose.turning_in_world([x[row], y[row], z[row]]),
                _ => pose,
            }
        }));
        Ok(())
    }

    fn filled(self) -> Result<Self, GoldenError> {
        if self.poses.is_empty() { Err(GoldenError::Empty { golden: self.name }) } else { Ok(self) }
    }
}

/// A recording's bodies with their numbers: a point of one has no attitude.
fn bodies(heading: &Heading) -> impl Iterator<Item = (usize, &RecordedBody)> {
    heading.bodies.iter().enumerate().filter(|(_, body)| !body.is_point())
}

/// Which of a recording's bodies is meant.
fn number_of(heading: &Heading, golden: &str, body: Option<&str>) -> Result<usize, GoldenError> {
    let mut known = bodies(heading);
    let found = match body {
        Some(name) => known.find(|(_, body)| body.name == name),
        None => known.next().filter(|_| bodies(heading).count() == 1),
    };
    let found = found.map(|(number, _)| number);
    let names = || bodies(heading).map(|(_, body)| body.name.clone()).collect();
    found.ok_or_else(|| GoldenError::WhichBody { golden: golden.to_owned(), names: names() })
}
