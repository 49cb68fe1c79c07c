//! `meniscus guide`: short enough, and each of its lines of the language is right.

mod forms;

use crate::common::meniscus;
use std::fs;

/// Largest size of the guide in bytes: 6,000 tokens of the tokenizer o200k_base, which takes 3.2 bytes of this text a token.
const LARGEST: usize = 19_400;

/// The guide as the program prints it.
fn guide() -> String {
    let done = meniscus(&["guide"]);
    assert_eq!((done.code, done.stderr.as_str()), (0, ""));
    done.stdout
}

/// The blocks of the guide: the word behind the backquotes, and the content.
fn blocks(guide: &str) -> Vec<(String, String)> {
    let mut blocks = Vec::new();
    let mut lines = guide.lines();
    while let Some(line) = lines.next() {
        let word = line.trim_start_matches('`');
        let marks = &line[..line.len() - word.len()];
        if marks.len() >= 3 {
            let content: String =
                lines.by_ref().take_while(|line| *line != marks).map(|line| format!("{line}\n")).collect();
            blocks.push((word.to_owned(), content));
        }
    }
    blocks
}

#[test]
fn it_is_short_and_whole() {
    let guide = guide();
    assert!(guide.len() <= LARGEST, "{} bytes; mark less in docs/language.md", guide.len());
    assert!(guide.len() > LARGEST / 2, "{} bytes", guide.len());
    for section in
        ["# The document and its language", "## The model", "### Units", "## The scene", "## Plots", "## Checks"]
    {
        assert!(guide.contains(&format!("\n{section}")) || guide.starts_with(section), "{section}");
    }
    assert!(!guide.contains("<!--"), "a mark is left");
    // Nothing announces what is not there, and no link leads out of the guide.
    for (line, next) in guide.lines().zip(guide.lines().skip(1)) {
        assert!(!(line.ends_with(':') && next.is_empty() && !follows(&guide, line)), "{line}");
    }
    for link in guide.split("](#").skip(1) {
        let anchor = link.split(')').next().unwrap();
        let heading = |line: &str| line.trim_start_matches('#').trim().to_lowercase().replace(' ', "-");
        let is_example = anchor == "activities";
        assert!(is_example || guide.lines().any(|line| line.starts_with('#') && heading(line) == anchor), "{anchor}");
    }
}

/// True if a table, a list or a block stands behind the paragraph that ends with this line.
fn follows(guide: &str, line: &str) -> bool {
    let rest = &guide[guide.find(line).unwrap() + line.len()..];
    rest.trim_start().starts_with(['|', '-', '`'])
}

/// Each document and model of the guide runs, and its claims hold.
#[test]
fn every_block_runs() {
    let blocks = blocks(&guide());
    assert!(blocks.len() >= 6, "{}", blocks.len());
    let directory = tempfile::tempdir().unwrap();
    for (number, (word, content)) in blocks.iter().enumerate() {
        let text = match word.as_str() {
            "markdown" => content.clone(),
            "model" => format!("---\ntitle: Example\nuntil: 3\n---\n\n```model\n{content}```\n"),
            other => panic!("{other}: no test for such a block"),
        };
        let path = directory.path().join(format!("{number}.md"));
        fs::write(&path, text).unwrap();
        let path = path.to_str().unwrap();
        let checked = meniscus(&["check", "--run", "--format", "json", path]);
        assert_eq!((checked.code, checked.stdout.trim()), (0, "[]"), "{content}");
        let run = meniscus(&["run", path]);
        let ends = run.stderr.is_empty() || run.stderr.starts_with("the run ends at");
        assert!(run.code == 0 && ends, "{content}{}", run.stderr);
        assert!(run.stdout.lines().count() > 2, "{content}");
    }
}

/// The first document of the guide has each of the blocks that authors use most.
#[test]
fn its_document_is_complete() {
    let (_, document) = blocks(&guide()).swap_remove(0);
    let opened = document::open(&document, &[]);
    let program = opened.document.unwrap().program;
    assert!(program.scene("en").is_some() && !program.questions.is_empty() && !program.presets.is_empty());
    assert!(program.plots.len() > 1 && program.checks.iter().map(|check| check.claims.len()).sum::<usize>() >= 4);
}
