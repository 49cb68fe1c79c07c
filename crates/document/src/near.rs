//! Which known name an unknown one may stand for.

/// The candidate nearest to `word`, if one is near: at most a third of its letters (or one of two) wrong.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word: Vec<char> = word.chars().take(80).flat_map(char::to_lowercase).collect();
    let allowed = (word.len() / 3).max(usize::from(word.len() == 2));
    candidates
        .into_iter()
        .map(|candidate| (distance(&word, candidate), candidate))
        .filter(|(distance, _)| *distance <= allowed)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// How many letters to insert, remove, replace or swap with their neighbour (optimal string alignment).
fn distance(word: &[char], candidate: &str) -> usize {
    let candidate: Vec<char> = candidate.chars().take(80).flat_map(char::to_lowercase).collect();
    let mut rows: [Vec<usize>; 3] = [Vec::new(), Vec::new(), (0..=candidate.len()).collect()];
    for i in 1..=word.len() {
        rows.rotate_left(1);
        let mut row = vec![i];
        for j in 1..=candidate.len() {
            let replaced = rows[1][j - 1] + usize::from(word[i - 1] != candidate[j - 1]);
            let mut best = replaced.min(rows[1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && word[i - 1] == candidate[j - 2] && word[i - 2] == candidate[j - 1] {
                best = best.min(rows[0][j - 2] + 1);
            }
            row.push(best);
        }
        rows[2] = row;
    }
    rows[2].last().copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_names_are_found_and_far_ones_are_not() {
        assert_eq!(nearest("titel", ["title", "step"]), Some("title"));
        assert_eq!(nearest("modle", ["model", "scene"]), Some("model"));
        assert_eq!(nearest("Step", ["title", "step"]), Some("step"));
        assert_eq!(nearest("author", ["title", "step"]), None);
        assert_eq!(nearest("", ["step"]), None);
        assert_eq!(nearest("L", ["g"]), None);
        assert_eq!(nearest("rh", ["rho"]), Some("rho"));
    }
}
