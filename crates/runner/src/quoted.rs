//! Quoting of words in commands that users copy.

use std::ffi::OsStr;

/// Quotes a path or another word for a shell if it contains blanks or special characters.
pub fn quoted(word: impl AsRef<OsStr>) -> String {
    let text = word.as_ref().to_string_lossy().into_owned();
    let is_plain =
        |letter: char| letter.is_alphanumeric() || "-_./:,+@%".contains(letter) || cfg!(windows) && letter == '\\';
    if !text.is_empty() && text.chars().all(is_plain) {
        text
    } else if cfg!(windows) {
        format!("\"{text}\"")
    } else {
        format!("'{}'", text.replace('\'', r"'\''"))
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn what_a_shell_would_divide_is_quoted() {
        for (path, expected) in [
            ("a/b-1.md", "a/b-1.md"),
            ("péndulo.md", "péndulo.md"),
            ("my folder/a.md", "'my folder/a.md'"),
            ("it's $a.md", r"'it'\''s $a.md'"),
        ] {
            assert_eq!(quoted(path), expected);
        }
    }
}
