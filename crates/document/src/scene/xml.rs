//! XML to a tree of byte ranges. Supports only what drawings need: elements, quoted attributes, text, comments. Braces
//! enclose expressions, in which `<` and quotation marks are ordinary characters.

use model::{Diagnostic, Span};
use std::ops::Range;
use units::{Words, words};

/// Maximum nesting depth of elements.
const DEPTH: usize = 32;
/// Maximum number of elements.
const ELEMENTS: usize = 3_000;

/// An element as written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RawElement {
    /// Its name in the opening tag.
    pub name: Range<usize>,
    /// Opening tag.
    pub opening: Range<usize>,
    /// Byte after its closing tag.
    pub end: usize,
    /// Names and values (inside the quotation marks) of its attributes.
    pub attributes: Vec<(Range<usize>, Range<usize>)>,
    /// Content.
    pub children: Vec<RawChild>,
}

/// A child of an element.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RawChild {
    /// An element.
    Element(RawElement),
    /// A text, not decoded.
    Text(Range<usize>),
}

/// Parses the elements in `range` of `source`.
pub fn parse(source: &str, range: Range<usize>, diagnostics: &mut Vec<Diagnostic>) -> Vec<RawChild> {
    let mut reader = Reader { source, at: range.start, end: range.end, elements: 0, diagnostics };
    // The first entry is the document; the others are the open elements.
    let before = range.start..range.start;
    let mut open = vec![RawElement {
        name: before.clone(),
        opening: before,
        end: range.end,
        attributes: Vec::new(),
        children: Vec::new(),
    }];
    while reader.at < reader.end {
        if !reader.rest().starts_with('<') {
            let text = reader.text();
            push(&mut open, RawChild::Text(text));
        } else if reader.rest().starts_with("</") {
            reader.closing_tag(&mut open);
        } else if !reader.skip_unreadable() {
            reader.opening_tag(&mut open);
        }
    }
    while open.len() > 1 {
        if let Some(element) = open.last() {
            reader.unclosed(element.name.clone(), range.end);
        }
        close(&mut open, range.end);
    }
    open.pop().map(|document| document.children).unwrap_or_default()
}

fn push(open: &mut [RawElement], child: RawChild) {
    if let Some(element) = open.last_mut() {
        element.children.push(child);
    }
}

fn close(open: &mut Vec<RawElement>, end: usize) {
    if let Some(element) = open.pop() {
        push(open, RawChild::Element(RawElement { end, ..element }));
    }
}

struct Reader<'a> {
    source: &'a str,
    at: usize,
    end: usize,
    elements: usize,
    diagnostics: &'a mut Vec<Diagnostic>,
}

