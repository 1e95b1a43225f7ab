//! The bytes that fuzzing has found, replayed: whatever they are, an answer or an error, never a panic or a hang.

mod targets;

use std::fs;
use std::path::Path;

use tempfile::tempdir;

const CORPORA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/fuzz/corpus");
/// Of all corpora together, bytes.
const MOST_BYTES: u64 = 400_000;

#[test]
fn every_input_of_the_corpora_has_an_answer() {
    let folder = tempdir().expect("a folder");
    let scratch = targets::Scratch::new(folder.path());
    for (name, target) in targets::TARGETS {
        let inputs = inputs(name);
        assert!(inputs.len() >= 10, "{name}: {} inputs", inputs.len());
        for (file, bytes) in inputs {
            // Tells which, where it panics.
            println!("fuzz/corpus/{name}/{file}");
            target(&scratch, &bytes);
        }
    }
}

#[test]
fn corpora_stay_small() {
    // Those of features that this build lacks as well.
    let bytes: u64 = folders().iter().flat_map(|name| inputs(name)).map(|(_, bytes)| bytes.len() as u64).sum();
    assert!(bytes <= MOST_BYTES, "{bytes} bytes");
}

/// Each target that has a corpus.
fn folders() -> Vec<String> {
    let entries = fs::read_dir(Path::new(CORPORA)).expect("the corpora");
    entries.map(|entry| entry.expect("a corpus").file_name().to_string_lossy().into_owned()).collect()
}

/// File names and contents, in the order of the names.
fn inputs(target: &str) -> Vec<(String, Vec<u8>)> {
    let folder = Path::new(CORPORA).join(target);
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut inputs: Vec<(String, Vec<u8>)> = entries
        .map(|entry| {
            let entry = entry.expect("an entry");
            (entry.file_name().to_string_lossy().into_owned(), fs::read(entry.path()).expect("an input"))
        })
        .collect();
    inputs.sort();
    inputs
}
