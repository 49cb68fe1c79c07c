//! Documents with beginners' mistakes: each message gives the place and the reason, and its fix makes the document run.
//!
//! The cases are in `beginners.txt`, as changes of the template *A mass on a spring*: a title, lines `- ` from the
//! template, and lines `+ ` as a beginner writes them instead. Below each case are the first message with its place and
//! fix, and the lines that differ after all fixes. `UPDATE_EXPECTED=1 cargo test -p document --test all beginners` writes
//! these, for review before a commit.

use document::edit::apply;
use document::{TEMPLATES, open};
use model::{Diagnostic, Severity};
use std::fmt::Write;
use std::path::Path;
use units::Language;

/// Maximum number of fixes applied one after the other.
const MOST_REMEDIES: usize = 6;

struct Case<'a> {
    title: &'a str,
    before: String,
    after: String,
}

fn cases(text: &str) -> Vec<Case<'_>> {
    let parts = text.split("\n## ").skip(1);
    let marked = |part: &str, mark: &str| -> String {
        part.lines().filter_map(|line| line.strip_prefix(mark)).map(|line| format!("{line}\n")).collect()
    };
    parts
        .map(|part| Case { title: part.lines().next().unwrap(), before: marked(part, "- "), after: marked(part, "+ ") })
        .collect()
}

/// Diagnostics of a text, errors first.
fn findings(text: &str) -> Vec<Diagnostic> {
    let mut found: Vec<Diagnostic> = open(text, &[]).diagnostics.into_iter().map(|(_, found)| found).collect();
    found.sort_by_key(|found| found.severity != Severity::Error);
    found
}

/// The first error as shown to a beginner: place, reason and titles of the fixes.
fn message(text: &str, found: &Diagnostic) -> String {
    let span = found.span();
    let (line, start) =
        (1 + text[..span.start].matches('\n').count(), text[..span.start].rfind('\n').map_or(0, |at| at + 1));
    let column = 1 + text[start..span.start].chars().count();
    let place = text[span.range()].lines().next().unwrap_or_default();
    let mut message = format!("{line}:{column} `{place}`: {}\n", found.message.english());
    for words in found.notes.iter().chain(&found.hints) {
        for line in words.english().lines() {
            writeln!(message, "    {line}").unwrap();
        }
    }
    for fix in &found.fixes {
        writeln!(message, "    [{}]", fix.title(text).english()).unwrap();
    }
    message
}

/// Lines that occur in only one of the texts, with `- ` and `+ `.
fn changed(before: &str, after: &str) -> String {
    let (before, after): (Vec<&str>, Vec<&str>) = (before.lines().collect(), after.lines().collect());
    let same = |a: &mut dyn Iterator<Item = (&str, &str)>| a.take_while(|(a, b)| a == b).count();
    let start = same(&mut before.iter().copied().zip(after.iter().copied()));
    let least = before.len().min(after.len()) - start;
    let end = same(&mut before.iter().rev().copied().zip(after.iter().rev().copied())).min(least);
    after[start..after.len() - end].iter().map(|line| format!("    > {line}\n")).collect()
}

#[test]
fn faults_of_beginners_have_remedies_that_work() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/all/beginners.txt");
    let text = std::fs::read_to_string(&file).unwrap();
    let template = TEMPLATES.iter().find(|template| template.name == "oscillator").unwrap().text(Language::English);
    let mut said = text.split("\n## ").next().unwrap().trim_end().to_owned() + "\n";
    let mut problems = Vec::new();
    for case in cases(&text) {
        let Case { title, before, after } = &case;
        assert_eq!(template.matches(before.as_str()).count(), 1, "{title}: the template has these lines once");
        let wrong = template.replacen(before, after, 1);
        let mut mended = wrong.clone();
        let mut found = findings(&mended);
        let first = found.first().map(|found| message(&mended, found)).unwrap_or_default();
        let mut presses = 0;
        while let Some(fix) = found.first().and_then(|found| found.fixes.first()).filter(|_| presses < MOST_REMEDIES) {
            mended = apply(&mended, &fix.edits).unwrap();
            presses += 1;
            found = findings(&mended);
        }
        if presses == 0 {
            problems.push(format!("{title}: no error with a remedy"));
        }
        problems.extend(found.first().map(|left| format!("{title}: left is {}", message(&mended, left))));
        let mark = |lines: &str, mark: &str| lines.lines().map(|line| format!("{mark} {line}\n")).collect::<String>();
        let (minus, plus) = (mark(before, "-"), mark(after, "+"));
        writeln!(said, "\n## {title}\n{minus}{plus}{first}{}", changed(&wrong, &mended).trim_end()).unwrap();
    }
    if std::env::var_os("UPDATE_EXPECTED").is_some() {
        std::fs::write(&file, &said).unwrap();
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    let differing = said.lines().zip(text.lines()).find(|(said, text)| said != text);
    assert!(said == text, "{differing:?}");
}