impl Reader<'_> {
    fn rest(&self) -> &str {
        &self.source[self.at..self.end]
    }

    fn error(&mut self, message: Words, range: Range<usize>) {
        self.diagnostics.push(Diagnostic::error("scene-syntax", message, Span::new(range.start, range.end)));
    }

    /// Reports an element that ends at byte `end` without a closing tag.
    fn unclosed(&mut self, name: Range<usize>, end: usize) {
        let text = &self.source[name.clone()];
        let message = words!("`<{text}>` is not closed");
        let span = Span::new(name.start, name.end);
        let diagnostic = Diagnostic::error("scene-syntax", message, span);
        self.diagnostics.push(diagnostic.with_fix(Span::new(end, end), format!("</{text}>")));
    }

    /// Consumes text up to the next tag.
    fn text(&mut self) -> Range<usize> {
        let start = self.at;
        while let Some(letter) = self.rest().chars().next().filter(|letter| *letter != '<') {
            self.at += placeholder(self.rest()).unwrap_or(letter.len_utf8());
        }
        start..self.at
    }

    /// Skips comments, declarations, processing instructions and stray `<`. Returns true if there was one.
    fn skip_unreadable(&mut self) -> bool {
        let (start, rest) = (self.at, self.rest());
        let (length, message) = if let Some(comment) = rest.strip_prefix("<!--") {
            match comment.find("-->") {
                Some(length) => (length + 7, None),
                None => (rest.len(), Some(words("the comment is not closed"))),
            }
        } else if rest.starts_with("<!") || rest.starts_with("<?") {
            let length = rest.find('>').map_or(rest.len(), |end| end + 1);
            (length, Some(words("a scene holds elements and text only; this is left out")))
        } else if !rest[1..].starts_with(|c: char| c.is_ascii_alphabetic()) {
            (1, Some(words("this `<` begins no element; in text write `&lt;`")))
        } else {
            return false;
        };
        self.at += length;
        if let Some(message) = message {
            self.error(message, start..start + self.char_floor(start, length));
        }
        true
    }

    /// Greatest length up to `length` and 40 bytes from `start` that ends on a character boundary.
    fn char_floor(&self, start: usize, length: usize) -> usize {
        self.source.floor_char_boundary(start + length.min(40)).saturating_sub(start)
    }

    fn closing_tag(&mut self, open: &mut Vec<RawElement>) {
        let start = self.at;
        self.at += 2;
        let name = self.name();
        let length = self.rest().find('>').map_or(self.rest().len(), |end| end + 1);
        self.at += length;
        let text = &self.source[name.clone()];
        let Some(depth) = open.iter().skip(1).rposition(|element| &self.source[element.name.clone()] == text) else {
            let message = words!("`</{text}>` closes nothing");
            self.error(message, start..name.end);
            return;
        };
        while open.len() > depth + 2 {
            if let Some(inner) = open.last() {
                self.unclosed(inner.name.clone(), start);
            }
            close(open, start);
        }
        close(open, self.at);
    }

    fn opening_tag(&mut self, open: &mut Vec<RawElement>) {
        let start = self.at;
        self.at += 1;
        let name = self.name();
        let (attributes, children) = (Vec::new(), Vec::new());
        let mut element = RawElement { name: name.clone(), opening: start..start, end: start, attributes, children };
        let closed = loop {
            self.skip_blanks();
            match self.rest().chars().next() {
                Some('>') => {
                    self.at += 1;
                    break false;
                }
                Some('/') if self.rest().starts_with("/>") => {
                    self.at += 2;
                    break true;
                }
                None | Some('<') => {
                    let message = words!("the tag `<{}` is not closed with `>`", &self.source[name.clone()]);
                    self.error(message, name.clone());
                    break false;
                }
                Some(_) => element.attributes.extend(self.attribute()),
            }
        };
        (element.opening.end, element.end) = (self.at, self.at);
        self.elements += 1;
        if self.elements == ELEMENTS + 1 {
            self.error(words!("a scene cannot have more than {ELEMENTS} elements"), name.clone());
        }
        let fits = self.elements <= ELEMENTS;
        if closed {
            if fits {
                push(open, RawChild::Element(element));
            }
        } else if open.len() > DEPTH {
            // Its content is added to the enclosing element; its closing tag will be reported.
            self.error(words!("elements cannot be nested deeper than {DEPTH} levels"), name);
        } else {
            open.push(element);
        }
    }

    /// Parses one attribute; other text is skipped and reported.
    fn attribute(&mut self) -> Option<(Range<usize>, Range<usize>)> {
        let name = self.name();
        if name.is_empty() {
            let start = self.at;
            self.at += self.rest().chars().next().map_or(1, char::len_utf8);
            self.error(words("an attribute was expected here: `name=\"value\"`"), start..self.at);
            return None;
        }
        self.skip_blanks();
        if !self.rest().starts_with('=') {
            let message = words!("the attribute `{0}` has no value; write `{0}=\"...\"`", &self.source[name.clone()]);
            self.error(message, name);
            return None;
        }
        self.at += 1;
        self.skip_blanks();
        let Some(quote) = self.rest().chars().next().filter(|quote| matches!(quote, '"' | '\'')) else {
            let message = words!("the value of `{}` must stand in quotation marks", &self.source[name.clone()]);
            self.error(message, name);
            self.at +=
                self.rest().find(|c: char| c.is_whitespace() || matches!(c, '>' | '/')).unwrap_or(self.rest().len());
            return None;
        };
        self.at += 1;
        let start = self.at;
        while let Some(letter) = self.rest().chars().next().filter(|letter| *letter != quote) {
            self.at += placeholder(self.rest()).unwrap_or(letter.len_utf8());
        }
        let value = start..self.at;
        if self.at == self.end {
            // The closing quotation mark is missing: continue on the next line, to keep the rest of the scene.
            self.at = start + self.source[start..self.end].find('\n').unwrap_or(self.end - start);
            let message = words!("the value of `{}` has no closing quotation mark", &self.source[name.clone()]);
            self.error(message, name);
            return None;
        }
        self.at += 1;
        Some((name, value))
    }

    fn name(&mut self) -> Range<usize> {
        let start = self.at;
        let is_part = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | ':' | '.');
        self.at += self.rest().find(|c| !is_part(c)).unwrap_or(self.rest().len());
        start..self.at
    }

    fn skip_blanks(&mut self) {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start().len();
    }
}

