//! Opens every example of the language reference, of the page for users of other tools, and of the tutorial. An example
//! followed by a ```text block must give exactly the diagnostics in it; any other must be free of errors. `UPDATE_EXPECT=1
//! cargo test -p document --test all reference` writes the diagnostics into the page, for review before a commit.

use model::{Diagnostic, Severity};
use std::path::{Path, PathBuf};

fn page(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs").join(name)
}

/// A fenced block of the page.
struct Block {
    kind: String,
    /// Byte range of its content in the page.
    content: std::ops::Range<usize>,
    /// True if only a blank line separates it from the block before.
    follows: bool,
}

fn blocks(page: &str) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    let mut open: Option<(String, String, usize)> = None;
    let mut last_end = 0;
    let mut at = 0;
    for line in page.split_inclusive('\n') {
        let text = line.trim_end();
        match &open {
            None if text.starts_with("```") => {
                let kind = text.trim_start_matches('`');
                let marks = text[..text.len() - kind.len()].to_owned();
                open = Some((marks, kind.to_owned(), at + line.len()));
            }
            Some((marks, kind, start)) if text == marks => {
                let opening = start - kind.len() - marks.len() - 1;
                let follows = !blocks.is_empty() && page[last_end..opening].trim().is_empty();
                blocks.push(Block { kind: kind.clone(), content: *start..at, follows });
                last_end = at + line.len();
                open = None;
            }
            _ => {}
        }
        at += line.len();
    }
    blocks
}

/// The document that contains the example, and the byte at which the example begins in it.
fn surroundings(page: &str, block: &Block, model: &str) -> Option<String> {
    let text = &page[block.content.clone()];
    match block.kind.as_str() {
        "markdown" => Some(text.to_owned()),
        "model" => Some(format!("```model\n{text}```\n")),
        kind @ ("scene" | "plots" | "presets" | "question" | "survey" | "check") => {
            Some(format!("```model\n{model}```\n\n```{kind}\n{text}```\n"))
        }
        _ => None,
    }
}

/// Diagnostics in plain text.
fn print(source: &str, diagnostic: &Diagnostic) -> String {
    let severity = match diagnostic.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    let mut text = format!("{severity}: {}\n", diagnostic.message.english());
    for label in &diagnostic.labels {
        let start = source[..label.span.start].rfind('\n').map_or(0, |at| at + 1);
        let end = source[start..].find('\n').map_or(source.len(), |length| start + length);
        let before = source[start..label.span.start].chars().count();
        let marked = source[label.span.start..label.span.end.clamp(label.span.start, end)].chars().count().max(1);
        text += &format!("  {}\n", &source[start..end]);
        text += format!("  {}{} {}", " ".repeat(before), "^".repeat(marked), label.text.english()).trim_end();
        text += "\n";
    }
    for note in &diagnostic.notes {
        text +=
            &note.english().lines().map(|line| format!("  {line}").trim_end().to_owned() + "\n").collect::<String>();
    }
    for hint in &diagnostic.hints {
        text += &format!("hint: {}\n", hint.english());
    }
    text
}

#[test]
fn every_example_does_what_the_reference_says() {
    let examples = check_examples("language.md");
    assert!(examples > 30, "{examples}");
}

#[test]
fn every_example_for_those_who_come_from_other_tools_runs() {
    let examples = check_examples("coming-from.md");
    assert!(examples >= 5, "{examples}");
}

/// Each step of the tutorial, and the result: the last document with its question, its check and its translation.
#[test]
fn every_step_of_the_tutorial_runs() {
    let name = "first-simulation.md";
    assert_eq!(check_examples(name), 5);
    let text = std::fs::read_to_string(page(name)).unwrap();
    let blocks = blocks(&text);
    let last = |kind: &str| {
        let block = blocks.iter().rfind(|block| block.kind == kind).unwrap_or_else(|| panic!("{kind}"));
        &text[block.content.clone()]
    };
    let (question, check) = (last("question"), last("check"));
    let whole = format!("{}\n```question\n{question}```\n\n```check\n{check}```\n", last("markdown"));
    let opened = document::open(&whole, &[last("text")]);
    assert!(opened.diagnostics.is_empty(), "{:?}", opened.diagnostics);
    let program = opened.document.unwrap().program;
    assert_eq!((program.questions.len(), program.checks.len(), program.editions.len()), (1, 1, 2));
}

/// Number of examples of a page.
fn check_examples(name: &str) -> usize {
    let page_text = std::fs::read_to_string(page(name)).unwrap();
    let blocks = blocks(&page_text);
    // Scenes, plots, presets and questions refer to the first model of the page; in the tutorial, to that of its last
    // document.
    let whole = blocks.iter().rfind(|block| block.kind == "markdown");
    let of_document = whole
        .and_then(|block| page_text[block.content.clone()].split("```").find_map(|part| part.strip_prefix("model\n")));
    let first = blocks.iter().find(|block| block.kind == "model").map(|block| &page_text[block.content.clone()]);
    let model = first.or(of_document).unwrap();
    let mut updated = page_text.clone();
    let mut examples = 0;
    for (index, block) in blocks.iter().enumerate().rev() {
        let Some(source) = surroundings(&page_text, block, model) else {
            continue;
        };
        examples += 1;
        let opened = document::open(&source, &[]);
        let findings: Vec<String> =
            opened.diagnostics.iter().map(|(_, diagnostic)| print(&source, diagnostic)).collect();
        let findings = findings.join("\n");
        let expected = blocks.get(index + 1).filter(|next| next.kind == "text" && next.follows);
        match expected {
            Some(expected) if std::env::var_os("UPDATE_EXPECT").is_some() => {
                updated.replace_range(expected.content.clone(), &findings);
            }
            Some(expected) => {
                assert_eq!(findings, page_text[expected.content.clone()], "\n{source}")
            }
            None => assert_eq!(findings, "", "\n{source}"),
        }
    }
    if updated != page_text {
        std::fs::write(page(name), updated).unwrap();
    }
    examples
}

#[test]
fn the_reference_names_every_method_key_and_function() {
    let page = std::fs::read_to_string(page("language.md")).unwrap();
    for method in engine::Method::ALL {
        assert!(page.contains(&format!("`{}`", method.name())), "{}", method.name());
    }
    for function in [
        "sqrt", "cbrt", "abs", "sign", "exp", "ln", "log10", "sin", "cos", "tan", "asin", "acos", "atan", "atan2",
        "sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "floor", "ceil", "round", "min", "max", "mod", "hypot",
    ] {
        assert!(page.contains(&format!("`{function}(")), "{function}");
    }
}
