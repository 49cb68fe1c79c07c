//! The structure of a text is available despite errors.

use crate::arbitrary::document_text;
use document::{BlockKind, Outline, read};
use model::{Span, StatementKind};
use proptest::prelude::*;

const WRONG: &str = "---\ntitle: A \nstep: 1 [furlong]\n---\nText.\n\n```model\nparameter a = 5 [m] in 0..9 \"A\"\nb = (a + \
                     \nparameter c = 2 [s]\n```\nMore.\n```plots\n\"P\": nothing against t\n```\n```scene\n<svg";

fn text<'a>(outline: &Outline<'a>, span: Span) -> &'a str {
    &outline.source()[span.range()]
}

#[test]
fn blocks_have_kinds_and_places() {
    let outline = read(WRONG);
    let found: Vec<_> = outline.blocks().iter().map(|block| (block.kind, text(&outline, block.content))).collect();
    assert_eq!(found[0], (BlockKind::Prose, "Text.\n\n"));
    assert_eq!(
        found[2..],
        [(BlockKind::Prose, "More.\n"), (BlockKind::Plots, "\"P\": nothing against t\n"), (BlockKind::Scene, "<svg")]
    );
    let plots = outline.blocks_of(BlockKind::Plots).next().unwrap();
    let fence = plots.fence.unwrap();
    assert_eq!(text(&outline, fence.opening), "```plots");
    assert_eq!(fence.closing.map(|line| text(&outline, line)), Some("```"));
    assert_eq!(text(&outline, plots.span), "```plots\n\"P\": nothing against t\n```\n");
    assert_eq!(outline.blocks()[4].fence.unwrap().closing, None);
    let matter = outline.front_matter();
    let entries: Vec<_> = matter
        .entries
        .iter()
        .map(|entry| (text(&outline, entry.key_span), text(&outline, entry.value.span), entry.value.text.as_str()))
        .collect();
    assert_eq!(entries, [("title", "A", "A"), ("step", "1 [furlong]", "1 [furlong]")]);
    assert_eq!(matter.closing.map(|line| text(&outline, line)), Some("---"));
}

/// Units and names are not checked, and an error in one statement does not affect the others.
#[test]
fn a_statement_with_an_error_leaves_the_others() {
    let outline = read(WRONG);
    let statements = &outline.blocks()[1].statements;
    let names: Vec<_> = statements
        .iter()
        .map(|statement| match &statement.kind {
            StatementKind::Parameter(parameter) => (parameter.name.text.as_str(), parameter.value),
            StatementKind::Definition { name, .. } => (name.text.as_str(), f64::INFINITY),
            other => panic!("{other:?}"),
        })
        .collect();
    assert_eq!(names, [("a", 5.0), ("b", f64::INFINITY), ("c", 2.0)]);
    assert_eq!(text(&outline, statements[0].span), "parameter a = 5 [m] in 0..9 \"A\"");
    let codes: Vec<_> = outline.diagnostics().iter().map(|found| found.code).collect();
    assert_eq!(codes.len(), 2, "{codes:?}");
    assert_eq!(codes[1], "fence");
    assert!(document::open(WRONG, &[]).document.is_none());
}

#[test]
fn work_is_bounded() {
    let outline_of = |text: &str| {
        let outline = read(text);
        let codes: Vec<_> = outline.diagnostics().iter().map(|found| found.code).collect();
        (outline.is_too_long(), outline.blocks().len(), codes)
    };
    assert_eq!(outline_of(&"é".repeat(600_000)), (true, 0, vec!["too-large"]));
    let model = format!("```model\n{}```\n", "a = 1\n".repeat(20_000));
    assert_eq!(outline_of(&model.repeat(2)), (false, 2, vec!["model-too-large"]));
    assert_eq!(outline_of(&"```model\n".repeat(100_000)).2.len(), 101);
    assert_eq!(outline_of(&format!("---\n{}", "step:\n".repeat(150_000))).2.len(), 101);
}

/// Properties stated in the documentation of [`Outline`].
pub fn check_places(outline: &Outline) {
    let matter = outline.front_matter();
    let source = outline.source();
    assert_eq!(source[..matter.span.start].trim_start_matches('\u{feff}'), "");
    let mut at = matter.span.end;
    for block in outline.blocks() {
        assert_eq!(block.span.start, at);
        at = block.span.end;
        assert!(block.span.start <= block.content.start && block.content.end <= block.span.end);
        assert!(source.get(block.content.range()).is_some());
        for statement in &block.statements {
            // A table begins in the opening line of its block.
            assert!(block.span.start <= statement.span.start && statement.span.end <= block.content.end);
        }
    }
    assert_eq!(at, source.len());
    for found in outline.diagnostics() {
        assert!(found.labels.iter().all(|label| source.get(label.span.range()).is_some()), "{found:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn blocks_cover_any_text(source in document_text()) {
        check_places(&read(&source));
    }
}
