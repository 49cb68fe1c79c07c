//! The lines between `---` at the beginning of a document: `key: value`.

use crate::source::{Line, lines};
use model::{Diagnostic, Span};
use std::ops::Range;
use units::{nearest, words};

/// The keys there are.
const KEYS: [&str; 8] = ["title", "language", "translates", "method", "step", "until", "tolerance", "vary"];

/// A value of the front matter and where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Value {
    /// The text, without quotation marks around it.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// What the front matter says.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FrontMatter {
    entries: Vec<(&'static str, Value)>,
    /// Where the document goes on.
    pub end: usize,
}

impl FrontMatter {
    /// The value of `key`, if it is there and not empty.
    pub fn get(&self, key: &str) -> Option<&Value> {
        self.entries.iter().find(|(name, _)| *name == key).map(|(_, value)| value)
    }
}

/// Reads the front matter of `source`; a document may have none.
pub fn read(source: &str, diagnostics: &mut Vec<Diagnostic>) -> FrontMatter {
    let start = source.len() - source.trim_start_matches('\u{feff}').len();
    let mut matter = FrontMatter { entries: Vec::new(), end: start };
    let mut rest = lines(source, start..source.len());
    let Some(opening) = rest.next().filter(|line| line.text(source).trim_end() == "---") else {
        return matter;
    };
    for line in rest {
        let text = line.text(source);
        if text.trim_end() == "---" {
            matter.end = line.next;
            return matter;
        }
        if text.trim().is_empty() || text.trim_start().starts_with('#') {
            continue;
        }
        if !matter.entry(source, &line, diagnostics) {
            // Prose has begun: the closing line is missing, and everything from here on is the document.
            matter.end = line.start;
            diagnostics.push(unclosed(opening.range()));
            return matter;
        }
    }
    matter.end = source.len();
    diagnostics.push(unclosed(opening.range()));
    matter
}

fn unclosed(opening: Range<usize>) -> Diagnostic {
    Diagnostic::error(
        "front-matter",
        words("the front matter is not closed", "la cabecera no se cierra"),
        Span::new(opening.start, opening.end),
    )
    .saying(words("begins here", "empieza aquí"))
    .with_hint(words(
        "end it with a line that holds `---` and nothing else",
        "termínala con una línea que contenga solo `---`",
    ))
}

impl FrontMatter {
    /// Reads one `key: value`. False if the line is nothing of the kind.
    fn entry(&mut self, source: &str, line: &Line, diagnostics: &mut Vec<Diagnostic>) -> bool {
        let text = line.text(source);
        let Some((key, value)) = text.split_once(':') else {
            return false;
        };
        let name = key.trim();
        if name.is_empty() || !name.chars().all(|c| c.is_alphanumeric() || c == '-' || c == '_') {
            return false;
        }
        let key_start = line.start + key.len() - key.trim_start().len();
        let key_span = Span::new(key_start, key_start + name.len());
        let value = trimmed(value, line.start + key.len() + 1);
        let Some(known) = KEYS.iter().find(|known| **known == name) else {
            let mut unknown = Diagnostic::warning(
                "unknown-key",
                words!("the front matter has no key `{name}`", "la cabecera no tiene ninguna clave `{name}`"),
                key_span,
            );
            unknown = match nearest(name, KEYS) {
                Some(near) => unknown.with_hint(words!("did you mean `{near}`?", "¿querías decir `{near}`?")),
                None => unknown.with_hint(words!("the keys are {}", "las claves son {}", KEYS.join(", "))),
            };
            diagnostics.push(unknown);
            return true;
        };
        if let Some(first) = self.get(name) {
            diagnostics.push(
                Diagnostic::error(
                    "duplicate-key",
                    words!("`{name}` is given twice", "`{name}` se da dos veces"),
                    key_span,
                )
                .with_label(first.span, words("given here first", "se da aquí primero")),
            );
        } else if value.text.is_empty() {
            diagnostics.push(Diagnostic::error(
                "empty-key",
                words!("`{name}` has no value", "`{name}` no tiene valor"),
                key_span,
            ));
        } else {
            self.entries.push((known, value));
        }
        true
    }
}

/// `text`, which begins at `offset`, without blanks and without quotation marks around it.
fn trimmed(text: &str, offset: usize) -> Value {
    let start = offset + text.len() - text.trim_start().len();
    let text = text.trim();
    let span = Span::new(start, start + text.len());
    let inner = ['"', '\''].iter().find_map(|mark| text.strip_prefix(*mark)?.strip_suffix(*mark));
    Value { text: inner.unwrap_or(text).to_owned(), span }
}

/// The file name of the base document, where `source` is a translation: what its `translates:` says.
pub fn translates(source: &str) -> Option<String> {
    read(source, &mut Vec::new()).get("translates").map(|value| value.text.clone())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn messages(source: &str) -> (FrontMatter, Vec<String>) {
        let mut diagnostics = Vec::new();
        let matter = read(source, &mut diagnostics);
        (
            matter,
            diagnostics
                .iter()
                .map(|d| {
                    [std::slice::from_ref(&d.message), &d.hints]
                        .concat()
                        .iter()
                        .map(|words| &*words.english)
                        .collect::<Vec<_>>()
                        .join("; ")
                })
                .collect(),
        )
    }

    #[test]
    fn values_have_places_and_lose_their_quotes() {
        let source = "---\ntitle: \"A: B\"\r\nstep:  0.05 [s] \n---\nProse";
        let (matter, messages) = messages(source);
        assert_eq!(messages, [""; 0]);
        assert_eq!(matter.get("title").unwrap().text, "A: B");
        let step = matter.get("step").unwrap();
        assert_eq!(&source[step.span.range()], "0.05 [s]");
        assert_eq!(&source[matter.end..], "Prose");
    }

    #[test]
    fn without_front_matter_everything_is_prose() {
        assert_eq!(messages("Prose\n---\n").0.end, 0);
        assert_eq!(messages("").0.end, 0);
    }

    #[test]
    fn faults_are_named() {
        assert_eq!(
            messages("---\ntitel: x\nwibble: y\ntitle:\nstep: 1\nstep: 2\n---\n").1,
            [
                "the front matter has no key `titel`; did you mean `title`?",
                "the front matter has no key `wibble`; the keys are title, language, translates, method, step, until, \
                 tolerance, vary",
                "`title` has no value",
                "`step` is given twice",
            ]
        );
        let (matter, messages) = messages("---\ntitle: x\n\nA liquid swings.\n");
        assert_eq!(messages, ["the front matter is not closed; end it with a line that holds `---` and nothing else"]);
        assert_eq!(matter.end, 14);
    }
}
