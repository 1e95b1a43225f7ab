//! What is asked: flags and their help, one file for each group of commands.

mod bench;
mod compare;
mod golden;
mod overrides;
mod pictures;
mod recordings;
mod run;
mod scenes;
mod stress;
mod verify;

use clap::{Parser, Subcommand};

pub(super) use bench::BenchArguments;
pub(super) use compare::{CompareArguments, DigestArguments};
pub(super) use golden::GoldenArguments;
pub(super) use overrides::Overrides;
pub(super) use pictures::{PlotArguments, ReportArguments};
pub(super) use recordings::{ConvertArguments, InspectArguments, RecoverArguments, ViewArguments};
pub(super) use run::{FileFormat, RunArguments};
pub(super) use scenes::{CheckArguments, ListArguments, NewArguments, PlanArguments, Template};
pub(super) use stress::{Shown, StressArguments};
pub(super) use verify::VerifyArguments;

const EXAMPLES: &str = "\
Examples:
  polhode list                                    what scenes there are
  polhode new my_scene --template pivot           a scene to begin with; --from lagrange_top copies that one
  polhode check my_scene.toml                     is it sound, by which path would it run, at what cost?
  polhode run dzhanibekov                         recordings/dzhanibekov.mcap, .layout.json and .rrd
  polhode run --all --out out --force             every scene
  polhode run my_scene.toml --format csv          a scene of your own, as a table
  polhode run dzhanibekov --duration 90 --sample-every 0.001
  polhode run my_scene.toml --set 'body.0.angular_velocity_rad_s=[0, 6, 0.1]'
  polhode run lagrange_top --certify              with its measured error, printed and recorded
  polhode plan lagrange_top                       which method, why, and what is skipped
  polhode run dzhanibekov --live                  into a Rerun viewer that is open
  polhode bench dzhanibekov --plot costs.svg      what each method costs for how much accuracy
  polhode stress --plot stress.svg                every method against what breaks methods
  polhode inspect recordings/dzhanibekov.mcap     what is in a recording
  polhode verify engine.csv --map engine.toml --principal-moments 1,2,3
                                                  is a program's rotation right, and if not, why?
  polhode convert run.mcap run.rrd run.csv        the same recording in other formats, to the bit
  polhode compare a.mcap b.rrd                    are they the same motion? where, since when, and how do they part?
  polhode compare run.mcap dzhanibekov --exact    does the scene still give this recording, to the bit?
  polhode digest run.mcap run.csv                 SHA-256 of the content, the same in every format
  polhode recover recordings/run.mcap.part        a whole recording of what a killed run left
  polhode plot recordings/dzhanibekov.mcap -o dzhanibekov.svg      its motion as plots, without a viewer
  polhode plot lagrange_top --channels tilt,axis_path -o top.png   of a scene, only these
  polhode report dzhanibekov --certify -o dzhanibekov.html         all there is to know of it on one page
  polhode golden                                  what scenes give now, against recordings/golden
  polhode golden --bless lagrange_top             writes that golden anew, and says by how much it changed
  polhode view recordings/dzhanibekov.rrd         opens the Rerun viewer on it (or on a scene)

Exit codes: 0 done, 1 a check failed, a certified tolerance was missed, recordings differ or a rotation is wrong, 2 could not
(usage, input, file), 130 interrupted (Ctrl-C), 143 ended by SIGTERM, 129 by SIGHUP. The first signal lets a run end its
recordings as readable .part files; the second ends the program at once.";

/// Exact motions of rotating rigid bodies, recorded for Rerun and Foxglove.
#[derive(Debug, Parser)]
#[command(name = "polhode", version, after_help = EXAMPLES)]
pub struct Arguments {
    #[command(subcommand)]
    pub(super) command: Command,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// List the scenes that come with the program.
    List(ListArguments),
    /// Write a commented scene that runs, to begin with.
    New(NewArguments),
    /// Hold scenes to every rule without running them; say each body's path and cost, or everything that is wrong.
    Check(CheckArguments),
    /// Print the JSON Schema of scenes, for editors: keys, types, units, ranges, defaults.
    Schema,
    /// Run scenes, record them, measure their checks.
    #[command(after_help = EXAMPLES)]
    Run(RunArguments),
    /// Show how a scene would be run: each body's path, its reason, and what is skipped.
    Plan(PlanArguments),
    /// Measure what each method costs for how much accuracy, against a reference.
    Bench(BenchArguments),
    /// Try every method on the motions that break methods: separatrices, needles, extreme units, long spans.
    ///
    /// Each run is held against a reference and against limits that are stated beforehand. Exit code 1: a result that must
    /// never be given was given.
    Stress(StressArguments),
    /// Show what is in a recording (.mcap, .rrd, .csv).
    Inspect(InspectArguments),
    /// Hold a recording of any program against physics: is its rotation right, and if not, why?
    ///
    /// Finds in which axes ω is, whether attitudes turn as ω says, what E and L gain in a turn, and how far the exact motion
    /// through the first state is; and names what is likely wrong with the program.
    Verify(VerifyArguments),
    /// Write a recording anew in other formats, every channel to the bit.
    ///
    /// Where the recording carries its scene (.mcap and .rrd do), the new one has pictures, layout and log: it is what a run
    /// to that format gives. Otherwise it has columns and words only.
    Convert(ConvertArguments),
    /// Tell whether two recordings, or a recording and a scene, are the same motion.
    ///
    /// Samples are paired by their times, to the ns. Attitudes are compared by the angle between them, vectors by the length of
    /// what is between them. Prints for each channel where the two are furthest apart, when they part, and by which law that
    /// grows. Exits with 0 if they are the same, 1 if they differ, 2 if they cannot be compared.
    Compare(CompareArguments),
    /// Print the SHA-256 of what recordings hold: the same for every format of one run.
    Digest(DigestArguments),
    /// Make a whole recording of the .part that a killed run left, and say how many samples it kept.
    Recover(RecoverArguments),
    /// Draw a recording or a scene: ω, L, energies, drift, the polhode on its ellipsoid, the herpolhode.
    Plot(PlotArguments),
    /// Make one page (.html) of a recording or a scene: checks, certificate, plots, pictures, provenance; readable offline.
    Report(ReportArguments),
    /// Hold committed recordings of scenes, the goldens, to what the scenes give now; `--bless` writes them anew.
    ///
    /// A golden is a scene's run at a few of its sample times, columns and words only. Exits with 1 where one differs, is
    /// missing, or has no scene.
    Golden(GoldenArguments),
    /// Open the Rerun viewer found on PATH on a recording or a scene.
    ///
    /// An .mcap, a .csv and a scene are first written as an .rrd to the system's folder for temporary files, where it stays
    /// until the viewer is closed.
    View(ViewArguments),
}
