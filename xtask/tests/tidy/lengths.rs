//! Check of the length of files and of the number of files in a folder.

use crate::texts::{all_texts, holds, root};

/// Maximum number of lines of code in a file, including unit tests, without blank lines and comments.
const LONGEST: usize = 350;

/// Number of lines that are neither blank nor part of a comment. A line with code and a comment counts.
fn lines_of_code(text: &str) -> usize {
    let mut in_comment = false;
    let mut count = 0;
    for line in text.lines().map(str::trim) {
        let starts = !in_comment && line.starts_with("/*");
        let comment = in_comment || starts || line.starts_with("//");
        in_comment = (in_comment || starts) && !line.contains("*/");
        count += usize::from(!line.is_empty() && !comment);
    }
    count
}

#[test]
fn files_hold_one_subject() {
    let root = root();
    let long: Vec<String> = (all_texts().iter())
        .filter(|(path, _)| ["rs", "mjs", "js", "css"].iter().any(|ending| holds(path, ending)))
        .map(|(path, text)| (path.strip_prefix(&root).unwrap_or(path), lines_of_code(text)))
        .filter(|&(_, lines)| lines > LONGEST)
        .map(|(path, lines)| format!("{} has {lines} lines of code", path.display()))
        .collect();
    assert!(long.is_empty(), "at most {LONGEST} lines of code; split what is not one subject: {long:#?}");
}

#[test]
fn comments_and_blank_lines_do_not_count() {
    let text = "//! A file.\n\n/* of\nmany lines\n*/\nlet a = 1; // one\n    /// doc\nlet b = 2;\n/* one line */\nlet c = 3;\n";
    assert_eq!(lines_of_code(text), 3);
}

/// Maximum number of files of code in a folder.
const MOST: usize = 24;

#[test]
fn folders_hold_what_can_be_seen_at_once() {
    let root = root();
    let mut folders = std::collections::BTreeMap::<String, usize>::new();
    for (path, _) in all_texts().iter().filter(|(path, _)| ["rs", "mjs"].iter().any(|ending| holds(path, ending))) {
        let folder = path.strip_prefix(&root).unwrap_or(path).parent().map(|folder| folder.display().to_string());
        *folders.entry(folder.unwrap_or_default().replace('\\', "/")).or_default() += 1;
    }
    let full: Vec<String> = (folders.iter())
        .filter(|(_, count)| **count > MOST)
        .map(|(folder, count)| format!("{folder} has {count} files of code"))
        .collect();
    assert!(full.is_empty(), "at most {MOST} files of code in a folder: {full:#?}");
}
