//! Any text as a document with a translation (after a line of `=====`), in a laboratory and inside a page.

#![no_main]

use document::Document;
use document::edit::{apply, replace_block};
use document::page::{MARKER, Options, Source, embed, read};
use libfuzzer_sys::fuzz_target;
use play::Play;
use program::Block;

fuzz_target!(|text: &str| {
    let mut parts = text.split("\n=====\n");
    let base = parts.next().unwrap_or_default();
    let translations: Vec<&str> = parts.take(2).collect();
    has_a_structure(base);
    let opened = document::open(base, &translations);
    for (file, diagnostic) in &opened.diagnostics {
        let source = if *file == 0 { base } else { translations[*file - 1] };
        for label in &diagnostic.labels {
            assert!(source.get(label.span.range()).is_some(), "{diagnostic:?}");
        }
    }
    travels_in_a_page(text);
    if let Some(document) = opened.document {
        carries_no_script(&document);
        is_worked_with(document);
    }
});

/// The blocks cover the text, and an edit leaves their number as it is.
fn has_a_structure(text: &str) {
    let outline = document::read(text);
    let mut at = outline.front_matter().span.end;
    for (index, block) in outline.blocks().iter().enumerate() {
        assert_eq!(block.span.start, at);
        at = block.span.end;
        if let Ok(edit) = replace_block(&outline, index, "x = 1") {
            let Ok(edited) = apply(text, &[edit]) else { panic!("the block lies in the text") };
            assert_eq!(document::read(&edited).blocks().len(), outline.blocks().len());
        }
    }
    assert_eq!(at, outline.source().len());
}

/// What goes into a page comes out again, and cannot end its element.
fn travels_in_a_page(text: &str) {
    let sources = vec![Source { name: "a.md".to_owned(), text: text.to_owned() }];
    let template = format!("<!doctype html><title>x</title><body>{MARKER}</body>");
    let Some(page) = embed(&template, &sources, &Options::default()) else { panic!("the template has a place") };
    assert_eq!(page.matches("</script").count(), 1);
    assert_eq!(read(&page), Some(sources));
}

/// Raw HTML of the author is shown as text, so that no such element is ever made.
fn carries_no_script(document: &Document) {
    for section in document.program.editions.iter().flat_map(|edition| &edition.sections) {
        for block in &section.blocks {
            if let Block::Html(html) = block {
                let html = html.to_lowercase();
                for forbidden in ["<script", "<iframe", "<object", "<style", "<form", "href=\"javascript:"] {
                    assert!(!html.contains(forbidden), "{html}");
                }
            }
        }
    }
}

/// A short lesson: play, change, step back, share, export.
fn is_worked_with(document: Document) {
    let mut play = Play::open(document.program);
    play.change_run(|line, _| line.play());
    for _ in 0..4 {
        play.change_run(|line, _| line.tick(0.1));
    }
    play.change_run(|line, _| line.pause());
    play.change_run(|line, _| line.step_back());
    let shared = play.share();
    let _ = play.restore(&shared);
    play.change_run(|line, basis| line.back_to_start(basis));
}
