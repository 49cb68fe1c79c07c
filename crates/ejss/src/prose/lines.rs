//! Lines of Markdown: what would be markup is escaped, and none is longer than the limit.

/// Longest line of prose, in characters.
const LONGEST: usize = 120;
/// Longest line of code, in characters.
const LONGEST_CODE: usize = 180;

/// Text in which no character is markup of Markdown or begins a formula.
pub(crate) fn escaped(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let mut escaped = String::new();
    for (at, letter) in letters.iter().enumerate() {
        let is_inside =
            |at: Option<usize>| at.and_then(|at| letters.get(at)).is_some_and(|other| other.is_alphanumeric());
        let is_markup = match letter {
            '*' | '`' | '$' | '[' | ']' | '<' | '\\' | '~' | '{' => true,
            '_' => !(is_inside(at.checked_sub(1)) && is_inside(Some(at + 1))),
            _ => false,
        };
        if is_markup {
            escaped.push('\\');
        }
        escaped.push(*letter);
    }
    escaped
}

/// Paragraph on lines of bounded length, none of which begins like a heading, a list or a rule.
pub(crate) fn wrapped(text: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    let mut line = String::new();
    for word in text.split_whitespace().flat_map(|word| pieces(word, LONGEST)) {
        if !line.is_empty() && line.chars().count() + 1 + word.chars().count() > LONGEST {
            lines.push(std::mem::take(&mut line));
        }
        if line.is_empty() {
            line = at_start(&word);
        } else {
            line.push(' ');
            line.push_str(&word);
        }
    }
    lines.push(line);
    lines.join("\n")
}

/// A word at the start of a line, escaped where it would begin a heading, a list, a quotation or a rule.
fn at_start(word: &str) -> String {
    let is_number = word
        .strip_suffix(['.', ')'])
        .is_some_and(|number| !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()));
    if is_number {
        let (number, mark) = word.split_at(word.len() - 1);
        return format!("{number}\\{mark}");
    }
    let is_mark =
        word.starts_with(['#', '>', '=', '|']) || word.chars().all(|letter| matches!(letter, '-' | '+' | '='));
    if is_mark { format!("\\{word}") } else { word.to_owned() }
}

/// Word in pieces of at most this length.
fn pieces(word: &str, longest: usize) -> Vec<String> {
    let letters: Vec<char> = word.chars().collect();
    letters.chunks(longest).map(|piece| piece.iter().collect()).collect()
}

/// Text on a single line, cut off behind the limit.
pub(super) fn shortened(text: &str) -> String {
    cut(&text.split_whitespace().collect::<Vec<_>>().join(" "), LONGEST)
}

/// Text of at most this many characters, with an ellipsis where it is cut off.
pub(crate) fn cut(text: &str, longest: usize) -> String {
    if text.chars().count() <= longest {
        text.to_owned()
    } else {
        text.chars().take(longest - 1).chain(['…']).collect()
    }
}

/// Text with blanks in the place of control characters.
pub(crate) fn visible(text: &str) -> String {
    text.chars().map(|letter| if letter.is_control() { ' ' } else { letter }).collect()
}

/// Block of code whose fence is longer than any in the code. Long lines are divided.
pub(crate) fn code(word: &str, code: &str) -> String {
    let fence = "`".repeat(longest_row(code).max(2) + 1);
    let mut block = format!("{fence}{word}\n");
    for line in code.lines() {
        for (index, piece) in divided(visible(line).trim_end()).into_iter().enumerate() {
            block.push_str(if index == 0 { "" } else { "    " });
            block.push_str(&piece);
            block.push('\n');
        }
    }
    block.push_str(&fence);
    block
}

/// Length of the longest row of backquotes.
fn longest_row(text: &str) -> usize {
    text.split(|letter| letter != '`').map(str::len).max().unwrap_or(0)
}

/// Line of code in pieces, behind a blank where there is one.
fn divided(line: &str) -> Vec<String> {
    let mut rest: Vec<char> = line.chars().collect();
    let mut pieces = Vec::new();
    while rest.len() > LONGEST_CODE {
        let at = rest[..LONGEST_CODE]
            .iter()
            .rposition(|letter| *letter == ' ')
            .filter(|at| *at > LONGEST_CODE / 2)
            .unwrap_or(LONGEST_CODE);
        pieces.push(rest.drain(..at).collect());
    }
    pieces.push(rest.into_iter().collect());
    pieces
}
