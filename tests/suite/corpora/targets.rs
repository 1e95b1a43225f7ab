//! What each fuzz target does with its bytes. The crate in `fuzz/` compiles this, and so do the tests, which do it again
//! with the bytes that fuzzing has found.
//!
//! An error is an answer; a panic, a hang or a heap without bounds is none. What is not refused must hold what it says.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use polhode::body::{Attitude, TriangleMesh};
use polhode::dynamics::formula::Expression;
use polhode::dynamics::{FormulaLoad, FormulaPlace, General, Problem, Profile, Symbols, Torque};
use polhode::numerics::{Expansion, Tape};
use polhode::propagation::States;
use polhode::recording::foreign::{Mapping, Observation, observe};
use polhode::recording::{Observed, Recording, RecordingError, Track, contents};
use polhode::scenario::{Grid, Plan, Scenario};
use polhode::telemetry::BodySamples;

/// One of the files that a target rewrites for every input.
pub struct Scratch {
    folder: PathBuf,
}

impl Scratch {
    /// In `folder`, which should be in memory: inputs come by the thousand a second.
    pub fn new(folder: &Path) -> Self {
        Self { folder: folder.into() }
    }

    fn file(&self, name: &str, bytes: &[u8]) -> PathBuf {
        let path = self.folder.join(name);
        fs::write(&path, bytes).expect("room for an input");
        path
    }
}

/// What a target does with its bytes.
pub type Target = fn(&Scratch, &[u8]);

/// Every target by the name of its corpus.
pub const TARGETS: &[(&str, Target)] = &[
    ("csv", csv),
    ("foreign", foreign),
    ("formula", formula),
    #[cfg(feature = "mcap")]
    ("mcap", mcap),
    ("obj", obj),
    #[cfg(feature = "rerun")]
    ("rrd", rrd),
    ("scene", scene),
    ("set", set),
    ("stl", stl),
];

/// A scene as text.
pub fn scene(_: &Scratch, bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if let Ok(scenario) = Scenario::parse(text, "fuzz.toml", &[]) {
        plan(&scenario);
    }
}

/// Assignments as `--set` takes them, one a line, to a scene that comes with the program: the first line says which.
pub fn set(_: &Scratch, bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let mut lines = text.lines().map(str::to_owned);
    let name = lines.next().unwrap_or_default();
    if let Ok(scenario) = Scenario::named(&name, &lines.collect::<Vec<_>>()) {
        plan(&scenario);
    }
}

/// A formula as text: what is read lays out as operations, whose series to a low order come to an end.
pub fn formula(_: &Scratch, bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    match Expression::read(text) {
        Ok(expression) => {
            let components = [Expression::Number(0.0), expression.clone(), expression];
            let place = FormulaPlace::Moment;
            let body_from_principal = Attitude::identity().world_from_body();
            let kind = General::Formula(FormulaLoad { components, in_world: true, place, body_from_principal });
            let mut tape = Tape::new(Symbols::INPUTS);
            let symbols = Symbols::on(&mut tape);
            kind.lay_out(&mut tape, &symbols).moment.into_iter().for_each(|node| tape.want(node));
            let mut expansion = Expansion::<f64>::new(&tape, 3);
            expansion.set(0, 1, 1.0);
            expansion.expand(&tape, 3);
            let switch = expansion.first_switch(&tape, 3, 1.0);
            assert!(switch.is_none_or(|sigma| sigma > 0.0 && sigma <= 1.0), "{switch:?}");
        }
        Err(error) => assert!((1..=text.chars().count() + 1).contains(&error.column), "{error}"),
    }
}

/// A mesh as STL.
pub fn stl(scratch: &Scratch, bytes: &[u8]) {
    mesh(&scratch.file("fuzz.stl", bytes));
}

/// A mesh as OBJ.
pub fn obj(scratch: &Scratch, bytes: &[u8]) {
    mesh(&scratch.file("fuzz.obj", bytes));
}

