//! A whole run of a scene of 1,000 samples: in memory, and as each format.

use divan::Bencher;
use divan::counter::ItemsCount;
use polhode::recording::Recorder;
use polhode::scenario::{Plan, Scenario};

const SAMPLES: u32 = 1000;

fn plan() -> Plan {
    let assignments = ["duration_s=9.99".to_owned(), "sample_every_s=0.01".to_owned()];
    let scene = Scenario::named("dzhanibekov", &assignments).expect("it comes with the program");
    Plan::new(&scene).expect("it plans")
}

#[divan::bench]
fn in_memory(bencher: Bencher) {
    let plan = plan();
    bencher.counter(ItemsCount::new(SAMPLES)).bench_local(|| {
        let mut run = plan.start().expect("it starts");
        while run.next_batch().expect("it runs").is_some() {}
    });
}

#[divan::bench(args = ["csv", "mcap", "rrd"])]
fn recorded(bencher: Bencher, format: &str) {
    let (plan, folder) = (plan(), tempfile::tempdir().expect("a temporary folder"));
    let path = folder.path().join(format!("run.{format}"));
    bencher.counter(ItemsCount::new(SAMPLES)).bench_local(|| {
        let mut recorder = Recorder::create(&plan, &[&path], true).expect("a recorder");
        let mut run = plan.start().expect("it starts");
        while let Some(samples) = run.next_batch().expect("it runs") {
            recorder.write(samples).expect("it is written");
        }
        recorder.finish().expect("it is whole")
    });
}
