//! Streams that are full, closed, or nobody reads.

use std::fs::{self, File};
use std::process::Stdio;

use super::{TALKERS, WRITERS, finals, prepared, program, said, shell};

#[test]
fn a_full_standard_output_is_said_and_exits_with_two() {
    let folder = prepared();
    for command in TALKERS {
        let full = File::options().write(true).open("/dev/full").expect("Linux has it");
        let child = program(folder.path()).args(command).stdout(full).stderr(Stdio::piped()).spawn();
        let output = child.and_then(std::process::Child::wait_with_output).expect("it ends");
        let words = said(&output);
        assert_eq!(output.status.code(), Some(2), "{command:?}: {words}");
        assert!(words.contains("cannot write to standard output: No space left"), "{command:?}: {words}");
    }
}

#[test]
fn a_reader_that_has_gone_away_is_no_fault() {
    let folder = prepared();
    for command in TALKERS {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        let child = program(folder.path()).args(command).stdout(writer).stderr(Stdio::piped()).spawn();
        let output = child.and_then(std::process::Child::wait_with_output).expect("it ends");
        assert_eq!((output.status.code(), said(&output).as_str()), (Some(0), ""), "{command:?}");
    }
}

#[test]
fn closed_streams_are_as_null_and_no_file_takes_their_place() {
    let folder = prepared();
    let whole = fs::read(folder.path().join("scene.csv")).expect("recorded");
    for closed in ["exec >&-;", "exec 2>&-;", "exec <&-;", "exec <&- >&- 2>&-;"] {
        for command in TALKERS {
            let output = shell(folder.path(), closed, command);
            assert_eq!(output.status.code(), Some(0), "{closed} {command:?}: {}", said(&output));
        }
        assert_eq!(fs::read(folder.path().join("again.csv")).expect("converted"), whole, "{closed}");
    }
    // With nobody to tell, the exit code still does.
    let failed = shell(folder.path(), "exec >&- 2>&-;", &["inspect", "absent.mcap"]);
    assert_eq!((failed.status.code(), said(&failed).as_str()), (Some(2), ""));
}

/// A reader of stderr that has gone away.
#[test]
fn remarks_that_nobody_takes_change_nothing() {
    let folder = prepared();
    for (command, code) in
        [(&["convert", "scene.csv", "plain.mcap"][..], 0), (&["inspect", "absent.mcap"], 2), (&["fly"], 2)]
    {
        for stream in ["a pipe", "/dev/full"] {
            let (reader, writer) = std::io::pipe().expect("a pipe");
            drop(reader);
            let mut program = program(folder.path());
            program.args(command).arg(if command[0] == "convert" { "--force" } else { "--" }).stdout(Stdio::null());
            if stream == "a pipe" {
                program.stderr(writer);
            } else {
                program.stderr(File::options().write(true).open(stream).expect("Linux has it"));
            }
            assert_eq!(program.status().expect("it ends").code(), Some(code), "{command:?}, {stream}");
        }
    }
}

/// No file may have a single byte: a full disk, for every command that writes one.
#[test]
fn a_disk_without_room_leaves_nothing_under_a_final_name() {
    let folder = prepared();
    let before = finals(folder.path());
    for (command, name) in WRITERS {
        let output = shell(folder.path(), "trap '' XFSZ; ulimit -f 0;", command);
        let words = said(&output);
        assert_eq!(output.status.code(), Some(2), "{command:?}: {words}");
        assert!(words.contains(name) && words.contains("File too large"), "{command:?}: {words}");
        assert_eq!(finals(folder.path()), before, "{command:?}");
    }
}

/// A folder that is none, for every command that writes a file.
#[test]
fn a_folder_that_cannot_be_written_to_is_named() {
    let folder = prepared();
    for (command, name) in WRITERS.into_iter().filter(|(command, _)| command[0] != "recover") {
        let command: Vec<_> = command
            .iter()
            .map(|word| match *word {
                "new" | "goldens" => "/proc/self".to_owned(),
                word if word.starts_with("new.") => format!("/proc/self/{word}"),
                word => word.to_owned(),
            })
            .collect();
        let command: Vec<_> = command.iter().map(String::as_str).collect();
        let output = super::asked(folder.path(), &command);
        let words = said(&output);
        assert_eq!(output.status.code(), Some(2), "{command:?}: {words}");
        let place = format!("/proc/self/{}", name.trim_start_matches("new/"));
        assert!(words.contains(&place), "{command:?}: {place} in {words}");
    }
}
