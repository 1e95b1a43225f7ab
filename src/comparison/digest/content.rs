use std::fmt::Write as _;
use std::path::Path;

use sha2::{Digest as _, Sha256};

use crate::recording::{RecordedBody, Recording, RecordingError};
use crate::telemetry::Channel;

/// Begins what is hashed: another number stands for another way to hash.
const VERSION: &str = "polhode digest 1";

/// The SHA-256 of a recording's content: bodies, channels, times and values, to the bit.
///
/// Of one run it is the same for `.mcap`, `.rrd` and `.csv`, however they are compressed and cut into chunks. So nothing
/// is in it that one of them does not hold: no scene text, no facts about where the recording comes from, not the name of
/// a single body, no body of which nothing is recorded.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Digest {
    /// In hexadecimal digits.
    pub sha256: String,
    /// How many samples.
    pub samples: u64,
    /// How many columns of numbers, the times among them.
    pub columns: usize,
}

/// The digest of the whole recording at `path`.
///
/// Each column has a SHA-256 of its own, of its numbers as f64 in little-endian order. The digest is that of these lines, each
/// with a line feed: `polhode digest 1`; `samples` and how many; then for the column of times and those of each body, bodies
/// by name, channels in the order of [`Channel::ALL`]: the column's SHA-256 in hexadecimal
/// digits, two blanks, and its name, which with several bodies starts with the body's and a full stop, as a `.csv` has it.
///
/// # Errors
/// As [`Recording::open`] and [`Recording::next_batch`]; if its end is missing.
pub fn digest(path: &Path) -> Result<Digest, RecordingError> {
    let mut recording = Recording::open(path)?;
    let mut columns = columns(&recording.heading().bodies);
    let (mut samples, mut bytes) = (0, Vec::new());
    while let Some(batch) = recording.next_batch()? {
        samples += batch.len() as u64;
        for column in &mut columns {
            let numbers = match column.place {
                None => Some(&batch.times_s),
                Some((body, index)) => batch.bodies.get(body).and_then(|body| body.columns().get(index)),
            };
            bytes.clear();
            bytes.extend(numbers.into_iter().flatten().flat_map(|number| number.to_le_bytes()));
            column.hash.update(&bytes);
        }
    }
    if !recording.is_whole() {
        let reason = "its end is missing: `polhode recover` makes a whole recording of it".into();
        return Err(RecordingError::Decode { path: path.into(), reason });
    }
    let mut lines = format!("{VERSION}\nsamples {samples}\n");
    let count = columns.len();
    for column in columns {
        // Writing to a string cannot fail.
        let _ = writeln!(lines, "{:x}  {}", column.hash.finalize(), column.name);
    }
    Ok(Digest { sha256: format!("{:x}", Sha256::digest(lines)), samples, columns: count })
}

/// A column of numbers on its way to its hash.
struct Column {
    name: String,
    /// Body and column; `None` for the times.
    place: Option<(usize, usize)>,
    hash: Sha256,
}

fn columns(bodies: &[RecordedBody]) -> Vec<Column> {
    let mut recorded: Vec<_> = bodies.iter().enumerate().filter(|(_, body)| !body.channels.is_empty()).collect();
    recorded.sort_by(|(_, one), (_, other)| one.name.cmp(&other.name));
    let is_single = recorded.len() == 1;
    let mut columns = vec![Column { name: "time_s".into(), place: None, hash: Sha256::new() }];
    for (number, body) in recorded {
        let prefix = if is_single { String::new() } else { format!("{}.", body.name) };
        for (channel, first) in placed(body) {
            let row = channel.row();
            columns.extend((0..row.components.len()).map(|component| Column {
                name: format!("{prefix}{}", row.column_name(component)),
                place: Some((number, first + component)),
                hash: Sha256::new(),
            }));
        }
    }
    columns
}

/// The body's channels in order, each with its first column: a table made by hand may have them in another.
fn placed(body: &RecordedBody) -> Vec<(Channel, usize)> {
    let mut next = 0;
    let place = |channel: &Channel| {
        let first = next;
        next += channel.width();
        (*channel, first)
    };
    let mut placed: Vec<_> = body.channels.iter().map(place).collect();
    placed.sort_unstable();
    placed
}
