//! Locales, time zones, clocks, terminals, variables that are missing, a folder that is gone: no byte of a recording changes.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::{FORMATS, asked, prepared, program, said, shell};

/// Variables, and what they are set to; nothing is removed.
const SURROUNDINGS: [&[(&str, &str)]; 14] = [
    &[("LC_ALL", "C"), ("LANG", "C")],
    &[("LC_ALL", "POSIX")],
    // A comma for a decimal point, and an i without its dot.
    &[("LC_ALL", "tr_TR.UTF-8"), ("LANG", "tr_TR.UTF-8")],
    &[("LC_ALL", "de_DE.ISO-8859-1")],
    &[("LC_ALL", "no such locale")],
    &[("TZ", "Pacific/Kiritimati")],
    &[("TZ", ":no such zone")],
    &[("TERM", "dumb")],
    &[("TERM", "")],
    &[("NO_COLOR", "1")],
    &[("CLICOLOR_FORCE", "1")],
    &[("COLUMNS", "1"), ("LINES", "1")],
    &[("COLUMNS", "-3")],
    &[("TMPDIR", "/there is no such folder"), ("HOME", "")],
];

#[test]
fn recordings_and_reports_are_the_same_everywhere() {
    let folder = prepared();
    let expected = FORMATS.map(|format| fs::read(folder.path().join(format!("scene.{format}"))).expect("recorded"));
    let told = asked(folder.path(), &["inspect", "scene.mcap"]).stdout;
    let check = |made: PathBuf, inspected: Vec<u8>, name: &str| {
        for (format, expected) in FORMATS.iter().zip(&expected) {
            let found = fs::read(made.join(format!("scene.{format}"))).expect("recorded");
            assert_eq!(found, *expected, "{format} with {name}");
        }
        assert_eq!(inspected, told, "with {name}");
    };
    let run = ["run", "scene.toml", "--quiet", "--force", "--out", "out", "--format", "mcap,rrd,csv"];
    for variables in SURROUNDINGS {
        let with = |arguments: &[&str]| {
            program(folder.path()).args(arguments).envs(variables.iter().copied()).output().expect("it starts")
        };
        let output = with(&run);
        assert_eq!((output.status.code(), said(&output).as_str()), (Some(0), ""), "{variables:?}");
        check(folder.path().join("out"), with(&["inspect", "scene.mcap"]).stdout, &format!("{variables:?}"));
    }
    let bare = |arguments: &[&str]| program(folder.path()).args(arguments).env_clear().output().expect("it starts");
    assert_eq!(bare(&run).status.code(), Some(0));
    check(folder.path().join("out"), bare(&["inspect", "scene.mcap"]).stdout, "no variables at all");
}

#[test]
fn help_is_laid_out_for_any_width_and_has_no_colours_where_nobody_sees_them() {
    let told = |columns: &str| {
        let output = program(Path::new(".")).arg("--help").env("COLUMNS", columns).output().expect("it starts");
        assert_eq!(output.status.code(), Some(0), "{columns}");
        String::from_utf8(output.stdout).expect("UTF-8")
    };
    let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let wide = told("1000");
    for columns in ["1", "2", "20", "80", "65535", "none", ""] {
        let text = told(columns);
        assert!(!text.contains('\u{1b}'), "{columns}");
        assert_eq!(words(&text), words(&wide), "{columns}: not a word is lost");
    }
    let refused = program(Path::new(".")).arg("fly").env("NO_COLOR", "1").env("CLICOLOR_FORCE", "1").output();
    assert!(!said(&refused.expect("it starts")).contains('\u{1b}'), "NO_COLOR comes before CLICOLOR_FORCE");
}

