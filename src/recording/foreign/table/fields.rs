use std::borrow::Cow;

use crate::recording::foreign::Separator;

/// Most columns of a line.
const MOST_COLUMNS: usize = 1 << 16;

impl Separator {
    /// What a line shows: a semicolon before a tab before a comma, as decimals and names may hold the latter.
    pub(super) fn of(line: &str) -> Self {
        let candidates = [(';', Self::Semicolon), ('\t', Self::Tab), (',', Self::Comma)];
        let found = candidates.into_iter().find(|(mark, _)| line.contains(*mark));
        found.map_or(Self::Blank, |(_, separator)| separator)
    }

    fn ends_field(self, mark: char) -> bool {
        match self {
            Self::Comma => mark == ',',
            Self::Semicolon => mark == ';',
            Self::Tab => mark == '\t',
            Self::Blank => mark == ' ' || mark == '\t',
        }
    }
}

/// The fields of a line, without blanks around them and without the quotes that may enclose them, in which a quote is
/// doubled.
///
/// # Errors
/// What is wrong with a quote.
pub(super) fn fields(line: &str, separator: Separator) -> Result<Vec<Cow<'_, str>>, &'static str> {
    let is_blank = |mark: char| mark == ' ' || mark == '\t' && separator != Separator::Tab;
    let mut fields = Vec::new();
    let mut rest = line.trim_matches(is_blank);
    loop {
        let (field, after) = if let Some(quoted) = rest.strip_prefix('"') {
            unquoted(quoted).ok_or("has a quote that is not closed")?
        } else {
            let end = rest.find(|mark| separator.ends_field(mark)).unwrap_or(rest.len());
            let (field, after) = rest.split_at(end);
            (Cow::Borrowed(field.trim_end_matches(is_blank)), after)
        };
        if fields.len() == MOST_COLUMNS {
            return Err("has more than 65536 columns");
        }
        fields.push(field);
        let after = if separator == Separator::Blank { after } else { after.trim_start_matches(is_blank) };
        let mut marks = after.chars();
        match marks.next() {
            None => return Ok(fields),
            Some(mark) if separator.ends_field(mark) => rest = marks.as_str().trim_start_matches(is_blank),
            Some(_) => return Err("has text after a closing quote"),
        }
    }
}

/// The text up to the closing quote, and what follows that.
fn unquoted(text: &str) -> Option<(Cow<'_, str>, &str)> {
    let mut from = 0;
    loop {
        let end = from + text.get(from..)?.find('"')?;
        let after = text.get(end + 1..)?;
        if !after.starts_with('"') {
            let field = text.get(..end)?;
            let field = if from > 0 { Cow::Owned(field.replace("\"\"", "\"")) } else { Cow::Borrowed(field) };
            return Some((field, after));
        }
        from = end + 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn split(line: &str) -> Vec<String> {
        let fields = fields(line, Separator::of(line)).expect("fields");
        fields.into_iter().map(Cow::into_owned).collect()
    }

    #[test]
    fn each_separator_is_found() {
        for line in ["a,b, c", "a;b; c ", "a\tb\tc", "  a   b c ", "\"a\",\"b\" ,c", "\"a\" \"b\" \"c\""] {
            assert_eq!(split(line), ["a", "b", "c"], "{line:?}");
        }
        assert_eq!(split("\"q[0], \"\"w\"\"\";t"), ["q[0], \"w\"", "t"]);
        assert_eq!(split("a,,b,"), ["a", "", "b", ""]);
        assert_eq!(split("é,\"ü\""), ["é", "ü"]);
    }

    #[test]
    fn bad_quotes_are_refused() {
        for line in ["\"a", "\"a\"b,c", "1,\"\"\"", "\""] {
            assert!(fields(line, Separator::Comma).is_err(), "{line:?}");
        }
    }
}
