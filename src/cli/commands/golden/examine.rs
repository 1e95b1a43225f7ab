use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use super::error::GoldenError;
use super::finding::Finding;
use super::plan::plan;
use super::record::record;
use super::values;
use crate::cli::args::{FileFormat, GoldenArguments};
use crate::cli::folder::TemporaryFolder;
use crate::cli::interrupt;
use crate::scenario::{Plan, library};

/// What was found of a folder of goldens.
#[derive(Debug)]
pub struct Examination {
    /// Of each scene and format.
    pub findings: Vec<Finding>,
    /// Recordings that no scene makes; looked for where all scenes are meant.
    pub extra: Vec<PathBuf>,
    /// The hash of all values in the folder, as it was; where all scenes are meant and their goldens can be read.
    pub values_before: Option<String>,
    /// The same as it is now.
    pub values: Option<String>,
}

impl Examination {
    /// Whether everything is as the scenes give it now.
    pub fn is_same(&self) -> bool {
        self.extra.is_empty() && self.findings.iter().all(Finding::is_same)
    }

    /// Whether every value is as the scenes give it now, whatever bytes it is kept in.
    pub fn has_same_values(&self) -> bool {
        self.extra.is_empty() && !self.findings.iter().any(|finding| finding.standing.has_other_values())
    }
}

/// Runs every scene and holds its goldens to it; where asked to, writes those that differ.
pub fn examine(arguments: &GoldenArguments) -> Result<Examination, GoldenError> {
    let folder = &arguments.folder;
    let plans = plans(arguments)?;
    if arguments.bless {
        let failed = |source| GoldenError::Io { attempt: "make the folder", path: folder.clone(), source };
        fs::create_dir_all(folder).map_err(failed)?;
    } else if !folder.is_dir() {
        return Err(GoldenError::NoFolder { path: folder.clone() });
    }
    let fresh = TemporaryFolder::create("golden")?;
    let mut findings = Vec::new();
    for plan in &plans {
        if let Some(signal) = interrupt::signal() {
            return Err(GoldenError::Interrupted(signal));
        }
        let names: Vec<_> = arguments.format.iter().map(|format| file_name(&plan.name, *format)).collect();
        record(plan, &names.iter().map(|name| fresh.path().join(name)).collect::<Vec<_>>())?;
        for name in &names {
            findings.push(Finding::new(&plan.name, folder.join(name), &fresh.path().join(name))?);
        }
    }
    let is_all = arguments.scenes.is_empty();
    let values = || is_all.then(|| values_of(folder, &plans, arguments)).flatten();
    let values_before = values();
    // Only when all is known to be in order but the goldens.
    for finding in findings.iter().filter(|_| arguments.bless) {
        finding.bless(&fresh.path().join(finding.golden.file_name().unwrap_or_default()))?;
    }
    let extra = if is_all { extra(folder, &findings)? } else { Vec::new() };
    Ok(Examination { findings, extra, values_before, values: values() })
}

/// The hash of the values of all goldens, which are the same in every format.
fn values_of(folder: &Path, plans: &[Plan], arguments: &GoldenArguments) -> Option<String> {
    let format = *arguments.format.first()?;
    values::of(plans.iter().map(|plan| folder.join(file_name(&plan.name, format))))
}

fn file_name(scene: &str, format: FileFormat) -> String {
    format!("{scene}.{}", format.extension())
}

/// Every scene planned before any is run.
fn plans(arguments: &GoldenArguments) -> Result<Vec<Plan>, GoldenError> {
    let names = match &arguments.scenes_in {
        _ if !arguments.scenes.is_empty() => arguments.scenes.clone(),
        Some(folder) => scenes_in(folder)?,
        None => library::names().map(str::to_owned).collect(),
    };
    let mut plans: Vec<Plan> = Vec::new();
    for name in &names {
        let plan = plan(name)?;
        if plans.iter().any(|other| other.name == plan.name) {
            return Err(GoldenError::SameName(plan.name));
        }
        plans.push(plan);
    }
    Ok(plans)
}

/// The TOML files of a folder, in alphabetical order.
fn scenes_in(folder: &Path) -> Result<Vec<String>, GoldenError> {
    let is_scene = |path: &PathBuf| path.extension().is_some_and(|extension| extension == "toml");
    let name = |path: PathBuf| match path.to_str() {
        Some(name) => Ok(name.to_owned()),
        None => Err(GoldenError::NoText { path }),
    };
    let scenes = files(folder)?.into_iter().filter(is_scene).map(name).collect::<Result<Vec<_>, _>>()?;
    if scenes.is_empty() { Err(GoldenError::NoScenes { path: folder.into() }) } else { Ok(scenes) }
}

/// The recordings of `folder` that none of `findings` is about.
fn extra(folder: &Path, findings: &[Finding]) -> Result<Vec<PathBuf>, GoldenError> {
    let known: BTreeSet<_> = findings.iter().map(|finding| finding.golden.as_path()).collect();
    let extension = |path: &Path| path.extension().map(|extension| extension.to_string_lossy().into_owned());
    let is_recording =
        |path: &PathBuf| extension(path).is_some_and(|name| ["mcap", "rrd", "csv", "part"].contains(&&*name));
    let is_extra = |path: &PathBuf| is_recording(path) && !known.contains(path.as_path());
    Ok(files(folder)?.into_iter().filter(is_extra).collect())
}

fn files(folder: &Path) -> Result<Vec<PathBuf>, GoldenError> {
    let failed = |source| GoldenError::Io { attempt: "read the folder", path: folder.into(), source };
    let entries = fs::read_dir(folder).map_err(failed)?;
    let paths = entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<BTreeSet<_>, _>>();
    Ok(paths.map_err(failed)?.into_iter().collect())
}
