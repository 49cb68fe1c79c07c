//! Front matter: lines `key: value` between `---` at the beginning of a document.

use crate::text::source::{Line, lines};
use model::{Diagnostic, Span};
use std::collections::BTreeMap;
use std::ops::Range;
use units::{nearest, words};

/// Known keys.
const KEYS: [&str; 14] = [
    "title",
    "language",
    "summary",
    "topics",
    "keywords",
    "translates",
    "method",
    "step",
    "until",
    "speed",
    "tolerance",
    "vary",
    "main",
    "assignment",
];

/// Spanish keys and other synonyms, with the keys that they mean.
const OTHER_KEYS: [(&str, &str); 25] = [
    ("titulo", "title"),
    ("nombre", "title"),
    ("idioma", "language"),
    ("lengua", "language"),
    ("lang", "language"),
    ("resumen", "summary"),
    ("description", "summary"),
    ("descripcion", "summary"),
    ("temas", "topics"),
    ("tags", "topics"),
    ("palabras", "keywords"),
    ("palabras-clave", "keywords"),
    ("palabras_clave", "keywords"),
    ("traduce", "translates"),
    ("metodo", "method"),
    ("paso", "step"),
    ("hasta", "until"),
    ("fin", "until"),
    ("end", "until"),
    ("velocidad", "speed"),
    ("tolerancia", "tolerance"),
    ("principal", "main"),
    ("principales", "main"),
    ("tarea", "assignment"),
    ("asignacion", "assignment"),
];

/// A value of the front matter and its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Value {
    /// The text, without quotation marks around it.
    pub text: String,
    /// Place including quotation marks. Empty, after the colon, if the key has no value.
    pub span: Span,
}

/// A line `key: value`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Key as written; it may be unknown or a duplicate.
    pub key: String,
    /// Place of the key.
    pub key_span: Span,
    /// The value.
    pub value: Value,
}

/// The front matter of a document.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FrontMatter {
    /// All entries, in text order.
    pub entries: Vec<Entry>,
    /// From the opening to the closing line, including line ends. Empty if there is no front matter.
    pub span: Span,
    /// The closing line, without its line end. `None` if it is missing.
    pub closing: Option<Span>,
}

impl FrontMatter {
    /// First value of `key` that is not empty.
    pub fn get(&self, key: &str) -> Option<&Value> {
        let mut values = self.entries.iter().filter(|entry| entry.key == key).map(|entry| &entry.value);
        values.find(|value| !value.text.is_empty())
    }
}

/// Reads the front matter of `source`, which may be missing.
pub(crate) fn read(source: &str, diagnostics: &mut Vec<Diagnostic>) -> FrontMatter {
    let start = source.len() - source.trim_start_matches('\u{feff}').len();
    let mut matter = FrontMatter { span: Span::new(start, start), ..FrontMatter::default() };
    let mut rest = lines(source, start..source.len());
    let Some(opening) = rest.next().filter(|line| is_mark(line.text(source))) else {
        return matter;
    };
    matter.span.end = source.len();
    let mut given = BTreeMap::new();
    for line in rest {
        let text = line.text(source);
        if is_mark(text) {
            matter.span.end = line.next;
            matter.closing = Some(Span::new(line.start, line.end));
            return matter;
        }
        if text.trim().is_empty() || text.trim_start().starts_with('#') {
            continue;
        }
        let Some(entry) = entry(source, &line) else {
            // Prose has begun: the closing line is missing, and the document starts here.
            matter.span.end = line.start;
            break;
        };
        report(&entry, &mut given, diagnostics);
        matter.entries.push(entry);
    }
    diagnostics.push(unclosed(opening.range()));
    matter
}

/// True for a line that opens or closes a front matter.
fn is_mark(line: &str) -> bool {
    line.trim_end() == "---"
}

