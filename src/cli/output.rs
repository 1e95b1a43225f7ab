use std::io::{self, Write};

/// Puts `text` on stdout. A reader that has gone away, such as `head`, is no fault.
pub fn print(text: &str) -> Result<(), io::Error> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result,
    }
}

/// Puts `value` on stdout as indented JSON.
pub fn print_json(value: &serde_json::Value) -> Result<(), io::Error> {
    print(&format!("{value:#}\n"))
}

/// Puts a remark or an error on stderr, if anybody is there to read it.
pub fn remark(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}
