use std::borrow::Cow;
use std::io::{self, Write};

use crate::recording::{PartFile, RecordingError};

/// `text` with what would drive a terminal written out, as names of files and words in them may hold anything.
fn harmless(text: &str) -> Cow<'_, str> {
    let is_harmless = |letter: char| !letter.is_control() || letter == '\n';
    if text.chars().all(is_harmless) {
        return text.into();
    }
    let mut written = String::new();
    for letter in text.chars() {
        if is_harmless(letter) { written.push(letter) } else { written.extend(letter.escape_default()) }
    }
    written.into()
}

/// Puts `text` on stdout. A reader that has gone away, such as `head`, is no fault.
pub fn print(text: &str) -> Result<(), io::Error> {
    print_coloured(&harmless(text))
}

/// The same with colours of the program's own: `text` holds no name of a file, and no words of one.
pub fn print_coloured(text: &str) -> Result<(), io::Error> {
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
    let _ = writeln!(io::stderr().lock(), "{}", harmless(text));
}

/// A whole file of bytes under the name that was claimed.
pub fn write(mut file: PartFile, bytes: &[u8]) -> Result<(), RecordingError> {
    let path = file.path().to_path_buf();
    file.write_all(bytes).map_err(|source| RecordingError::Io { attempt: "write", path, source })?;
    file.sync()?;
    file.publish()
}