fn unclosed(opening: Range<usize>) -> Diagnostic {
    Diagnostic::error("front-matter", words("the front matter is not closed"), Span::new(opening.start, opening.end))
        .saying(words("begins here"))
        .with_hint(words("end it with a line that holds `---` and nothing else"))
}

/// Parses one `key: value`. `None` if the line has another form.
fn entry(source: &str, line: &Line) -> Option<Entry> {
    let (before, value) = line.text(source).split_once(':')?;
    let key = before.trim();
    if !is_key(key) {
        return None;
    }
    let start = line.start + before.len() - before.trim_start().len();
    let value = trimmed(value, line.start + before.len() + 1);
    Some(Entry { key: key.to_owned(), key_span: Span::new(start, start + key.len()), value })
}

/// True if a text can be a key.
pub(crate) fn is_key(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|c| c.is_alphanumeric() || c == '-' || c == '_')
}

/// Reports errors of an entry. `given` maps the known keys of earlier entries to their places; a search through all entries
/// would take quadratic time.
fn report(entry: &Entry, given: &mut BTreeMap<&'static str, Span>, diagnostics: &mut Vec<Diagnostic>) {
    let Entry { key: name, key_span, value } = entry;
    let Some(known) = KEYS.into_iter().find(|known| known == name) else {
        let unknown = Diagnostic::warning("unknown-key", words!("the front matter has no key `{name}`"), *key_span);
        let begun = || KEYS.into_iter().find(|key| name.len() > 2 && key.starts_with(name.as_str()));
        let plain = units::alphabet::plain(name);
        let other = OTHER_KEYS.iter().find(|(other, _)| *other == plain).map(|(_, key)| *key);
        diagnostics.push(match other.or_else(|| nearest(name, KEYS)).or_else(begun) {
            Some(near) => unknown.meaning(near),
            None => unknown.with_hint(words!("the keys are {}", KEYS.join(", "))),
        });
        return;
    };
    if let Some(first) = given.get(known) {
        diagnostics.push(
            Diagnostic::error("duplicate-key", words!("`{name}` is given twice"), *key_span)
                .with_label(*first, words("given here first")),
        );
    } else if value.text.is_empty() {
        diagnostics.push(Diagnostic::error("empty-key", words!("`{name}` has no value"), *key_span));
    } else {
        given.insert(known, value.span);
    }
}

/// `text`, which begins at byte `offset`, without outer blanks and quotation marks.
pub(crate) fn trimmed(text: &str, offset: usize) -> Value {
    let start = offset + text.len() - text.trim_start().len();
    let text = text.trim();
    let span = Span::new(start, start + text.len());
    let inner = ['"', '\''].iter().find_map(|mark| text.strip_prefix(*mark)?.strip_suffix(*mark));
    Value { text: inner.unwrap_or(text).to_owned(), span }
}

/// File name of the translated document (`translates:`), if `source` is a translation.
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
                        .map(|words| words.english())
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
        assert_eq!(&source[matter.span.end..], "Prose");
    }

    #[test]
    fn without_front_matter_everything_is_prose() {
        assert_eq!(messages("Prose\n---\n").0.span.end, 0);
        assert_eq!(messages("").0.span.end, 0);
    }

    #[test]
    fn faults_are_named() {
        assert_eq!(
            messages("---\ntitel: x\nwibble: y\ntitle:\nstep: 1\nstep: 2\n---\n").1,
            [
                "the front matter has no key `titel`; did you mean `title`?",
                "the front matter has no key `wibble`; the keys are title, language, summary, topics, keywords, translates, method, \
                 step, until, speed, tolerance, vary, main, assignment",
                "`title` has no value",
                "`step` is given twice",
            ]
        );
        let (matter, messages) = messages("---\ntitle: x\n\nA liquid swings.\n");
        assert_eq!(messages, ["the front matter is not closed; end it with a line that holds `---` and nothing else"]);
        assert_eq!(matter.span.end, 14);
    }
}
