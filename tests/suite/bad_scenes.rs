//! Every file in `tests/bad/` is refused, with the message that stands beside it.
//!
//! `POLHODE_BLESS=1 cargo test bad_scenes` writes the messages anew; read what changed before it is committed.

use std::fs;
use std::path::{Path, PathBuf};

use polhode::scenario::{Plan, Scenario};

#[test]
fn every_bad_scene_is_refused_with_its_message() {
    let bless = std::env::var_os("POLHODE_BLESS").is_some();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad");
    let scenes = scenes(&folder);
    assert!(scenes.len() >= 40, "{} files", scenes.len());
    let mut differing = Vec::new();
    for scene in scenes {
        let result = Scenario::read(&scene, &[]).and_then(|scenario| Plan::new(&scenario));
        let error = result.expect_err(&format!("{} was planned", scene.display()));
        let message = error.to_string().replace(&format!("{}/", folder.display()), "") + "\n";
        let expected = scene.with_extension("txt");
        if bless {
            fs::write(&expected, &message).expect("tests/bad can be written");
        }
        let kept = fs::read_to_string(&expected).unwrap_or_default();
        if kept != message {
            differing.push(format!("--- {}\n{kept}+++ now\n{message}", expected.display()));
        }
    }
    assert!(differing.is_empty(), "{}", differing.join("\n"));
}

/// A refusal without the line it is about is half an answer.
#[test]
fn every_refusal_points_into_the_file() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad");
    for scene in scenes(&folder) {
        let name = scene.file_name().expect("a file has a name").to_string_lossy().into_owned();
        let message = fs::read_to_string(scene.with_extension("txt")).expect("each scene has its message");
        assert!(message.starts_with(&format!("{name}:")), "{message}");
        assert!(message.contains('^') || is_about_something_missing(&message), "{message}");
    }
}

fn is_about_something_missing(message: &str) -> bool {
    message.contains("missing") || message.contains("needs")
}

fn scenes(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("tests/bad is there");
    let mut scenes: Vec<_> = entries.map(|entry| entry.expect("an entry can be read").path()).collect();
    scenes.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    scenes.sort();
    scenes
}
