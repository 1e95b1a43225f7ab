use std::path::Path;

use thiserror::Error;

use super::execute::scenario;
use super::interrupt::{self, Signal};
use crate::propagation::PropagationError;
use crate::recording::{Conversion, Heading, Recording, RecordingError, Sampling, Subject};
use crate::scenario::{Plan, ScenarioError};
use crate::study::certify_body;
use crate::telemetry::{Channel, Samples};

/// A motion to look at: a recording, or a scene that is run in memory.
pub enum Source {
    /// The file, and what was read of it.
    Recording(Box<Conversion>, std::path::PathBuf),
    /// What will be run.
    Scene(Box<Plan>),
}

/// What is asked for by name.
#[derive(Debug, Clone, Default)]
pub struct Named<'a> {
    /// A recording, a scene or a TOML file.
    pub what: &'a str,
    /// The scene that a recording is of.
    pub scene: Option<&'a str>,
    /// Keys of the scene to change.
    pub set: &'a [String],
    /// What a scene is to record besides what it says.
    pub channels: &'a [Channel],
}

/// Why there is no motion to look at.
#[derive(Debug, Error)]
pub enum SourceError {
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    #[error(transparent)]
    Recording(#[from] RecordingError),
    #[error("cannot measure the checks: {0}")]
    Checks(PropagationError),
    #[error("cannot certify the motion: {0}")]
    Certificate(PropagationError),
    #[error("{0}: --scene is for a recording, and this is a scene")]
    SceneOfScene(String),
    #[error("{0}: --set is for a scene, and this is a recording; with --scene it changes that scene")]
    SetOfRecording(String),
    #[error("{0}: --certify is for a scene: a recording carries what was measured when it was made")]
    CertifyRecording(String),
    #[error("{0}: interrupted: nothing is written")]
    Interrupted(Signal),
    #[error("{0} is unfinished: `polhode recover` makes a whole recording of it")]
    Part(String),
}

impl Source {
    /// Plans a scene, or reads a recording once to see that it is sound.
    pub fn open(named: &Named<'_>) -> Result<Self, SourceError> {
        let path = Path::new(named.what);
        let extension = path.extension().and_then(|extension| extension.to_str());
        match extension {
            Some("part") => Err(SourceError::Part(named.what.to_owned())),
            Some("mcap" | "rrd" | "csv") => {
                let conversion = match named.scene {
                    Some(scene) => Conversion::with_plan(path, Plan::new(&scenario(scene, named.set)?)?)?,
                    None if named.set.is_empty() => Conversion::of(path)?,
                    None => return Err(SourceError::SetOfRecording(named.what.to_owned())),
                };
                Ok(Self::Recording(Box::new(conversion), path.into()))
            }
            _ if named.scene.is_some() => Err(SourceError::SceneOfScene(named.what.to_owned())),
            _ => Ok(Self::Scene(Box::new(planned(named)?))),
        }
    }

    /// Measures the checks of a scene, and with `is_certified` its error too; a recording has them.
    pub fn measured(self, is_certified: bool) -> Result<Self, SourceError> {
        match self {
            Self::Scene(plan) => {
                let mut plan = plan.checked().map_err(SourceError::Checks)?;
                if is_certified {
                    for body in &mut plan.bodies {
                        go_on()?;
                        body.certificate = Some(certify_body(body, &plan.grid).map_err(SourceError::Certificate)?);
                    }
                }
                Ok(Self::Scene(Box::new(plan)))
            }
            Self::Recording(_, path) if is_certified => Err(SourceError::CertifyRecording(path.display().to_string())),
            recording @ Self::Recording(..) => Ok(recording),
        }
    }

    /// What is to be run, or was, if the scene is known.
    pub fn plan(&self) -> Option<&Plan> {
        match self {
            Self::Recording(conversion, _) => conversion.plan(),
            Self::Scene(plan) => Some(plan),
        }
    }

    /// Bodies, provenance, certificates.
    pub fn heading(&self) -> Heading {
        match self {
            Self::Recording(conversion, _) => conversion.survey().heading.clone(),
            Self::Scene(plan) => Subject::of(plan).heading,
        }
    }

    /// How many samples, and when.
    pub fn sampling(&self) -> Sampling {
        match self {
            Self::Recording(conversion, _) => conversion.survey().sampling(),
            Self::Scene(plan) => Sampling::of(&plan.grid),
        }
    }

    /// One line: what this is.
    pub fn title(&self) -> String {
        match self {
            Self::Scene(plan) => plan.title.clone(),
            Self::Recording(conversion, path) => {
                let told = conversion.survey().heading.fact("title");
                let title = told.or_else(|| conversion.plan().map(|plan| plan.title.as_str()));
                let file = || path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                title.map_or_else(file, str::to_owned)
            }
        }
    }

    /// Why the scene of a recording is not known.
    pub fn remark(&self) -> Option<&str> {
        match self {
            Self::Recording(conversion, _) => conversion.remark(),
            Self::Scene(_) => None,
        }
    }

    /// Runs the scene, or reads the recording again; its samples are lent batch by batch.
    pub fn read(&self, take: &mut dyn FnMut(&Samples)) -> Result<(), SourceError> {
        match self {
            Self::Recording(_, path) => {
                let mut recording = Recording::open(path)?;
                while let Some(samples) = recording.next_batch()? {
                    go_on()?;
                    take(samples);
                }
            }
            Self::Scene(plan) => {
                let mut run = plan.start()?;
                while let Some(samples) = run.next_batch()? {
                    go_on()?;
                    take(samples);
                }
            }
        }
        Ok(())
    }
}

/// Refuses to go on if a signal has come.
fn go_on() -> Result<(), SourceError> {
    interrupt::signal().map_or(Ok(()), |signal| Err(SourceError::Interrupted(signal)))
}

/// The plan of a scene that records what it says, and `channels` besides.
fn planned(named: &Named<'_>) -> Result<Plan, ScenarioError> {
    let plan = Plan::new(&scenario(named.what, named.set)?)?;
    let recorded = |channel: &Channel| plan.bodies.iter().any(|body| body.channels.contains(channel));
    if named.channels.iter().all(recorded) {
        return Ok(plan);
    }
    // Said in the scene, so that they meet its rules.
    let all = Channel::ALL.into_iter().filter(|channel| recorded(channel) || named.channels.contains(channel));
    let names: Vec<_> = all.map(|channel| channel.row().name).collect();
    let mut set = named.set.to_vec();
    set.push(format!("channels={names:?}"));
    Plan::new(&scenario(named.what, &set)?)
}
