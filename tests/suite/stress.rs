//! Every method on the motions that break methods: `auto` gives nothing that must not be given, and every other cell is
//! as docs/stability.md has it.
//!
//! `POLHODE_BLESS=1 cargo test stress` writes the quick matrix there anew; read what changed before it is committed.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use polhode::scenario::Method;
use polhode::study::{Case, Depth, Ending, Row, Trial, Verdict, cases, stress};

const BEGIN: &str = "<!-- quick matrix -->\n```text\n";
const END: &str = "```\n<!-- end of quick matrix -->\n";
const FULL: &str = "<!-- full matrix -->\n```text\n";

#[test]
fn auto_is_never_wrong_and_every_cell_is_as_documented() {
    let rows = quick();
    for row in &rows {
        for cell in &row.cells {
            let trials = &cell.trials;
            assert_ne!(cell.verdict, Verdict::Wrong, "{} by {}: {trials:?}", row.case.key, cell.method.key());
            let bound = matches!(cell.method, Method::Auto | Method::ClosedForm);
            assert!(!bound || is_kept_or_refused(cell.verdict), "{}: {trials:?}", row.case.key);
            assert!(trials.iter().all(|trial| trial.ending != Ending::Silent), "{} is silent", row.case.key);
            assert!(trials.iter().all(|trial| trial.norm_error <= Trial::NORM), "{} leaves the sphere", row.case.key);
        }
    }
    let found: String = rows.iter().map(line).collect();
    let kept = documented(&found);
    let differing: Vec<_> = found.lines().zip(kept.lines()).filter(|(found, kept)| !are_alike(found, kept)).collect();
    assert_eq!(found.lines().count(), kept.lines().count(), "cases came or went: bless docs/stability.md");
    assert!(differing.is_empty(), "now, and in docs/stability.md:\n{differing:#?}");
}

/// Long spans and many steps are for `polhode stress --full`; its matrix must at least have every case but that of 1e8 steps.
#[test]
fn the_full_matrix_has_every_case_and_nothing_that_must_not_be() {
    let text = fs::read_to_string(document()).expect("docs/stability.md is there");
    let (_, full) = text.split_once(FULL).expect("a full matrix");
    let (full, _) = full.split_once("```").expect("its end");
    for case in cases().into_iter().filter(|case| case.pace.is_none()) {
        let prefix = format!("{} ", case.key);
        let line = full.lines().find(|line| line.starts_with(&prefix));
        let line = line.unwrap_or_else(|| panic!("{} is not in it: polhode stress --full", case.key));
        assert!(!line.contains("!!"), "{line}");
    }
}

/// What is refused is refused for what it is, in words.
#[test]
fn refusals_are_clear() {
    for (key, words) in [
        ("moments_1e300", "the largest moment of inertia is 2.4e300 kg m²: 1e-60 to 1e60"),
        ("denormal_moments", "1e-60 to 1e60"),
        ("rates_1e160", "makes 2e160 rad/s: at most 1e60"),
        ("torque_1e100", "of them: at most 1e11"),
        ("torque_1e300", "of them: at most 1e11"),
        ("late_torque", "too small to advance the time"),
    ] {
        let case = case(key);
        let row = stress(&case, &[Method::Auto], Depth::Quick);
        let refusal = row.cells[0].refusal.clone().expect("it is refused");
        assert!(refusal.contains(words), "{key}: {refusal}");
        assert_eq!(row.cells[0].verdict, Verdict::Refused);
    }
}

/// A body that damping stops must be followed to its rest and beyond, by f64 as by the reference.
#[test]
fn what_damping_stops_stays_where_it_is() {
    for key in ["damping_stiff", "brake_hard"] {
        let row = stress(&case(key), &[Method::Auto, Method::Taylor], Depth::Quick);
        let truth = row.truth.expect("a reference");
        assert!(truth.reference.method.contains("double-double"), "{key} is measured by {}", truth.reference.method);
        for cell in &row.cells {
            let best = cell.best().expect("a run");
            assert!(best.error_rad < 1e-14, "{key} by {}: {best:?}", cell.method.key());
        }
    }
}

fn case(key: &str) -> Case {
    cases().into_iter().find(|case| case.key == key).expect("a case of that name")
}

