//! Formats and channels of a whole run: the scene `dzhanibekov`, 4096 samples.

use std::path::{Path, PathBuf};
use std::rc::Rc;

use polhode::recording::Recorder;
use polhode::scenario::{Plan, Scenario, ScenarioError};
use polhode::telemetry::Channel;

use super::{Pair, Work};

pub fn pairs(folder: &Path) -> Vec<Pair> {
    let usual = plan(None);
    // A T-handle has no axis of symmetry that could lean, and no integral of tops or orbits.
    let has_meaning = |name: &&str| planned(Some(&[*name])).is_ok();
    let every: Vec<&str> = Channel::ALL.into_iter().map(|channel| channel.row().name).filter(has_meaning).collect();
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
        pair(
            "two probes and two IMUs",
            "a run of the box, in memory",
            run(&imu(4), folder, &[]),
            run(&imu(0), folder, &[]),
        ),
    ]
}

/// The scene with some channels, or with its own.
fn plan(channels: Option<&[&str]>) -> Rc<Plan> {
    Rc::new(planned(channels).expect("it plans"))
}

fn planned(channels: Option<&[&str]>) -> Result<Plan, ScenarioError> {
    let mut assignments = vec!["duration_s=40.95".to_owned(), "sample_every_s=0.01".to_owned()];
    assignments.extend(channels.map(|channels| format!("channels={channels:?}")));
    let scene = Scenario::named("dzhanibekov", &assignments).expect("it comes with the program");
    Plan::new(&scene)
}

/// A box with four points beside it, or without.
fn imu(points: usize) -> Rc<Plan> {
    let scene = Scenario::named("imu_on_a_tumbling_box", &[]).expect("it comes with the program");
    let mut plan = Plan::new(&scene).expect("it plans");
    for body in &mut plan.bodies {
        body.points.truncate(points);
    }
    Rc::new(plan)
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
