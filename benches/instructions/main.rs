//! How many instructions the hot paths take, against a table: a guard that no clock's noise reaches.
//!
//! `cargo bench --bench instructions` runs each case under valgrind, once and with more of the same, and takes the
//! difference; it fails where a count has grown. `POLHODE_BLESS=1 cargo bench --bench instructions` writes the table anew.

mod cases;
#[path = "../problems/mod.rs"]
mod problems;
mod table;
#[path = "../problems/top.rs"]
mod top;
mod valgrind;

use std::process::ExitCode;

use table::{Row, Table};

/// A count may grow by this share, %. Hash seeds and names of temporary files move recordings by up to 3.
const GROWTH_PERCENT: f64 = 5.0;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    if let [_, run, name, count] = arguments.as_slice()
        && run == valgrind::RUN
    {
        return cases::run(name, count.parse().unwrap_or(0));
    }
    if !valgrind::is_there() {
        println!("instructions: skipped, there is no valgrind");
        return ExitCode::SUCCESS;
    }
    let kept = Table::read();
    let found: Vec<Row> = cases::ALL
        .iter()
        .map(|case| Row { name: case.name.to_owned(), count: valgrind::count(case.name, case.count) })
        .collect();
    let compiler = table::compiler();
    let may_fail = kept.compiler == compiler;
    let mut code = ExitCode::SUCCESS;
    println!("{:40} {:>12} {:>12}", "instructions each", "kept", "now");
    for row in &found {
        let before = kept.rows.iter().find(|kept| kept.name == row.name).map(|kept| kept.count);
        let growth = before.map(|before| 100.0 * (row.count / before - 1.0));
        let shown = growth.map_or("new".to_owned(), |growth| format!("{growth:+.1} %"));
        println!("{:40} {:12.0} {:12.0} {shown}", row.name, before.unwrap_or(0.0), row.count);
        if growth.is_none_or(|growth| growth > GROWTH_PERCENT) && may_fail {
            code = ExitCode::FAILURE;
        }
    }
    if std::env::var_os("POLHODE_BLESS").is_some() {
        kept.with(found, compiler).write();
        return ExitCode::SUCCESS;
    }
    if !may_fail {
        println!("kept for {:?}, this is {compiler:?}: nothing fails", kept.compiler);
    } else if code == ExitCode::FAILURE {
        println!(
            "more than {GROWTH_PERCENT} % or new; where that is meant: POLHODE_BLESS=1 cargo bench --bench instructions"
        );
    }
    code
}