fn is_kept_or_refused(verdict: Verdict) -> bool {
    matches!(verdict, Verdict::Kept | Verdict::Chaotic | Verdict::Refused | Verdict::TooLong | Verdict::Unjudged)
}

/// All quick cases, on two threads.
fn quick() -> Vec<Row> {
    let cases: Vec<Case> = cases().into_iter().filter(|case| case.depth == Depth::Quick).collect();
    let next = Mutex::new(cases.iter().enumerate());
    let rows = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                loop {
                    let taken = next.lock().expect("no thread panics with it").next();
                    let Some((number, case)) = taken else { break };
                    let row = stress(case, &Method::ALL, Depth::Quick);
                    rows.lock().expect("no thread panics with it").push((number, row));
                }
            });
        }
    });
    let mut rows = rows.into_inner().expect("no thread panicked");
    rows.sort_by_key(|(number, _)| *number);
    rows.into_iter().map(|(_, row)| row).collect()
}

/// As the program prints it.
fn line(row: &Row) -> String {
    let widest = cases().iter().filter(|case| case.depth == Depth::Quick).map(|case| case.key.len()).max().unwrap_or(0);
    let cells: Vec<_> = row.cells.iter().map(|cell| format!("{:>3}", cell.sign())).collect();
    format!("{:widest$} {}\n", row.case.key, cells.concat())
}

fn document() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/stability.md")
}

/// The quick matrix of docs/stability.md without its heading; written anew first if that is asked for.
fn documented(found: &str) -> String {
    let text = fs::read_to_string(document()).expect("docs/stability.md is there");
    let (before, rest) = text.split_once(BEGIN).expect("a quick matrix");
    let (matrix, after) = rest.split_once(END).expect("its end");
    let heading = matrix.lines().next().unwrap_or_default();
    if std::env::var_os("POLHODE_BLESS").is_none() {
        return matrix.split_inclusive('\n').skip(1).collect();
    }
    let text = format!("{before}{BEGIN}{heading}\n{found}{END}{after}");
    fs::write(document(), text).expect("docs/stability.md can be written");
    found.to_owned()
}

/// Whether two lines say the same to a digit; whether it is within a limit or not may then go either way.
fn are_alike(one: &str, other: &str) -> bool {
    let cells = |line: &str| {
        let (key, cells) = line.split_once(' ').unwrap_or((line, ""));
        let letters: Vec<char> = cells.trim_start_matches(' ').chars().collect();
        (key.to_owned(), letters)
    };
    let ((key, one), (other_key, other)) = (cells(one), cells(other));
    let split = |letters: &[char]| -> Vec<String> {
        // From the right, as names differ in length.
        letters.rchunks(3).map(|cell| cell.iter().collect::<String>().trim().to_owned()).collect()
    };
    let (one, other) = (split(&one), split(&other));
    key == other_key && one.len() == other.len() && one.iter().zip(&other).all(|(a, b)| is_like(a, b))
}

fn is_like(one: &str, other: &str) -> bool {
    let digits = |cell: &str| cell.trim_end_matches(['=', '~']).parse::<i32>().ok();
    match (digits(one), digits(other)) {
        (Some(a), Some(b)) => (a - b).abs() <= 1,
        _ => one == other,
    }
}

/// Gauss's methods carry |q| unforced: over many coarse steps it goes astray, and must not be recorded like that.
#[test]
fn samples_of_long_runs_are_of_unit_length() {
    let case = Case { pace: Some(4), ..case("tumbling_1000") };
    let row = stress(&case, &[Method::Gauss4, Method::Gauss6], Depth::Quick);
    for cell in &row.cells {
        let trial = cell.best().expect("a run");
        assert!(trial.effort.steps > 4000 && trial.norm_error <= Trial::NORM, "{:e}", trial.norm_error);
    }
}

/// RK4 on a brake a hundred times too stiff for its step: everything grows until |q|² overflows, and then there is an error.
#[test]
fn runs_that_explode_end_with_an_error() {
    let case = Case { pace: Some(4), ..case("brake_hard") };
    let row = stress(&case, &[Method::Rk4, Method::EulerNaive, Method::EulerSemiImplicit], Depth::Quick);
    for cell in &row.cells {
        assert_eq!(cell.verdict, Verdict::Lost, "{:?}", cell.trials);
    }
}
