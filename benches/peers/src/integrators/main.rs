//! polhode beside other people's integrators: error against CPU time, in one process, on one thread.
//!
//! `cargo run --release` in this folder prints a table for each case; `--markdown` as docs/performance.md has them.

mod cases;
mod compare;
mod differential_equations;
mod ode_solvers;
mod peer;
mod rapier;
mod table;

use std::error::Error;

use crate::differential_equations::{DifferentialEquations, Method, Outputs};
use crate::ode_solvers::OdeSolvers;
use crate::peer::Peer;
use crate::rapier::Rapier;
use crate::table::Style;

fn main() -> Result<(), Box<dyn Error>> {
    let style = match std::env::args().nth(1).as_deref() {
        None => Style::Terminal,
        Some("--markdown") => Style::Markdown,
        Some(other) => return Err(format!("{other}: the only option is --markdown").into()),
    };
    let peers = peers();
    for case in cases::all() {
        let (rows, doubt_rad) = compare::compare(&case, &peers)?;
        println!("{}\n\n{}", case.name, table::table(&rows, doubt_rad, &peers, style));
    }
    Ok(())
}

/// Ways to use one crate stand together.
fn peers() -> Vec<Box<dyn Peer>> {
    let mut peers: Vec<Box<dyn Peer>> = vec![Box::new(OdeSolvers)];
    for method in [Method::Dop853, Method::Rkv989e] {
        for outputs in [Outputs::Stepped, Outputs::Interpolated] {
            peers.push(Box::new(DifferentialEquations { method, outputs }));
        }
    }
    for substeps in [1, 4, 16] {
        peers.push(Box::new(Rapier { substeps }));
    }
    peers
}
