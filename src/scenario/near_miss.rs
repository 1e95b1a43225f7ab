/// The candidate that a mistyped `word` most likely means, if one is near.
pub fn nearest<'word>(word: &str, candidates: impl Iterator<Item = &'word str>) -> Option<&'word str> {
    let bearable = word.chars().count() / 3 + 1;
    let is_part = |candidate: &str| word.len() >= 4 && candidate.contains(word);
    candidates
        .map(|candidate| (if is_part(candidate) { 1 } else { distance(word, candidate) }, candidate))
        .min()
        .filter(|(distance, _)| *distance <= bearable)
        .map(|(_, candidate)| candidate)
}

/// Levenshtein's distance: how many letters to insert, delete or replace.
fn distance(from: &str, to: &str) -> usize {
    let to: Vec<char> = to.chars().collect();
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (index, letter) in from.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = index + 1;
        for (column, other) in to.iter().enumerate() {
            let replaced = diagonal + usize::from(letter != *other);
            diagonal = row[column + 1];
            row[column + 1] = replaced.min(diagonal + 1).min(row[column] + 1);
        }
    }
    row[to.len()]
}
