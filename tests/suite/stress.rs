//! Every method on the motions that break methods: `auto` gives nothing that must not be given, and every other cell is
//! as docs/stability.md has it.
//!
//! `POLHODE_BLESS=1 cargo test stress` writes the quick matrix there anew; read what changed before it is committed.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use polhode::scenario::Method;
use polhode::study::{Case, Depth, Ending, Row, Trial, Truth, Verdict, cases, stress};

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
    let found: Vec<String> = rows.iter().map(line).collect();
    let kept = documented(&found);
    let differing: Vec<_> = found.iter().zip(&kept).filter(|(found, kept)| !are_alike(found, kept)).collect();
    assert_eq!(found.len(), kept.len(), "cases came or went: put what `polhode stress` prints into docs/stability.md");
    assert!(differing.is_empty(), "now, and in docs/stability.md:\n{differing:#?}");
}

/// Long spans and many steps are for `polhode stress --full`; its matrix must at least have every case but that of 1e8 steps.
#[test]
fn the_full_matrix_has_every_case_and_nothing_that_must_not_be() {
    let text = fs::read_to_string(document()).expect("docs/stability.md is there");
    let (_, full) = text.split_once(FULL).expect("a full matrix");
    let (full, _) = full.split_once("```").expect("its end");
    for case in cases() {
        let prefix = format!("{} ", case.key);
        let line = full.lines().find(|line| line.starts_with(&prefix));
        let line = line.unwrap_or_else(|| panic!("{} is not in it: polhode stress --full", case.key));
        assert!(!line.contains("!!"), "{line}");
    }
}

/// Chaos is no excuse: what can be told of such a motion is, and every method is held to it.
#[test]
fn chaotic_motions_are_judged_as_far_as_f64_can_follow_them() {
    let case = case("gradient_1e9");
    let row = stress(&case, &[Method::Auto, Method::Taylor, Method::EulerNaive], Depth::Quick);
    let truth = row.truth.expect("a reference");
    let (horizon, end) = (truth.horizon_s.expect("a horizon"), truth.times_s[truth.times_s.len() - 1]);
    assert!(horizon > 0.2 * end && horizon < end, "{horizon} s of {end} s");
    assert!(truth.condition_rad <= Truth::HORIZON_RAD, "{}", truth.condition_rad);
    let verdicts: Vec<_> = row.cells.iter().map(|cell| cell.verdict).collect();
    assert_eq!(verdicts, [Verdict::Kept, Verdict::Kept, Verdict::Lost]);
    // Nobody can keep a promise beyond it, and it is not made.
    assert!(row.cells[0].trials.iter().all(|trial| trial.value.is_none()), "{:?}", row.cells[0].trials);
}

/// A closed form is right for the numbers that it is given, at any time: it is judged there, though roundings of the start
/// move the motion by more than a radian.
#[test]
fn periodic_motions_are_judged_to_their_ends() {
    let row = stress(&case("rates_1e6_9e9_s"), &[Method::ClosedForm], Depth::Quick);
    assert_eq!((row.truth.expect("a reference").horizon_s, row.cells[0].verdict), (None, Verdict::Kept));
}

/// The shortest step is the one that was made, not a mean: a pulse of a microsecond has its own.
#[test]
fn short_steps_are_told() {
    let row = stress(&case("pulse"), &[Method::Taylor, Method::Rk4, Method::Auto], Depth::Quick);
    for cell in &row.cells {
        let shortest = cell.best().and_then(|trial| trial.effort.shortest_step_s).expect("steps");
        assert!(shortest > 0.0 && shortest <= 1.001e-6, "{}: {shortest}", cell.method.key());
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
    format!("{:widest$} {}", row.case.key, cells.concat())
}

fn document() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/stability.md")
}

/// The rows of the quick matrix of docs/stability.md; written anew first if that is asked for.
fn documented(found: &[String]) -> Vec<String> {
    let text = fs::read_to_string(document()).expect("docs/stability.md is there");
    let (before, rest) = text.split_once(BEGIN).expect("a quick matrix");
    let (matrix, after) = rest.split_once(END).expect("its end");
    let key = |line: &str| line.split(' ').next().unwrap_or_default().to_owned();
    let is_row = |line: &&str| found.iter().any(|found| key(found) == key(line));
    if std::env::var_os("POLHODE_BLESS").is_none() {
        return matrix.lines().filter(is_row).map(str::to_owned).collect();
    }
    let now = |line: &str| found.iter().find(|found| key(found) == key(line)).map_or(line, String::as_str).to_owned();
    let matrix: String = matrix.lines().map(|line| now(line) + "\n").collect();
    fs::write(document(), format!("{before}{BEGIN}{matrix}{END}{after}")).expect("docs/stability.md can be written");
    found.to_vec()
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
