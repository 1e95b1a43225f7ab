//! `polhode plot` and `polhode report`: well-formed, complete, the same every time, and nothing from elsewhere.

use std::fs;
use std::path::Path;

use polhode::plot::{Ellipsoid, Format, Motion, Request, Surroundings, Wanted};
use polhode::recording::Subject;
use polhode::scenario::{Plan, Scenario};
use polhode::telemetry::Channel;

use crate::cli::{folder_with, polhode, stderr};

const SCENE: &str = "
title = \"A tumble\"
duration_s = 10.0
sample_every_s = 0.05

[[body]]
principal_moments_kg_m2 = [1.0, 2.0, 2.5]
angular_velocity_rad_s = [0.1, 2.0, 0.3]
";

fn text(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).expect("the file is written, in UTF-8")
}

fn ok(folder: &Path, arguments: &[&str]) {
    let output = polhode(folder, arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", stderr(&output));
    assert!(output.stdout.is_empty(), "the plot is the result");
}

/// Every text of a drawing, one a line.
fn words(svg: &str) -> String {
    let document = roxmltree::Document::parse(svg).expect("well-formed XML");
    let texts = document.descendants().filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "text")));
    texts.filter_map(|node| node.text()).collect::<Vec<_>>().join("\n")
}

#[test]
fn a_plot_is_well_formed_the_same_every_time_and_from_every_format() {
    let folder = folder_with(SCENE);
    let folder = folder.path();
    ok(folder, &["plot", "scene.toml", "-o", "scene.svg"]);
    let drawn = text(folder, "scene.svg");
    let found = words(&drawn);
    for title in ["polhode: ω on the energy ellipsoid", "ω in body axes, rad/s", "L in world axes", "drift, relative"]
    {
        assert!(found.contains(title), "{title} is not in\n{found}");
    }
    let run = polhode(folder, &["run", "scene.toml", "--format", "mcap,rrd", "--out", "."]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    for file in ["scene.toml", "scene.mcap", "scene.rrd"] {
        ok(folder, &["plot", file, "-o", "again.svg", "--force"]);
        assert!(text(folder, "again.svg") == drawn, "{file} gives another plot");
    }
}

#[test]
fn every_channel_asked_for_has_its_panel_and_no_other() {
    let folder = folder_with(SCENE);
    let folder = folder.path();
    let asked = "attitude,position,angular_momentum_body,rotational_energy,energy_drift";
    ok(folder, &["plot", "scene.toml", "--channels", asked, "-o", "a.svg"]);
    let found = words(&text(folder, "a.svg"));
    for name in asked.split(',') {
        let title = Channel::from_name(name).expect("a channel").row().title;
        assert!(found.contains(title), "{title} is not in\n{found}");
    }
    assert!(!found.contains("polhode") && !found.contains("ω in body axes"), "{found}");
    ok(folder, &["plot", "scene.toml", "--channels", "herpolhode", "-o", "h.svg", "--from", "0.2", "--to", "0.8"]);
    let found = words(&text(folder, "h.svg"));
    assert!(found.contains("herpolhode") && !found.contains("time, s"), "{found}");
}

#[test]
fn what_cannot_be_drawn_is_refused_and_leaves_nothing() {
    let folder = folder_with(SCENE);
    let folder = folder.path();
    let run =
        polhode(folder, &["run", "scene.toml", "--channels", "angular_velocity", "--format", "csv", "--out", "."]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    for (arguments, message) in [
        (
            &["plot", "scene.toml", "--channels", "angular_velocty", "-o", "x.svg"][..],
            "did you mean \"angular_velocity\"?",
        ),
        (&["plot", "scene.toml", "--channels", "pollhode", "-o", "x.svg"], "did you mean \"polhode\"?"),
        (
            &["plot", "scene.csv", "--channels", "tilt", "-o", "x.svg"],
            "tilt cannot be drawn: recorded are angular_velocity",
        ),
        (&["plot", "scene.toml", "--body", "bodi", "-o", "x.svg"], "did you mean"),
        (&["plot", "scene.toml", "--from", "5", "--to", "4", "-o", "x.svg"], "no sample is from 5 to 4 s"),
        (&["plot", "scene.toml", "-o", "x.pdf"], "ends in .svg or .png"),
        (&["plot", "scene.toml", "--scene", "scene.toml", "-o", "x.svg"], "--scene is for a recording"),
        (&["plot", "scene.csv", "--set", "duration_s=2", "-o", "x.svg"], "--set is for a scene"),
        (&["plot", "nothing.mcap", "-o", "x.svg"], "cannot read nothing.mcap"),
        (&["report", "scene.toml", "-o", "x.pdf"], "ends in .html"),
        (&["report", "scene.csv", "--certify", "-o", "x.html"], "--certify is for a scene"),
        (&["report", "scene.csv.part", "-o", "x.html"], "polhode recover"),
    ] {
        let output = polhode(folder, arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", stderr(&output));
        assert!(stderr(&output).contains(message), "{arguments:?}: {}", stderr(&output));
    }
    let left: Vec<_> =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").file_name()).collect();
    assert_eq!(left.len(), 2, "{left:?}");
}

#[test]
fn a_name_that_is_taken_is_kept_and_a_png_has_two_pixels_to_one() {
    let folder = folder_with(SCENE);
    let folder = folder.path();
    let asked = ["plot", "scene.toml", "--channels", "angular_velocity", "-o"];
    ok(folder, &[&asked[..], &["a.png"]].concat());
    let png = fs::read(folder.join("a.png")).expect("the file is written");
    let taken = polhode(folder, &[&asked[..], &["a.png"]].concat());
    assert_eq!(taken.status.code(), Some(2));
    assert!(stderr(&taken).contains("--force overwrites it"), "{}", stderr(&taken));
    ok(folder, &[&asked[..], &["a.svg"]].concat());
    let svg = text(folder, "a.svg");
    let document = roxmltree::Document::parse(&svg).expect("well-formed XML");
    let side = |name: &str| document.root_element().attribute(name).and_then(|side| side.parse::<f64>().ok());
    let decoded = tiny_skia::Pixmap::decode_png(&png).expect("a sound PNG");
    let sides = [decoded.width(), decoded.height()].map(f64::from);
    assert_eq!([side("width"), side("height")].map(|side| side.map(|side| (2.0 * side).ceil())), sides.map(Some));
    let white = decoded.pixels().iter().filter(|pixel| pixel.red() > 250).count();
    assert!(white > decoded.pixels().len() / 2 && white < decoded.pixels().len(), "lines on white paper");
}

#[test]
fn a_table_without_inertia_says_so_and_one_with_momentum_has_its_polhode() {
    let folder = folder_with(SCENE);
    let folder = folder.path();
    for (channels, has_polhode) in [("angular_velocity", false), ("angular_velocity,angular_momentum_body", true)] {
        let long = ["--set", "duration_s=60", "--set", "body.0.angular_velocity_rad_s=[1, 2, 3]"];
        let run = ["run", "scene.toml", "--channels", channels, "--format", "csv", "--out", ".", "--force"];
        let run = polhode(folder, &[&run[..], &long[..]].concat());
        assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
        let output = polhode(folder, &["plot", "scene.csv", "-o", "a.svg", "--force"]);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        assert_eq!(words(&text(folder, "a.svg")).contains("polhode"), has_polhode);
        assert_eq!(stderr(&output).contains("no polhode"), !has_polhode, "{}", stderr(&output));
    }
}

#[test]
fn a_polhode_lies_on_the_ellipsoid_that_is_drawn() {
    let plan = Plan::new(&Scenario::named("dzhanibekov", &[]).expect("a scene")).expect("a plan");
    let moments = plan.bodies[0].properties.moments.vector();
    let ellipsoid = Ellipsoid::new(moments).expect("round enough");
    let mut run = plan.start().expect("a run");
    let to_principal = plan.bodies[0].properties.body_from_principal.inverse();
    while let Some(samples) = run.next_batch().expect("a batch") {
        let omega = samples.bodies[0].channel(Channel::AngularVelocity).expect("recorded");
        for index in 0..samples.len() {
            let omega = to_principal * nalgebra::Vector3::new(omega[0][index], omega[1][index], omega[2][index]);
            let point = ellipsoid.point(&omega);
            // ρ = ω / √(2T): on the ellipsoid, and along ω.
            assert!((point.component_mul(&moments).dot(&point) - 1.0).abs() < 1e-14);
            assert!(point.cross(&omega).norm() < 1e-15 * point.norm() * omega.norm() * 4.0);
        }
    }
}

#[test]
fn memory_of_a_long_motion_is_that_of_its_picture() {
    let long = ["duration_s=2000".to_owned(), "sample_every_s=0.01".to_owned()];
    let plan = Plan::new(&Scenario::named("feynman_plate", &long).expect("a scene")).expect("a plan");
    let request =
        Request { wanted: vec![Wanted::Polhode, Wanted::Channel(Channel::AngularVelocity)], ..Request::default() };
    let mut motion = Motion::new(&Subject::of(&plan).heading, Some(&plan), &request).expect("recorded");
    let mut run = plan.start().expect("a run");
    while let Some(samples) = run.next_batch().expect("a batch") {
        motion.add(samples);
    }
    let svg = motion.draw("", &[]).svg(Surroundings::Paper);
    // 200,001 samples of three columns in 7 bytes each would be four megabytes.
    assert!(svg.len() < 150_000, "{}", svg.len());
    assert!(Format::Png.bytes(&motion.draw("", &[])).is_ok());
}

/// A title, a text and a body's name that would be markup, scripts and loads if they were not escaped.
const HOSTILE: &str = r#"
title = "<script>alert(1)</script> \"&amp; <img src=x onerror='x()'>"
summary = "</p><iframe src=\"https://example.org\"></iframe>\n\n]]> <!-- \u0007"
duration_s = 1.0
sample_every_s = 0.1

[provenance]
source = "<b onclick=x>"
url = "javascript:alert(1)"
note = "'><svg/onload=alert(1)>"

[[body]]
principal_moments_kg_m2 = [1.0, 2.0, 3.0]
angular_velocity_rad_s = [0.1, 2.0, 0.1]
"#;

/// Four bodies and twelve particles: below each other they would be higher than a picture may be.
#[test]
fn particles_beside_bodies_have_room_on_a_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    ok(folder.path(), &["plot", "particle_cloud", "-o", "cloud.png"]);
    assert!(folder.path().join("cloud.png").is_file());
}

/// Tags of a page, attributes included.
fn tags(page: &str) -> Vec<&str> {
    page.split('<').skip(1).filter_map(|rest| rest.split('>').next()).collect()
}

fn holds_nothing_from_elsewhere(page: &str) {
    for tag in tags(page) {
        let name = tag.split([' ', '\n', '/']).find(|part| !part.is_empty()).unwrap_or_default();
        let is_allowed = ![
            "script", "link", "img", "iframe", "object", "embed", "base", "image", "use", "audio", "video", "form", "a",
        ]
        .contains(&name);
        assert!(is_allowed, "<{tag}>");
        for word in ["href", "src=", "srcset", "onload", "onclick", "onerror", "http-equiv"] {
            assert!(!tag.contains(word), "<{tag}>");
        }
    }
    let style = page.split("<style>").nth(1).and_then(|rest| rest.split("</style>").next()).expect("a style");
    assert!(!style.contains("@import"), "a style from elsewhere");
    assert!(style.matches("url(").count() == style.matches("url(data:").count(), "a font from elsewhere");
}

#[test]
fn a_page_has_every_check_and_the_certificate_and_nothing_from_elsewhere() {
    let folder = folder_with(SCENE);
    let folder = folder.path();
    ok(folder, &["report", "dzhanibekov", "--certify", "-o", "page.html"]);
    let page = text(folder, "page.html");
    holds_nothing_from_elsewhere(&page);
    let plan = Plan::new(&Scenario::named("dzhanibekov", &[]).expect("a scene")).and_then(|plan| Ok(plan.checked()?));
    let plan = plan.expect("a plan");
    assert!(plan.outcomes.len() > 2);
    for check in &plan.outcomes {
        assert!(page.contains(&format!("<td>{}</td><td class=\"number\">{:?}</td>", check.name, check.measured)));
    }
    let all = plan.outcomes.len();
    for words in [&format!("✓ {all} of {all} passed"), "attitude exact within", "attitude_error_rad", &plan.title] {
        assert!(page.contains(&words.replace('\'', "&#39;")), "{words}");
    }
    ok(folder, &["report", "dzhanibekov", "--certify", "-o", "page.html", "--force"]);
    assert!(text(folder, "page.html") == page, "another page the second time");
}

#[test]
fn a_page_of_a_recording_has_the_same_verdicts_and_one_of_a_table_says_what_it_lacks() {
    let folder = folder_with(SCENE);
    let folder = folder.path();
    let run = ["run", "dzhanibekov", "--certify", "--format", "mcap,rrd,csv", "--out", "."];
    assert_eq!(polhode(folder, &run).status.code(), Some(0));
    ok(folder, &["report", "dzhanibekov", "--certify", "-o", "scene.html"]);
    let part = |page: &str, from: &str, to: &str| -> String {
        let rest = page.split(from).nth(1).expect("the part begins");
        rest.split(to).next().expect("the part ends").to_owned()
    };
    let scene = text(folder, "scene.html");
    for file in ["dzhanibekov.mcap", "dzhanibekov.rrd"] {
        ok(folder, &["report", file, "-o", "file.html", "--force"]);
        let page = text(folder, "file.html");
        let verdicts = |page: &str| part(page, "class=\"cards\"", "<h2>How it was made");
        assert!(verdicts(&page) == verdicts(&scene), "{file} has other verdicts, pictures or plots");
    }
    ok(folder, &["report", "dzhanibekov.csv", "-o", "table.html"]);
    let page = text(folder, "table.html");
    holds_nothing_from_elsewhere(&page);
    for words in ["No checks", "Not certified", "it carries no scene", "herpolhode", "a table holds columns only"] {
        assert!(page.contains(words), "{words}");
    }
    assert!(!page.contains("Pictures of the motion"));
    ok(folder, &["report", "dzhanibekov.csv", "--scene", "dzhanibekov", "-o", "with.html"]);
    assert!(text(folder, "with.html").contains("Pictures of the motion"));
}

#[test]
fn hostile_words_stay_words() {
    let folder = folder_with(HOSTILE);
    let folder = folder.path();
    ok(folder, &["report", "scene.toml", "-o", "page.html"]);
    let page = text(folder, "page.html");
    holds_nothing_from_elsewhere(&page);
    assert!(page.contains("&lt;script&gt;alert(1)&lt;/script&gt;"), "the title is there, as words");
    ok(folder, &["plot", "scene.toml", "-o", "plot.svg"]);
    assert!(words(&text(folder, "plot.svg")).starts_with("<script>alert(1)</script>"));
    let parts: Vec<&str> = page.split("<svg").skip(1).filter_map(|rest| rest.split("</svg>").next()).collect();
    assert!(parts.len() > 8, "plots and pictures");
    for part in parts {
        roxmltree::Document::parse(&format!("<svg{part}</svg>")).expect("well-formed XML");
    }
}

#[test]
fn a_failed_check_is_on_the_page_and_exits_with_one() {
    let failing = format!(
        "{SCENE}\n[[check.value]]\nchannel = \"rotational_energy\"\ntime_s = 1.0\nexpected = 1e9\ntolerance = 1.0\n"
    );
    let folder = folder_with(&failing);
    let output = polhode(folder.path(), &["report", "scene.toml", "-o", "page.html"]);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    assert!(stderr(&output).contains("check failed: rotational_energy"), "{}", stderr(&output));
    assert!(text(folder.path(), "page.html").contains("✗ failed"));
}
