//! Points in the source text: `(x, 0 [m])`, `0.2 [s]*(x', 0)`, `(0, 0) (x, y)`.

use std::ops::Range;

/// A point in parentheses, as byte ranges in the source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pair {
    /// Range with the parentheses.
    pub whole: Range<usize>,
    /// Range before the comma.
    pub first: Range<usize>,
    /// Range after the comma.
    pub second: Range<usize>,
}

/// An item of a list of points or of a path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// A command of a path, such as `M`.
    Command(char),
    /// A point.
    Point(Pair),
}

/// Pairs of an expression that is a point: a sum of terms, each with one pair as a factor. `None` for other expressions.
pub fn pairs(source: &str, range: Range<usize>) -> Option<Vec<Pair>> {
    let mut pairs = Vec::new();
    for term in terms(source, range) {
        let mut found = groups(source, term.clone()).into_iter().filter_map(|group| pair(source, group));
        let pair = found.next()?;
        let before = source[term.start..pair.whole.start].trim_end();
        let behind = source[pair.whole.end..term.end].trim_start();
        let is_factor = (before.is_empty() || before.ends_with('*'))
            && (behind.is_empty() || behind.starts_with(['*', '/']))
            && found.next().is_none();
        if !is_factor {
            return None;
        }
        pairs.push(pair);
    }
    (!pairs.is_empty()).then_some(pairs)
}

/// Items of a list of points, separated by blanks or commas. `commands`: letters of path commands that may stand between.
/// The error is the range of an invalid item.
pub fn steps(source: &str, range: Range<usize>, commands: &str) -> Result<Vec<Step>, Range<usize>> {
    let groups = groups(source, range.clone());
    let mut steps = Vec::new();
    let mut at = range.start;
    for group in groups.iter().cloned().map(Some).chain([None]) {
        let end = group.as_ref().map_or(range.end, |group| group.start);
        for (offset, letter) in source[at..end].char_indices() {
            if commands.contains(letter) {
                steps.push(Step::Command(letter));
            } else if !letter.is_whitespace() && letter != ',' {
                return Err(at + offset..at + offset + letter.len_utf8());
            }
        }
        if let Some(group) = group {
            at = group.end;
            steps.push(Step::Point(pair(source, group.clone()).ok_or(group)?));
        }
    }
    Ok(steps)
}

/// Splits `LOW..HIGH`.
pub fn interval(source: &str, range: &Range<usize>) -> Option<(Range<usize>, Range<usize>)> {
    let middle = range.start + source[range.clone()].find("..")?;
    Some((range.start..middle, middle + 2..range.end))
}

/// Terms of a sum, without their signs.
fn terms(source: &str, range: Range<usize>) -> Vec<Range<usize>> {
    let mut terms = Vec::new();
    let mut start = range.start;
    for (at, letter) in outside(source, range.clone()) {
        let before = source[range.start..at].trim_end_matches(['e', 'E']);
        let is_exponent = before.len() < at - range.start && before.ends_with(|c: char| c.is_ascii_digit() || c == '.');
        if matches!(letter, '+' | '-') && !is_exponent {
            terms.push(start..at);
            start = at + 1;
        }
    }
    terms.push(start..range.end);
    // A sign before the first term leaves an empty term.
    let first =
        usize::from(terms.len() > 1 && terms.first().is_some_and(|term| source[term.clone()].trim().is_empty()));
    terms.split_off(first)
}

/// Characters outside parentheses, brackets and texts, with their byte positions.
fn outside(source: &str, range: Range<usize>) -> Vec<(usize, char)> {
    let mut depth = 0_u32;
    let mut quoted = false;
    let mut found = Vec::new();
    for (offset, letter) in source[range.clone()].char_indices() {
        match letter {
            '"' => quoted = !quoted,
            _ if quoted => {}
            '(' | '[' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            _ if depth == 0 => found.push((range.start + offset, letter)),
            _ => {}
        }
    }
    found
}

/// Outermost parentheses, except those of calls.
fn groups(source: &str, range: Range<usize>) -> Vec<Range<usize>> {
    let mut groups = Vec::new();
    let mut open = Vec::new();
    let mut quoted = false;
    for (offset, letter) in source[range.clone()].char_indices() {
        let at = range.start + offset;
        match letter {
            '"' => quoted = !quoted,
            _ if quoted => {}
            '(' => open.push(at),
            ')' => {
                let start = open.pop().filter(|_| open.is_empty());
                let is_call = |start: usize| {
                    source[range.start..start].ends_with(|c: char| c.is_alphanumeric() || matches!(c, '_' | '\''))
                };
                // A path command also stands directly before its point; it is a single letter.
                groups.extend(
                    start
                        .filter(|start| !is_call(*start) || is_command(source, &range, *start))
                        .map(|start| start..at + 1),
                );
            }
            _ => {}
        }
    }
    groups
}

/// True if the letter before a parenthesis stands alone.
fn is_command(source: &str, range: &Range<usize>, at: usize) -> bool {
    let mut before = source[range.start..at].chars().rev();
    let letter = before.next().is_some_and(|letter| letter.is_ascii_uppercase());
    letter && before.next().is_none_or(|other| !other.is_alphanumeric() && !matches!(other, '_' | '\''))
}

/// Splits a parenthesis with one comma.
fn pair(source: &str, whole: Range<usize>) -> Option<Pair> {
    let inside = whole.start + 1..whole.end - 1;
    let mut commas = outside(source, inside.clone()).into_iter().filter(|(_, letter)| *letter == ',');
    let (comma, _) = commas.next()?;
    commas.next().is_none().then_some(Pair { whole, first: inside.start..comma, second: comma + 1..inside.end })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(text: &str) -> Option<Vec<(&str, &str)>> {
        let pairs = pairs(text, 0..text.len())?;
        Some(pairs.into_iter().map(|pair| (text[pair.first].trim(), text[pair.second].trim())).collect())
    }

    #[test]
    fn a_point_is_a_sum_of_pairs_with_factors() {
        assert_eq!(written("(x, 0 [m])"), Some(vec![("x", "0 [m]")]));
        assert_eq!(written("0.2 [s]*(x', 0)"), Some(vec![("x'", "0")]));
        assert_eq!(written("-(1, 2) + 1e-3*(atan2(a, b), y(0))/2"), Some(vec![("1", "2"), ("atan2(a, b)", "y(0)")]));
        for text in
            ["", "x", "atan2(a, b)", "1 + (x, y)", "(x, y)*(1, 2)", "2/(x, y)", "(x, y)^2", "(1, 2, 3)", "sin((1, 2))"]
        {
            assert_eq!(written(text), None, "{text}");
        }
    }

    #[test]
    fn lists_and_paths_are_points_and_commands() {
        let text = "M(0, 1) L (f(2, 3), 1), (1, 1) Z";
        let found = steps(text, 0..text.len(), "MLZ").map(|steps| steps.len());
        assert_eq!(found, Ok(6));
        assert_eq!(steps("M 1 2", 0..5, "ML"), Err(2..3));
        assert_eq!(steps("(1)", 0..3, ""), Err(0..3));
    }
}