/// Length in bytes of the `{expression}` or doubled brace at the start of `text`.
pub fn placeholder(text: &str) -> Option<usize> {
    if text.starts_with("{{") || text.starts_with("}}") {
        return Some(2);
    }
    let inner = text.strip_prefix('{')?;
    let end = inner.find(['}', '{', '\n'])?;
    inner[end..].starts_with('}').then_some(end + 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn print(source: &str, children: &[RawChild]) -> String {
        children
            .iter()
            .map(|child| match child {
                RawChild::Text(range) => format!("{:?}", &source[range.clone()]),
                RawChild::Element(element) => {
                    let attributes: String = (element.attributes.iter())
                        .map(|(name, value)| format!(" {}={:?}", &source[name.clone()], &source[value.clone()]))
                        .collect();
                    format!("<{}{attributes}>[{}]", &source[element.name.clone()], print(source, &element.children))
                }
            })
            .collect()
    }

    fn check(source: &str, expected: &str, messages: &[&str]) {
        let mut diagnostics = Vec::new();
        let children = parse(source, 0..source.len(), &mut diagnostics);
        assert_eq!(print(source, &children), expected);
        assert_eq!(diagnostics.iter().map(|d| d.message.english()).collect::<Vec<_>>(), messages);
    }

    #[test]
    fn elements_attributes_and_text() {
        check("<svg a='1' b = \"2\"><!-- <x> --><g/>t &lt; u</svg>", "<svg a=\"1\" b=\"2\">[<g>[]\"t &lt; u\"]", &[]);
        check(
            "<text x=\"{if a < b then \"c\" else 'd'}\">{a<b}{{<g/></text>",
            "<text x=\"{if a < b then \\\"c\\\" else 'd'}\">[\"{a<b}{{\"<g>[]]",
            &[],
        );
    }

    #[test]
    fn faults_do_not_stop_the_reading() {
        check("<svg><g><rect/></svg>", "<svg>[<g>[<rect>[]]]", &["`<g>` is not closed"]);
        check("<svg></g></svg>", "<svg>[]", &["`</g>` closes nothing"]);
        check("<svg", "<svg>[]", &["the tag `<svg` is not closed with `>`", "`<svg>` is not closed"]);
        check(
            "<g a=1 b c=\"2\"/>",
            "<g c=\"2\">[]",
            &["the value of `a` must stand in quotation marks", "the attribute `b` has no value; write `b=\"...\"`"],
        );
        check(
            "<g a=\"1/>\n<rect/>",
            "<g>[<rect>[]]",
            &[
                "the value of `a` has no closing quotation mark",
                "the tag `<g` is not closed with `>`",
                "`<g>` is not closed",
            ],
        );
        check("<?xml?><!DOCTYPE svg><svg/>", "<svg>[]", &["a scene holds elements and text only; this is left out"; 2]);
        check("1 < 2", "\"1 \"\" 2\"", &["this `<` begins no element; in text write `&lt;`"]);
    }

    #[test]
    fn depth_and_number_are_bounded() {
        let mut diagnostics = Vec::new();
        let deep = "<g>".repeat(10_000);
        parse(&deep, 0..deep.len(), &mut diagnostics);
        assert_eq!(diagnostics[0].message.english(), "elements cannot be nested deeper than 32 levels");
        diagnostics.clear();
        let many = "<g/>".repeat(ELEMENTS + 5);
        assert_eq!(parse(&many, 0..many.len(), &mut diagnostics).len(), ELEMENTS);
        assert_eq!(diagnostics.len(), 1);
    }
}
