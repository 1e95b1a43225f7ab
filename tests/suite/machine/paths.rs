//! Names that are no text, or look like something else: they work, or are refused in words that harm no terminal.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::os::unix::ffi::OsStrExt as _;
use std::path::Path;
use std::process::Output;

use super::{asked, finals, prepared, program, said};
use crate::contested_names::{SCENE, folder};

fn no_text(rest: &str) -> OsString {
    let mut name = OsStr::from_bytes(b"b\xff\xfed").to_owned();
    name.push(rest);
    name
}

fn asked_of(folder: &Path, words: &[&OsStr]) -> Output {
    program(folder).args(words).output().expect("the program starts")
}

fn words<'a>(text: &[&'a str]) -> Vec<&'a OsStr> {
    text.iter().map(|word| OsStr::new(*word)).collect()
}

#[test]
fn folders_and_recordings_need_no_text_for_a_name() {
    let folder = prepared();
    let [mcap, csv, rrd, part] = [".mcap", ".csv", ".rrd", ".mcap.part"].map(no_text);
    let (out, svg, html) = (no_text(""), no_text(".svg"), no_text(".html"));
    fs::copy(folder.path().join("scene.mcap"), folder.path().join(&mcap)).expect("room");
    fs::copy(folder.path().join("cut.mcap.part"), folder.path().join(&part)).expect("room");
    let run = [&words(&["run", "scene.toml", "--out"])[..], &[&out]].concat();
    let requests = [
        run,
        vec![OsStr::new("inspect"), &mcap],
        vec![OsStr::new("digest"), &mcap],
        vec![OsStr::new("verify"), &mcap],
        vec![OsStr::new("convert"), &mcap, &csv, &rrd],
        vec![OsStr::new("recover"), &part, OsStr::new("--force")],
        [&words(&["plot", "scene.mcap", "-o"])[..], &[&svg]].concat(),
        [&words(&["report", "scene.mcap", "-o"])[..], &[&html]].concat(),
        [&words(&["compare", "scene.mcap", "scene.csv", "--force", "--plot"])[..], &[&svg]].concat(),
        [&words(&["golden", "scene.toml", "--bless", "--folder"])[..], &[&out]].concat(),
        [&words(&["stress", "--cases", "sphere", "--methods", "closed_form", "--plot"])[..], &[&svg]].concat(),
    ];
    for request in &requests {
        let output = asked_of(folder.path(), request);
        assert_eq!(output.status.code(), Some(0), "{request:?}: {}", said(&output));
    }
    for made in [&csv, &rrd, &svg, &html] {
        assert!(folder.path().join(made).is_file(), "{}", made.display());
    }
    assert!(folder.path().join(&out).join("scene.mcap").is_file());
    assert!(!folder.path().join(&part).exists(), "recovered");
}

