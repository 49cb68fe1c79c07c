//! Translations of short texts: lines `"Damping" = "Amortiguamiento"`.

use crate::scene::normalised;
use model::{Diagnostic, Sentence, Span, inside};
use std::collections::{BTreeMap, BTreeSet};
use units::{nearest, words};

/// Texts and their translations.
#[derive(Debug, Default)]
pub struct Texts {
    entries: BTreeMap<String, Entry>,
    known: BTreeSet<String>,
    missing: BTreeSet<String>,
    diagnostics: Vec<Diagnostic>,
}

#[derive(Debug)]
struct Entry {
    text: String,
    span: Span,
}

impl Texts {
    /// Reads translations.
    pub fn read(&mut self, source: &str, sentences: &[Sentence]) {
        for sentence in sentences {
            let span = sentence.span;
            let Some((original, text)) = entry(source, sentence) else {
                self.diagnostics.push(
                    Diagnostic::error("translation", words("a translation is a text, `=` and a text"), span)
                        .with_hint(words("write `\"Damping\" = \"Amortiguamiento\"`")),
                );
                continue;
            };
            let original = normalised(original);
            if let Some(first) = self.entries.get(&original) {
                let message = words!("\"{original}\" is translated twice");
                self.diagnostics
                    .push(Diagnostic::error("translation", message, span).with_label(first.span, words("here first")));
                continue;
            }
            self.entries.insert(original, Entry { text: inside(source, text).to_owned(), span });
        }
    }

    /// Translation of a text of the document, with its place. A missing one is recorded if `needed`.
    pub fn translate(&mut self, original: &str, needed: bool) -> Option<(String, Span)> {
        let key = normalised(original);
        let found = self.entries.get(&key).map(|entry| (entry.text.clone(), entry.span));
        if found.is_none() && needed {
            self.missing.insert(key.clone());
        }
        self.known.insert(key);
        found
    }

    /// Adds a diagnostic about a translation.
    pub fn refuse(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    /// Returns the diagnostics, including missing translations (reported at `place`) and translations of unknown texts.
    pub fn finish(mut self, place: Span) -> Vec<Diagnostic> {
        for (original, entry) in &self.entries {
            if self.known.contains(original) {
                continue;
            }
            let message = words!("the document has no text \"{original}\"");
            let mut diagnostic = Diagnostic::warning("translation", message, entry.span);
            let near = nearest(original, self.missing.iter().map(String::as_str));
            diagnostic.hints.extend(near.map(|near| words!("did you mean \"{near}\"?")));
            self.diagnostics.push(diagnostic);
        }
        if !self.missing.is_empty() {
            let message = match self.missing.len() {
                1 => words("a text has no translation"),
                number => words!("{number} texts have no translation"),
            };
            let mut diagnostic = Diagnostic::warning("untranslated", message, place);
            for text in self.missing.iter().take(20) {
                diagnostic = diagnostic.with_note(words!("\"{text}\""));
            }
            self.diagnostics
                .push(diagnostic.with_hint(words("add them to a `translations` block: `\"Damping\" = \"...\"`")));
        }
        self.diagnostics
    }
}

/// Splits `"original" = "translation"` into the original and the place of the translation, with its quotation marks.
pub fn entry<'a>(source: &'a str, sentence: &Sentence) -> Option<(&'a str, Span)> {
    let original = sentence.title_text(source)?;
    let mut phrases = sentence.phrases();
    let assigned = phrases.next().filter(|_| sentence.colon.is_none() && phrases.next().is_none())?;
    let text = assigned.label().filter(|_| &source[assigned.operand.span.range()] == "=")?;
    Some((original, text))
}
