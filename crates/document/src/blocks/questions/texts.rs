//! Texts of questions, and their translations.

use super::entry::Entry;
use super::raw::{Holds, RawQuestion};
use crate::prose::Prose;
use model::{Diagnostic, Span};
use program::{OptionText, QuestionText};
use units::words;

/// Texts of a question.
pub fn texts(source: &str, prose: &mut Prose, raw: &RawQuestion) -> QuestionText {
    let mut part = |word: &str| raw.field(word).map(|range| prose.fragment(range));
    let (hint, explanation) = (part("hint"), part("explanation"));
    let entries = |word: &str| raw.entries(source, word).into_iter().map(|range| Entry::read(source, range));
    let mut inline = |entry: &Entry, index: usize| entry.inside(source, index).map(|range| prose.inline(range));
    let option = |entry: Entry| OptionText { text: inline(&entry, 0).unwrap_or_default(), remark: inline(&entry, 1) };
    let options = entries("option").map(option).collect();
    let wrong = entries("wrong").map(|entry| inline(&entry, 0).unwrap_or_default()).collect();
    QuestionText { prompt: prose.fragment(raw.prompt()), hint, explanation, options, wrong }
}

/// Warns of computed parts in a translation, which may contain texts only.
pub fn check_translation(source: &str, raw: &RawQuestion, diagnostics: &mut Vec<Diagnostic>) {
    let hint = || words("the original says it; a translation has the words only");
    for (field, range) in raw.fields() {
        let key = field.word;
        if matches!(field.holds, Holds::Expressions | Holds::Word) {
            let span = Span::new(range.start - key.len() - 1, range.end);
            let message = words!("`{key}:` in a translation means nothing");
            diagnostics.push(Diagnostic::warning("translation", message, span).with_hint(hint()));
        }
        if field.holds == Holds::Entries {
            let entries = raw.entries(source, key).into_iter().map(|range| Entry::read(source, range));
            for entry in entries.filter(|entry| entry.count() == 0 || !entry.others.is_empty()) {
                let message = words!("in a translation only texts in quotation marks stand behind `{key}:`");
                diagnostics.push(Diagnostic::warning("translation", message, entry.span).with_hint(hint()));
            }
        }
    }
}

/// Fills texts missing in the questions of a translation with the originals, and warns of them at `place`.
pub fn untranslated(texts: &mut Vec<QuestionText>, originals: &[QuestionText], place: Span) -> Option<Diagnostic> {
    texts.resize_with(originals.len(), QuestionText::default);
    let mut missing = Vec::new();
    for ((number, text), original) in (1..).zip(texts).zip(originals) {
        let is_whole = *text == QuestionText::default();
        if text.prompt.is_empty() && !original.prompt.is_empty() {
            text.prompt.clone_from(&original.prompt);
            missing.push(words!("question {number}"));
        }
        let mut lacks = Vec::new();
        let parts = [
            (&mut text.hint, &original.hint, words!("the hint of question {number}")),
            (&mut text.explanation, &original.explanation, words!("the explanation of question {number}")),
        ];
        for (part, original, name) in parts {
            lacks.extend(fill(part, original.as_ref()).then_some(name));
        }
        text.options.resize_with(original.options.len(), OptionText::default);
        let options = text.options.iter_mut().zip(&original.options).map(|(own, original)| {
            let lacks = fill(&mut own.remark, original.remark.as_ref());
            fill_text(&mut own.text, &original.text) || lacks
        });
        // Every option is filled, also after the first that lacks a text.
        let count = options.filter(|lacks| *lacks).count();
        lacks.extend((count > 0).then(|| words!("the options of question {number}")));
        text.wrong.resize_with(original.wrong.len(), String::new);
        let remarks = text.wrong.iter_mut().zip(&original.wrong);
        let count = remarks.map(|(own, original)| fill_text(own, original)).filter(|lacks| *lacks).count();
        lacks.extend((count > 0).then(|| words!("the remarks on wrong answers to question {number}")));
        if !is_whole {
            missing.append(&mut lacks);
        }
    }
    let message = match missing.as_slice() {
        [] => return None,
        [one] => words!("{one} has no translation"),
        several => {
            let number = several.len();
            words!("{number} texts of questions have no translation")
        }
    };
    let warning = Diagnostic::warning("untranslated", message, place)
        .with_hint(words("until they are translated, readers see the original"));
    Some(if missing.len() > 1 { missing.into_iter().fold(warning, Diagnostic::with_note) } else { warning })
}

/// Copies the original of a missing part. True if the part was missing; a part that the original lacks is left out.
fn fill(own: &mut Option<String>, original: Option<&String>) -> bool {
    let lacks = own.as_ref().is_none_or(String::is_empty) && original.is_some();
    if lacks || original.is_none() {
        *own = original.cloned();
    }
    lacks
}

/// Copies the original of a missing text. True if the text was missing.
fn fill_text(own: &mut String, original: &str) -> bool {
    let lacks = own.is_empty();
    if lacks {
        original.clone_into(own);
    }
    lacks
}