#[test]
fn scenes_must_be_called_by_text_and_the_word_that_is_none_is_shown() {
    let folder = prepared();
    let [scene, mcap] = [".toml", ".mcap"].map(no_text);
    fs::write(folder.path().join(&scene), SCENE).expect("room");
    fs::copy(folder.path().join("scene.mcap"), folder.path().join(&mcap)).expect("room");
    let before = finals(folder.path());
    for request in [
        vec![OsStr::new("run"), &scene],
        vec![OsStr::new("plan"), &scene],
        vec![OsStr::new("bench"), &scene],
        vec![OsStr::new("golden"), &scene],
        vec![OsStr::new("view"), &mcap],
        vec![OsStr::new("compare"), &mcap, OsStr::new("scene.csv")],
        vec![OsStr::new("plot"), &mcap, OsStr::new("-o"), OsStr::new("new.svg")],
    ] {
        let output = asked_of(folder.path(), &request);
        assert_eq!(output.status.code(), Some(2), "{request:?}");
        let said = said(&output);
        assert!(said.contains(r#""b\xFF\xFEd."#) && said.contains("UTF-8"), "{request:?}: {said}");
        assert_eq!(finals(folder.path()), before, "{request:?}");
    }
    let all = asked(folder.path(), &["golden", "--bless", "--folder", "goldens", "--scenes-in", "."]);
    assert_eq!(all.status.code(), Some(2));
    assert!(said(&all).contains(r#"b\xFF\xFEd.toml": the name of a scene must be UTF-8"#), "{}", said(&all));
}

#[test]
fn spaces_quotes_newlines_and_other_scripts_are_letters_like_others() {
    let folder = folder();
    for name in
        ["a b", "it's", "say \"so\"", "two\nlines", "$HOME `id` %s {} *", "ω̇ 向 🛰", "tab\there", "\u{1b}[31mred"]
    {
        let scene = format!("{name}.toml");
        fs::write(folder.path().join(&scene), SCENE).expect("room");
        let run = asked(folder.path(), &["run", &scene, "--out", name, "--format", "mcap,rrd,csv"]);
        assert_eq!(run.status.code(), Some(0), "{name}: {}", said(&run));
        let shown = String::from_utf8(run.stdout).expect("UTF-8");
        assert!(!shown.contains('\u{1b}') && !shown.contains('\t'), "{shown:?} drives a terminal");
        let recordings = ["mcap", "rrd", "csv"].map(|format| format!("{name}/{name}.{format}"));
        let [mcap, rrd, csv] = recordings.each_ref().map(String::as_str);
        for request in [&["digest", mcap, rrd][..], &["compare", mcap, csv, "--exact"], &["compare", rrd, &scene]] {
            let output = asked(folder.path(), request);
            assert_eq!(output.status.code(), Some(0), "{request:?}: {}", said(&output));
        }
        let absent = asked(folder.path(), &["inspect", &format!("no {name}.mcap")]);
        assert_eq!(absent.status.code(), Some(2));
        assert!(!said(&absent).contains('\u{1b}'), "{:?}", said(&absent));
    }
}

#[test]
fn a_name_like_a_flag_is_one_after_two_dashes_or_a_folder() {
    let folder = folder();
    fs::write(folder.path().join("-q.toml"), SCENE).expect("room");
    assert_eq!(asked(folder.path(), &["run", "-q.toml"]).status.code(), Some(2));
    for words in [
        &["run", "--out=-out", "--quiet", "--", "-q.toml"][..],
        &["run", "./-q.toml", "--out", "./-out", "--quiet", "--force"],
    ] {
        let output = asked(folder.path(), words);
        assert_eq!(output.status.code(), Some(0), "{words:?}: {}", said(&output));
        assert!(folder.path().join("-out/-q.mcap").is_file());
    }
    assert_eq!(asked(folder.path(), &["digest", "--", "-out/-q.mcap"]).status.code(), Some(0));
}

#[test]
fn a_name_that_is_too_long_is_named_and_leaves_nothing() {
    let folder = folder();
    // The longest that a scene can have, 255 bytes with its extension: recordings would be called longer while they are parts.
    let long = format!("{}.toml", "n".repeat(250));
    fs::write(folder.path().join(&long), SCENE).expect("room");
    let output = asked(folder.path(), &["run", &long, "--out", "out"]);
    assert_eq!(output.status.code(), Some(2));
    let words = said(&output);
    assert!(words.contains("nnnn") && words.contains("too long"), "{words}");
    assert!(finals(&folder.path().join("out")).is_empty());
    assert_eq!(fs::read_dir(folder.path().join("out")).expect("made").count(), 0, "not even parts");
    let deep = format!("{}x", "deep/".repeat(1000));
    let output = asked(folder.path(), &["run", "scene.toml", "--out", &deep]);
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output).contains("cannot make the folder deep/"), "{}", said(&output));
}

#[test]
fn a_mesh_beside_a_scene_may_be_called_as_it_likes_in_a_folder_that_is_no_text() {
    let folder = folder();
    let shape = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    let inner = folder.path().join(no_text(""));
    fs::create_dir(&inner).expect("room");
    let name = "a shape, \u{fc}ber.obj";
    fs::write(inner.join(name), shape).expect("room");
    let scene = format!(
        "duration_s = 1.0\nsample_every_s = 0.1\n[[body]]\nangular_velocity_rad_s = [0.1, 2.0, 0.0]\n\
         [body.mesh]\nfile = \"{name}\"\ndensity_kg_m3 = 1000.0\n"
    );
    fs::write(inner.join("scene.toml"), scene).expect("room");
    let output = asked(&inner, &["run", "scene.toml", "--quiet"]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    fs::remove_file(inner.join(name)).expect("ours");
    let absent = asked(&inner, &["run", "scene.toml", "--force"]);
    assert_eq!(absent.status.code(), Some(2));
    assert!(said(&absent).contains("a shape, \u{fc}ber.obj"), "{}", said(&absent));
}
