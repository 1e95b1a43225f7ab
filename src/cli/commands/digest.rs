use std::io;

use serde_json::{Value, json};

use crate::cli::args::DigestArguments;
use crate::cli::execute::Outcome;
use crate::cli::output::{print, print_json, remark};
use crate::comparison::digest;

/// Prints the SHA-256 of what each recording holds, as `sha256sum` prints that of files.
pub fn execute(arguments: &DigestArguments) -> io::Result<Outcome> {
    let mut outcome = Outcome::Done;
    let mut values = Vec::new();
    for file in &arguments.files {
        let name = file.display();
        match digest(file) {
            Ok(digest) if arguments.json => values.push(json!({
                "file": name.to_string(),
                "sha256": digest.sha256,
                "samples": digest.samples,
                "columns": digest.columns,
            })),
            Ok(digest) => print(&format!("{}  {name}\n", digest.sha256))?,
            Err(error) => {
                remark(&format!("error: {error}"));
                values.push(json!({ "file": name.to_string(), "error": error.to_string() }));
                outcome = Outcome::Impossible;
            }
        }
    }
    if arguments.json {
        print_json(&Value::Array(values))?;
    }
    Ok(outcome)
}