#[test]
fn what_needs_a_folder_for_temporary_files_names_it() {
    let folder = prepared();
    for set in ["/there is no such folder", "/proc/self"] {
        let output = program(folder.path())
            .args(["golden", "scene.toml", "--bless", "--folder", "goldens"])
            .env("TMPDIR", set)
            .output();
        let output = output.expect("it starts");
        assert_eq!(output.status.code(), Some(2));
        assert!(said(&output).contains(&format!("cannot make the folder {set}/polhode-golden-")), "{}", said(&output));
    }
}

/// A folder that somebody removes while the shell stands in it.
#[test]
fn a_folder_that_is_gone_is_said_and_full_paths_still_work() {
    let folder = prepared();
    let recording = folder.path().join("scene.mcap");
    let recording = recording.to_str().expect("UTF-8");
    let gone = "mkdir gone; cd gone; rmdir ../gone;";
    for (arguments, code) in [
        (&["list"][..], 0),
        (&["inspect", recording], 0),
        (&["digest", "scene.mcap"], 2),
        (&["run", "spin_up"], 2),
        (&["plot", recording, "-o", "new.svg"], 2),
        (&["golden", "spin_up"], 2),
    ] {
        let output = shell(folder.path(), gone, arguments);
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {}", said(&output));
        assert_eq!(said(&output).is_empty(), code == 0, "{arguments:?}");
    }
}

/// Nothing that is recorded, decided or waited for depends on the clock on the wall, which may jump: it is not looked at.
#[test]
fn the_clock_on_the_wall_is_never_asked() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut folders = vec![source];
    let mut seen = 0;
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("source") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = fs::read_to_string(&path).expect("source");
                let clocks = ["SystemTime", "UNIX_EPOCH", "ClockId::Realtime", "chrono", "jiff"];
                let asked: Vec<_> = clocks.into_iter().filter(|clock| text.contains(clock)).collect();
                assert!(asked.is_empty(), "{}: {asked:?}", path.display());
                seen += 1;
            }
        }
    }
    assert!(seen > 200, "only {seen} files were looked at");
}

/// A terminal of a single column, and a wide one, where there is a program that makes terminals (`script`).
#[test]
fn on_a_terminal_of_any_width_a_run_is_done_and_leaves_it_as_it_was() {
    let folder = prepared();
    for columns in ["1", "2", "20", "80", "1000"] {
        let run =
            format!("stty cols {columns} && exec '{}' run scene.toml --force --out out", env!("CARGO_BIN_EXE_polhode"));
        let script = Command::new("script")
            .current_dir(folder.path())
            .args(["-qec", &run, "/dev/null"])
            .env("TERM", "xterm")
            .output();
        // Where there is none, `COLUMNS` above is what is held.
        let Ok(output) = script else { return };
        let shown = String::from_utf8_lossy(&output.stdout);
        assert_eq!(output.status.code(), Some(0), "{columns} columns: {shown}");
        assert!(shown.contains("closed form") && !shown.contains("panicked"), "{columns} columns: {shown}");
        let hidden = shown.matches("\u{1b}[?25l").count();
        assert_eq!(hidden, shown.matches("\u{1b}[?25h").count(), "a cursor that is hidden is shown again");
    }
}

/// A matrix in colours on a terminal, and without where they are not wanted.
#[test]
fn colours_of_a_terminal_are_colours() {
    let folder = prepared();
    let stress = format!("exec '{}' stress --cases rest --methods auto", env!("CARGO_BIN_EXE_polhode"));
    for (unwanted, coloured) in [("", true), ("1", false)] {
        let script = Command::new("script")
            .current_dir(folder.path())
            .args(["-qec", &stress, "/dev/null"])
            .env("NO_COLOR", unwanted)
            .output();
        let Ok(output) = script else { return };
        let shown = String::from_utf8_lossy(&output.stdout);
        assert_eq!(output.status.code(), Some(0), "{shown}");
        assert_eq!(shown.contains("\u{1b}[32m16=\u{1b}[0m"), coloured, "{shown}");
        assert!(!shown.contains("u{1b}") && shown.contains("16="), "{shown}");
    }
}
