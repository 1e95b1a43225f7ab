//! Formats and channels of a whole run: the scene `dzhanibekov`, 4096 samples.

use std::path::{Path, PathBuf};
use std::rc::Rc;

use polhode::recording::Recorder;
use polhode::scenario::{Plan, Scenario};
use polhode::telemetry::Channel;

use super::{Pair, Work};

pub fn pairs(folder: &Path) -> Vec<Pair> {
    let usual = plan(None);
    // A T-handle has no axis of symmetry that could lean.
    let has_meaning = |channel: &Channel| !matches!(channel, Channel::Tilt | Channel::PrecessionRate);
    let every = Channel::ALL.into_iter().filter(has_meaning).map(|channel| channel.row().name);
    let every: Vec<&str> = every.collect();
    let rates = ["angular_velocity", "angular_momentum_body"];
    let with_attitude = ["attitude", "angular_velocity", "angular_momentum_body"];
    let constant = ["attitude", "angular_velocity", "rotational_energy"];
    let of = |channels: &[&str], extensions: &[&str]| run(&plan(Some(channels)), folder, extensions);
    let both = ["mcap", "rrd"];
    let pair = |left_out, of, with, without| Pair { left_out, of, with, without };
    let usually = |extensions: &[&str]| run(&usual, folder, extensions);
    vec![
        pair(".rrd", "a run to .mcap and .rrd", usually(&both), usually(&["mcap"])),
        pair(".mcap", "a run to .mcap and .rrd", usually(&both), usually(&["rrd"])),
        pair("both", "a run to .mcap and .rrd", usually(&both), usually(&[])),
        pair(".csv", "a run to .csv", usually(&["csv"]), usually(&[])),
        pair(
            "what the scene does not make interesting",
            "a run with every channel, to both",
            of(&every, &both),
            usually(&both),
        ),
        pair("the same", "a run with every channel, to .mcap", of(&every, &["mcap"]), usually(&["mcap"])),
        pair("the same", "a run with every channel, to .rrd", of(&every, &["rrd"]), usually(&["rrd"])),
        pair("the same", "a run with every channel, in memory", of(&every, &[]), usually(&[])),
        pair("attitude, and pictures with it", "a run to both", of(&with_attitude, &both), of(&rates, &both)),
        pair(
            "a constant at every sample",
            "a run to both, three channels",
            of(&constant, &both),
            of(&constant[..2], &both),
        ),
    ]
}

/// The scene with some channels, or with its own.
fn plan(channels: Option<&[&str]>) -> Rc<Plan> {
    let mut assignments = vec!["duration_s=40.95".to_owned(), "sample_every_s=0.01".to_owned()];
    assignments.extend(channels.map(|channels| format!("channels={channels:?}")));
    let scene = Scenario::named("dzhanibekov", &assignments).expect("it comes with the program");
    Rc::new(Plan::new(&scene).expect("it plans"))
}

/// A whole run, recorded in some formats or in none.
fn run(plan: &Rc<Plan>, folder: &Path, extensions: &[&str]) -> Work {
    let plan = Rc::clone(plan);
    let paths: Vec<PathBuf> = extensions.iter().map(|extension| folder.join(format!("run.{extension}"))).collect();
    Box::new(move || {
        let mut recorder = Recorder::create(&plan, &paths, true).expect("a recorder");
        let mut run = plan.start().expect("it starts");
        while let Some(samples) = run.next_batch().expect("it runs") {
            recorder.write(samples).expect("it is written");
        }
        recorder.finish().expect("it is whole");
    })
}