/// A recording as a table.
pub fn csv(scratch: &Scratch, bytes: &[u8]) {
    recording(scratch, bytes, "fuzz.csv");
}

/// A recording as `.mcap`.
#[cfg(feature = "mcap")]
pub fn mcap(scratch: &Scratch, bytes: &[u8]) {
    recording(scratch, bytes, "fuzz.mcap");
}

/// A recording as `.rrd`.
#[cfg(feature = "rerun")]
pub fn rrd(scratch: &Scratch, bytes: &[u8]) {
    recording(scratch, bytes, "fuzz.rrd");
}

/// A file of another program, with what its reader says of it: its extension in the first line, then a mapping up to a line
/// of three hyphens (none: no mapping), then its bytes.
pub fn foreign(scratch: &Scratch, bytes: &[u8]) {
    let Some((extension, rest)) = split(bytes, b"\n") else { return };
    let (text, content) = split(rest, b"---\n").unwrap_or((b"", rest));
    let known = ["csv", "dat", "mcap", "rrd", "tsv", "txt"];
    let Some(extension) = known.into_iter().find(|name| name.as_bytes() == extension) else { return };
    let Ok(mapping) = Mapping::read(&scratch.file("fuzz.toml", text)) else { return };
    if let Ok(found) = observe(&scratch.file(&format!("fuzz.{extension}"), content), &mapping) {
        told(&found);
    }
}

/// What stands before the first `mark`, and behind it.
fn split<'a>(bytes: &'a [u8], mark: &[u8]) -> Option<(&'a [u8], &'a [u8])> {
    let place = bytes.windows(mark.len()).position(|window| window == mark)?;
    Some((&bytes[..place], &bytes[place + mark.len()..]))
}

/// There are bodies, each tells something under a name of its own, and every number can be reckoned with.
fn told(found: &Observation) {
    assert!(!found.bodies.is_empty() && found.time_resolution_s.is_finite() && found.time_resolution_s >= 0.0);
    let names: BTreeSet<&str> = found.bodies.iter().map(|body| body.name.as_str()).collect();
    assert_eq!(names.len(), found.bodies.len(), "{names:?}");
    for Observed { attitude, angular_velocity, angular_momentum, moment, position, velocity, .. } in &found.bodies {
        let vectors = [angular_velocity, angular_momentum, moment, position, velocity];
        assert!(attitude.is_some() || vectors.iter().any(|track| track.is_some()));
        attitude.iter().for_each(ascending);
        vectors.into_iter().flatten().for_each(ascending);
    }
}

/// Times ascend, no column is shorter, and no number is not finite.
fn ascending<const N: usize>(track: &Track<N>) {
    assert!(!track.times_s.is_empty() && track.times_s.windows(2).all(|pair| pair[0] < pair[1]));
    assert!(track.columns.iter().all(|column| column.len() == track.times_s.len()));
    assert!(track.columns.iter().chain([&track.times_s]).flatten().all(|number| number.is_finite()));
    assert!(track.resolution.is_finite() && track.resolution >= 0.0);
}

/// As a whole recording, and as what a killed run left.
fn recording(scratch: &Scratch, bytes: &[u8], name: &str) {
    for name in [name.to_owned(), format!("{name}.part")] {
        let path = scratch.file(&name, bytes);
        let columns = columns(&path);
        if let Ok(contents) = contents(&path) {
            // Whoever says that there are columns has read them.
            assert!(contents.survey.is_none() || columns.is_ok(), "{:?}", columns.err());
        }
    }
}

/// Reads all samples. Times ascend, and no column is shorter than another.
fn columns(path: &Path) -> Result<(), RecordingError> {
    let mut recording = Recording::open(path)?;
    let (mut last, mut count) = (f64::NEG_INFINITY, 0);
    while let Some(samples) = recording.next_batch()? {
        assert_eq!(samples.first_index, count);
        count += samples.len() as u64;
        for time in &samples.times_s {
            assert!(time.is_finite() && *time > last, "{time} s after {last} s");
            last = *time;
        }
        let columns = samples.bodies.iter().flat_map(BodySamples::columns);
        assert!(
            columns.clone().all(|column| column.len() == samples.len()) && samples.stamps_ns.len() == samples.len()
        );
    }
    Ok(())
}

