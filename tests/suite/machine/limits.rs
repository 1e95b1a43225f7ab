//! Limits of the process: memory, open files.

use std::fs;
use std::path::Path;

use polhode::recording::Recording;

use super::{FORMATS, finals, prepared, said, shell};

/// Samples in a recording, or in a part of one; none where not even its heading is there.
fn samples(path: &Path) -> Option<usize> {
    let mut recording = Recording::open(path).ok()?;
    let mut count = 0;
    while let Some(samples) = recording.next_batch().expect("sound as far as it goes") {
        count += samples.len();
    }
    Some(count)
}

/// From far too little to enough: whatever the limit, what has a final name is whole.
#[test]
fn a_limit_of_memory_leaves_nothing_broken_under_a_final_name() {
    let folder = prepared();
    let out = folder.path().join("out");
    let run = ["run", "scene.toml", "--quiet", "--duration", "20", "--out", "out", "--format", "mcap,rrd,csv"];
    let mut done = 0;
    for megabytes in (24..=64).step_by(4).chain([96, 128, 256, 512, 1024, 4096]) {
        let _ = fs::remove_dir_all(&out);
        let output = shell(folder.path(), &format!("ulimit -c 0; ulimit -v {};", megabytes * 1024), &run);
        let words = String::from_utf8_lossy(&output.stderr).into_owned();
        let is_done = output.status.code() == Some(0);
        // With too little for the program itself the system ends it without a word.
        assert!(
            is_done || !words.is_empty() || output.status.code().is_none(),
            "{megabytes} MiB: it is said what was wanting"
        );
        for format in FORMATS {
            let whole = out.join(format!("scene.{format}"));
            assert_eq!(whole.exists(), is_done, "{megabytes} MiB, {format}: {words}");
            if is_done {
                assert_eq!(samples(&whole), Some(20_001), "{megabytes} MiB, {format}");
            } else if let Some(kept) = samples(&out.join(format!("scene.{format}.part"))) {
                assert!(kept <= 20_001, "{megabytes} MiB, {format}");
            }
        }
        done += usize::from(is_done);
        if done == 2 {
            return;
        }
    }
    panic!("4 GiB are enough for twenty thousand samples");
}

/// From none to enough: a file that cannot be opened is named, and no run gets half of its names.
#[test]
fn a_limit_of_open_files_is_said_and_leaves_nothing_half_named() {
    let folder = prepared();
    let before = finals(folder.path());
    let run = ["run", "scene.toml", "--quiet", "--out", "out", "--format", "mcap,rrd,csv"];
    let mut refused = 0;
    for files in 3..64 {
        let output = shell(folder.path(), &format!("ulimit -n {files};"), &run);
        let words = said(&output);
        if output.status.code() == Some(0) {
            assert_eq!(finals(&folder.path().join("out")).len(), 4, "{files}: three recordings and a layout");
            assert!(refused > 0, "{files} are too few for three recordings");
            return;
        }
        assert!(words.contains("oo many open files") || words.contains("shared libraries"), "{files}: {words}");
        refused += usize::from(words.contains("out/scene."));
        assert_eq!(finals(folder.path()), before, "{files}: {words}");
    }
    panic!("sixty files are enough for four");
}
