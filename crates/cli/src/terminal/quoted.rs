//! Quoting of paths in commands that users copy.

use std::path::Path;

/// Quotes a path for a shell if it contains blanks or special characters.
pub fn quoted(path: &Path) -> String {
    let text = path.display().to_string();
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
            assert_eq!(quoted(Path::new(path)), expected);
        }
    }
}