/// A mesh that is read has triangles of its own finite vertices; one that encloses a volume has that of a body.
fn mesh(path: &Path) {
    let Ok(mesh) = TriangleMesh::read(path, 1e-3) else { return };
    assert!(!mesh.triangles.is_empty());
    assert!(mesh.triangles.iter().flatten().all(|corner| (*corner as usize) < mesh.vertices.len()));
    assert!(mesh.vertices.iter().flatten().all(|value| value.is_finite()));
    if let Ok(properties) = mesh.mass_properties(1000.0) {
        assert!(mesh.check_closed().is_ok() && properties.mass.is_some_and(|mass| mass > 0.0 && mass.is_finite()));
    }
}

/// Plans a scene, and begins the motion of each body.
fn plan(scenario: &Scenario) {
    let Ok(plan) = Plan::new(scenario) else { return };
    assert!(!plan.bodies.is_empty() && !plan.grid.is_empty());
    for body in &plan.bodies {
        let Ok(mut motion) = body.propagator() else { continue };
        let mut states = States::default();
        if motion.fill(&first_times(&plan.grid, &body.problem), &mut states).is_ok() {
            finite(&states);
        }
    }
}

/// Up to three times of the run, but no more of it than about a radian: how long it takes is up to its author.
fn first_times(grid: &Grid, problem: &Problem) -> [f64; 3] {
    let end = grid.end().min(1.0 / pace(problem));
    [0.0, 0.5 * end, end]
}

/// How fast things happen to the body at most, 1/s, whenever they do.
fn pace(problem: &Problem) -> f64 {
    let moments = problem.moments.vector();
    let (smallest, largest) = (moments.min(), moments.max());
    let turning = |moment: f64| (moment / smallest).sqrt();
    let loads = problem.loads.iter().map(|load| match load.torque {
        Torque::ConstantBody { moment } | Torque::ConstantWorld { moment } => turning(moment.norm()),
        Torque::LinearDamping { coefficient } => coefficient / smallest,
        Torque::MomentumBrake { rate } => rate,
        Torque::ForceBody { force, arm } | Torque::ForceWorld { force, arm } => turning(force.norm() * arm.norm()),
        Torque::ProfileBody { ref moment } | Torque::ProfileWorld { ref moment } => turning(largest_of(moment)),
        Torque::ForceProfileBody { ref force, arm } | Torque::ForceProfileWorld { ref force, arm } => {
            turning(largest_of(force) * arm.norm())
        }
        Torque::Rotor { ref momentum } => largest_of(momentum) / smallest,
        Torque::MagneticDipole { dipole, field } => turning(dipole.norm() * field.norm()),
        Torque::GravityGradient { mean_motion } => mean_motion * (1.0 + turning(largest)),
        // Whatever its author wrote: not a step of it.
        Torque::General(_) => f64::INFINITY,
    });
    let spin = problem.initial.angular_velocity.in_body().norm() * largest / smallest;
    loads.sum::<f64>() + spin
}

/// Of a function of time, at its knots.
fn largest_of(profile: &Profile) -> f64 {
    profile.knots().iter().map(|knot| profile.at(*knot).norm()).fold(0.0, f64::max)
}

/// Nothing that is not finite comes without an error, and attitudes are of unit length.
fn finite(states: &States) {
    let vectors = [&states.angular_velocity, &states.position, &states.velocity];
    let numbers = vectors.into_iter().flatten().chain(&states.attitude).flatten();
    assert!(numbers.clone().all(|number| number.is_finite()), "{states:?}");
    for row in 0..states.attitude[0].len() {
        let length: f64 = states.attitude.iter().map(|column| column[row] * column[row]).sum();
        assert!((length - 1.0).abs() < 1e-14, "{states:?}");
    }
}
