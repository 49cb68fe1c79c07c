//! Messages for callers who give settings by keywords, such as Python.

/// A message in which the options of the command line, `--until`, are spelled as keywords, `until`.
pub fn in_keywords(message: &str) -> String {
    let mut text = String::with_capacity(message.len());
    let mut rest = message;
    while let Some(at) = rest.find("--") {
        let starts = rest[..at].chars().next_back().is_none_or(|before| !before.is_alphanumeric() && before != '-');
        let names = rest[at + 2..].starts_with(|first: char| first.is_ascii_lowercase());
        text.push_str(&rest[..at]);
        if !(starts && names) {
            text.push_str("--");
        }
        rest = &rest[at + 2..];
    }
    text.push_str(rest);
    text
}
