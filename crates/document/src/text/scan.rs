//! Search for commas, colons and words outside brackets, quotation marks and comments.

use std::ops::Range;

/// Characters of `range` outside brackets, texts and comments, with their byte positions.
pub fn top_level(source: &str, range: Range<usize>) -> impl Iterator<Item = (usize, char)> {
    let start = range.start;
    let mut depth = 0usize;
    let mut quoted = false;
    let mut comment = false;
    source[range].char_indices().filter_map(move |(at, letter)| {
        let outside = !quoted && !comment && depth == 0;
        match letter {
            '\n' => {
                comment = false;
                quoted = false;
            }
            _ if comment => {}
            '"' => quoted = !quoted,
            _ if quoted => {}
            '#' => {
                comment = true;
                return None;
            }
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        outside.then_some((start + at, letter))
    })
}

/// Parts of `range` between `separator`s at the top level.
pub fn split(source: &str, range: Range<usize>, separator: char) -> Vec<Range<usize>> {
    let mut parts = Vec::new();
    let mut start = range.start;
    for (at, letter) in top_level(source, range.clone()) {
        if letter == separator {
            parts.push(start..at);
            start = at + separator.len_utf8();
        }
    }
    parts.push(start..range.end);
    parts
}

/// Words between two expressions that may occur in one line.
const CONNECTING: [&str; 14] =
    ["against", "for", "in", "at", "every", "from", "within", "of", "by", "step", "and", "or", "then", "else"];

/// Byte range of the last `word` at the top level that stands after a value. At the beginning, or after an operator or
/// another connecting word, it is the name of a quantity, as the first `at` of `at + 1 at end`.
pub fn find_word(source: &str, range: Range<usize>, word: &str) -> Option<Range<usize>> {
    let (mut found, mut follows_value, mut read) = (None, false, range.start);
    for (at, letter) in top_level(source, range.clone()) {
        if at < read || letter.is_whitespace() {
            continue;
        }
        let length = source[at..range.end].find(|c: char| !c.is_alphanumeric() && c != '_');
        let end = length.map_or(range.end, |length| at + length);
        let text = &source[at..end];
        read = end;
        follows_value = match text {
            "" => matches!(letter, '(' | '[' | '{' | '"' | '\'' | '′' | '%' | '°'),
            "if" | "not" => false,
            _ if follows_value && text == word => {
                found = Some(at..end);
                false
            }
            _ => !(follows_value && CONNECTING.contains(&text)),
        };
    }
    found
}

/// Byte range of the last `word` at the top level, regardless of the text before it.
pub fn find_any_word(source: &str, range: Range<usize>, word: &str) -> Option<Range<usize>> {
    let is_boundary = |letter: Option<char>| letter.is_none_or(|c| !c.is_alphanumeric() && c != '_');
    let first = word.chars().next();
    top_level(source, range.clone())
        .filter(|(at, letter)| Some(*letter) == first && source[*at..range.end].starts_with(word))
        .filter(|(at, _)| {
            is_boundary(source[range.start..*at].chars().next_back())
                && is_boundary(source[at + word.len()..range.end].chars().next())
        })
        .map(|(at, _)| at..at + word.len())
        .last()
}

/// Text in quotation marks at the beginning of `range`, and the byte after its closing mark.
pub fn leading_text(source: &str, range: Range<usize>) -> Option<(&str, usize)> {
    let inner = source[range.clone()].strip_prefix('"')?;
    let end = inner.find(['"', '\n'])?;
    inner[end..].starts_with('"').then(|| (&inner[..end], range.start + end + 2))
}

/// Statements in `range`: lines, continued on the next line after a comma or colon. Comments and blank lines are left out.
pub fn statements(source: &str, range: Range<usize>) -> Vec<Range<usize>> {
    let mut statements: Vec<Range<usize>> = Vec::new();
    let mut goes_on = false;
    for line in super::source::lines(source, range) {
        let line = without_comment(source, line.range());
        if line.is_empty() {
            continue;
        }
        match statements.last_mut() {
            Some(last) if goes_on => last.end = line.end,
            _ => statements.push(line.clone()),
        }
        goes_on = source[line].ends_with([',', ':']);
    }
    statements
}

/// A line without its comment and without outer blanks.
fn without_comment(source: &str, line: Range<usize>) -> Range<usize> {
    let mut quoted = false;
    let end = source[line.clone()]
        .find(|letter| {
            quoted ^= letter == '"';
            letter == '#' && !quoted
        })
        .map_or(line.end, |at| line.start + at);
    super::source::trim(source, line.start..end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn separators_inside_brackets_and_texts_do_not_count() {
        let source = "f(a, b), \"c, d\" [m, s], e # f, g";
        let parts: Vec<_> = split(source, 0..source.len(), ',').into_iter().map(|part| &source[part]).collect();
        assert_eq!(parts, ["f(a, b)", " \"c, d\" [m, s]", " e # f, g"]);
    }

    #[test]
    fn words_are_whole() {
        let source = "against_x, (against) against t";
        assert_eq!(find_word(source, 0..source.len(), "against"), Some(21..28));
        assert_eq!(find_word("x againsty", 0..10, "against"), None);
        assert_eq!(find_word("é within é", 0..12, "within"), Some(3..9));
        assert_eq!(find_any_word("within é", 0..9, "within"), Some(0..6));
    }

    /// Each connecting word can also be the name of a quantity.
    #[test]
    fn names_are_no_connecting_words() {
        for word in CONNECTING {
            for (before, after) in [
                ("x", "1"),
                (word, word),
                ("f(x)", "-1"),
                ("2 [m]", "y'"),
                (&format!("1 + {word}"), word),
                (&format!("{word}^2"), &format!("{word}*2")),
                (&format!("{word}(3)"), "(1 + 2)"),
                (&format!("not {word}"), "2.5 %"),
            ] {
                let line = format!("{before} {word} {after}");
                let expected = before.len() + 1..before.len() + 1 + word.len();
                assert_eq!(find_word(&line, 0..line.len(), word), Some(expected), "{line}");
                assert_eq!(find_word(before, 0..before.len(), word), None, "{before}");
            }
        }
    }

    #[test]
    fn statements_go_on_after_commas() {
        let source = "# a\n\"b # c\": d, # e\n  f\n\ng";
        let found: Vec<_> = statements(source, 0..source.len()).into_iter().map(|range| &source[range]).collect();
        assert_eq!(found, ["\"b # c\": d, # e\n  f", "g"]);
    }
}
