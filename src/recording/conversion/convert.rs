use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::fit::{RECOVERED, check_values, fitted, tells_scene};
use super::plain::{converted, plain};
use super::scene;
use crate::recording::picture::Picture;
use crate::recording::recorder::draws;
use crate::recording::{
    Finished, Interruption, PartFile, Recorder, Recording, RecordingError, Subject, Survey, subject,
};
use crate::scenario::Plan;

/// A recording that is to be written anew, in any format: every channel to the bit.
///
/// It is read twice: once to its end, to see that it is sound, and once to write it.
///
/// ```no_run
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let conversion = polhode::recording::Conversion::of("spin.mcap".as_ref())?;
/// conversion.write(&["spin.rrd", "spin.csv"], false)?;
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Conversion {
    path: PathBuf,
    survey: Survey,
    plan: Option<Plan>,
    facts: BTreeMap<String, String>,
    remark: Option<String>,
}

impl Conversion {
    /// Of the whole recording at `path`, with the scene that it carries. If it carries none, or one that this version
    /// refuses or that does not fit its columns, only columns and words are converted, and [`Self::remark`] says why.
    ///
    /// # Errors
    /// As [`Recording::open`] and [`Recording::next_batch`]; if its end is missing.
    pub fn of(path: &Path) -> Result<Self, RecordingError> {
        let survey = whole(path)?;
        Ok(match carried(path, &survey, false) {
            Ok(plan) => Self::planned(path, survey, plan),
            Err(remark) => {
                let facts = converted(path, &survey);
                Self { path: path.into(), survey, plan: None, facts, remark: Some(remark) }
            }
        })
    }

    /// The same with `plan` for its scene.
    ///
    /// # Errors
    /// As [`Self::of`]; if the plan does not fit what is recorded.
    pub fn with_plan(path: &Path, plan: Plan) -> Result<Self, RecordingError> {
        let survey = whole(path)?;
        let plan = fitted(plan, &survey, false).and_then(|plan| {
            if !tells_scene(&survey.heading) {
                check_values(&plan, &survey, path)?;
            }
            Ok(plan)
        });
        let plan = plan.map_err(|reason| RecordingError::OtherScene { path: path.into(), reason })?;
        Ok(Self::planned(path, survey, plan))
    }

    /// Of what there is of a run that was cut off.
    pub(super) fn of_part(path: &Path, survey: Survey) -> Self {
        let (kept, to_s) = (survey.sampling().samples, survey.sampling().to_s);
        let planned = survey.heading.planned_samples();
        let is_cut_off = !survey.is_whole;
        let (plan, remark) = match carried(path, &survey, is_cut_off) {
            Ok(plan) => (Some(plan), None),
            Err(remark) => (None, Some(remark)),
        };
        let mut facts: BTreeMap<_, _> = survey.heading.provenance.iter().cloned().collect();
        if plan.is_none() {
            facts.extend(subject::conventions());
        }
        if planned != Some(kept) {
            facts.insert(RECOVERED.into(), Interruption { samples: kept, planned, to_s }.in_words());
            facts.insert("samples".into(), kept.to_string());
            let identity = plan.as_ref().and_then(|plan| subject::sha256(&plan.identity));
            facts.extend(identity.map(|hash| ("identity_sha256".into(), hash)));
        }
        Self { path: path.into(), survey, plan, facts, remark }
    }

    fn planned(path: &Path, survey: Survey, plan: Plan) -> Self {
        let facts = if tells_scene(&survey.heading) {
            survey.heading.provenance.iter().cloned().collect()
        } else {
            let mut facts = converted(path, &survey);
            facts.extend(subject::of_plan(&plan));
            facts
        };
        Self { path: path.into(), survey, plan: Some(plan), facts, remark: None }
    }

    /// The plan made anew of its scene, if there is one that fits.
    #[must_use]
    pub fn plan(&self) -> Option<&Plan> {
        self.plan.as_ref()
    }

    /// Why there is no plan.
    #[must_use]
    pub fn remark(&self) -> Option<&str> {
        self.remark.as_deref()
    }

    /// What was read.
    #[must_use]
    pub fn survey(&self) -> &Survey {
        &self.survey
    }

    /// Writes it to each path, the format by extension: all or none, as a [`Recorder`] does.
    ///
    /// # Errors
    /// As [`Recorder::create`], [`Recorder::finish`] and [`Recording::next_batch`].
    pub fn write(&self, paths: &[impl AsRef<Path>], overwrite: bool) -> Result<Vec<Finished>, RecordingError> {
        self.write_to(Recorder::claim(paths, overwrite)?)
    }

    pub(super) fn write_to(&self, files: Vec<PartFile>) -> Result<Vec<Finished>, RecordingError> {
        let plan = self.plan.as_ref();
        let picture = plan.filter(|_| draws(&files)).map(Picture::of).transpose()?;
        let subject = self.subject(picture.as_ref())?;
        let mut recorder = Recorder::begin(&subject, files)?;
        let mut recording = Recording::open(&self.path)?;
        let mut samples = 0;
        while let Some(batch) = recording.next_batch()? {
            samples += batch.len() as u64;
            recorder.write(batch)?;
        }
        if *recording.heading() != self.survey.heading || samples != self.survey.sampling().samples {
            let reason = "it changed while it was read".into();
            return Err(RecordingError::Decode { path: self.path.clone(), reason });
        }
        recorder.finish()
    }

    fn subject<'a>(&'a self, picture: Option<&'a Picture>) -> Result<Subject<'a>, RecordingError> {
        let Some(plan) = &self.plan else { return plain(&self.path, &self.survey, self.facts.clone()) };
        let mut subject = picture.map_or_else(|| Subject::of(plan), |picture| Subject::drawn(plan, picture));
        subject.heading.provenance = self.facts.clone().into_iter().collect();
        Ok(subject)
    }
}

/// Reads a recording to its end, which must be there.
fn whole(path: &Path) -> Result<Survey, RecordingError> {
    let survey = Survey::of(&mut Recording::open(path)?)?;
    if !survey.is_whole {
        let reason = "its end is missing: `polhode recover` makes a whole recording of it".into();
        return Err(RecordingError::Decode { path: path.into(), reason });
    }
    Ok(survey)
}

/// The plan of the scene that a recording carries, or why there is none.
fn carried(path: &Path, survey: &Survey, is_cut_off: bool) -> Result<Plan, String> {
    let heading = &survey.heading;
    let text = heading.scene.as_deref().ok_or("it carries no scene")?;
    let name = heading.fact("scene").unwrap_or("scene");
    let folder = path.parent().unwrap_or(Path::new(""));
    let plan = scene::plan(text, name, folder).map_err(|error| format!("its scene cannot be planned: {error}"))?;
    fitted(plan, survey, is_cut_off).map_err(|reason| format!("its scene is not that of its columns: {reason}"))
}
