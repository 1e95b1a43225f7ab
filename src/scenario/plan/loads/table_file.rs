use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

/// Rows of a table at most: above it, a table is no longer an input.
pub const MOST_ROWS: usize = 1_000_000;
/// Bytes of a line at most.
const LONGEST_LINE: u64 = 4096;

/// Time and three components, from the rows of a CSV file: a line that names four columns, then numbers. Lines that are
/// empty or start with # say nothing. What is wrong is told with the number of its line.
pub fn read(path: &Path) -> Result<Vec<[f64; 4]>, String> {
    let file = File::open(path).map_err(|error| format!("cannot read {}: {error}", path.display()))?;
    let mut lines = BufReader::new(file);
    let (mut rows, mut has_header) = (Vec::new(), false);
    for number in 1_u64.. {
        let wrong = |what: String| format!("{}:{number}: {what}", path.display());
        let mut line = Vec::new();
        // A file without line ends is not taken into memory.
        let mut limited = std::io::Read::take(&mut lines, LONGEST_LINE);
        limited.read_until(b'\n', &mut line).map_err(|error| wrong(error.to_string()))?;
        if line.is_empty() {
            break;
        }
        let is_whole = line.ends_with(b"\n") || (line.len() as u64) < LONGEST_LINE;
        let line = std::str::from_utf8(&line).ok().filter(|_| is_whole);
        let line = line.ok_or_else(|| wrong(format!("no text of at most {LONGEST_LINE} bytes")))?.trim();
        let line = line.trim_start_matches('\u{feff}');
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let fields: Vec<&str> = line.split(',').map(str::trim).collect();
        let &[time, x, y, z] = fields.as_slice() else {
            return Err(wrong(format!("{} columns: time and three components are wanted", fields.len())));
        };
        if !has_header {
            if [time, x, y, z].iter().any(|name| name.parse::<f64>().is_ok()) {
                return Err(wrong(format!("{line:?} names no columns: the first line is a header")));
            }
            has_header = true;
            continue;
        }
        let mut row = [0.0; 4];
        for (place, field) in row.iter_mut().zip([time, x, y, z]) {
            *place = field
                .parse()
                .ok()
                .filter(|value: &f64| value.is_finite())
                .ok_or_else(|| wrong(format!("{field:?} is no finite number")))?;
        }
        if rows.last().is_some_and(|last: &[f64; 4]| row[0] <= last[0]) {
            return Err(wrong(format!("{:?} s does not come after the row before it", row[0])));
        }
        if rows.len() == MOST_ROWS {
            return Err(wrong(format!("more than {MOST_ROWS} rows")));
        }
        rows.push(row);
    }
    Ok(rows)
}
