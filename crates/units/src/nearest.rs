//! Similar names, for hints such as "did you mean `gamma`?".

use strsim::osa_distance;

/// The candidate with the smallest edit distance (insertions, deletions, replacements and exchanges of neighbours)
/// from `name`, the first of several; `None` if none is similar enough.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = name.chars().count();
    if length > LONGEST_COMPARED {
        return None;
    }
    let tolerance = if length <= 2 { 1 } else { length.div_ceil(3).min(3) };
    candidates
        .into_iter()
        .filter(|candidate| candidate.chars().count().abs_diff(length) <= tolerance)
        .map(|candidate| (osa_distance(name, candidate), candidate))
        .filter(|&(distance, candidate)| distance <= tolerance && (distance < length || similar(name, candidate)))
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, candidate)| candidate)
}

/// Maximum length of a name, in characters: the time grows with the square of the length.
const LONGEST_COMPARED: usize = 64;

/// True if two names differ only in case; the only similarity that counts for names of one letter.
fn similar(a: &str, b: &str) -> bool {
    a.eq_ignore_ascii_case(b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_misspelled_name_is_near_and_another_is_not() {
        for (written, known, meant) in [
            ("titel", "title", true),
            ("Step", "step", true),
            ("author", "title", false),
            ("author", "step", false),
            ("", "step", false),
            ("L", "g", false),
        ] {
            assert_eq!(nearest(written, [known]), meant.then_some(known), "{written}");
        }
    }
}
