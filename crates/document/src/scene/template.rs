//! Texts with `{expressions}`.

use super::xml::placeholder;
use model::{Diagnostic, Span};
use std::ops::Range;
use units::words;

/// A piece of a text before compilation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RawPiece {
    /// A decoded text.
    Literal(String),
    /// `{expression:.2}`.
    Placeholder {
        /// Byte range of the expression.
        expression: Range<usize>,
        /// Number of decimals; `None` if not stated.
        decimals: Option<u8>,
    },
}

/// Splits the text in `range` of `source` into pieces.
pub fn split(source: &str, range: Range<usize>, diagnostics: &mut Vec<Diagnostic>) -> Vec<RawPiece> {
    let mut pieces = Vec::new();
    let mut literal = String::new();
    let mut at = range.start;
    while let Some(letter) = source[at..range.end].chars().next() {
        let rest = &source[at..range.end];
        let length = match letter {
            '{' | '}' => match placeholder(rest) {
                Some(2) if rest.starts_with("{{") || rest.starts_with("}}") => {
                    literal.push(letter);
                    2
                }
                Some(length) => {
                    if !literal.is_empty() {
                        pieces.push(RawPiece::Literal(std::mem::take(&mut literal)));
                    }
                    pieces.push(read_placeholder(source, at + 1..at + length - 1));
                    length
                }
                None => {
                    diagnostics.push(
                        Diagnostic::error(
                            "scene-brace",
                            words!("this `{letter}` has no partner on its line"),
                            Span::new(at, at + 1),
                        )
                        .with_hint(words!(
                            "an expression stands in `{{...}}`; for the character itself write `{letter}{letter}`"
                        )),
                    );
                    literal.push(letter);
                    1
                }
            },
            '&' => read_entity(rest, Span::new(at, at + 1), &mut literal, diagnostics),
            _ => {
                literal.push(letter);
                letter.len_utf8()
            }
        };
        at += length;
    }
    if !literal.is_empty() {
        pieces.push(RawPiece::Literal(literal));
    }
    pieces
}

/// Parses `t:.2`, a placeholder without its braces.
fn read_placeholder(source: &str, range: Range<usize>) -> RawPiece {
    let text = &source[range.clone()];
    let format = text.rsplit_once(":.").and_then(|(expression, digits)| {
        let decimals: u8 = digits.trim().parse().ok().filter(|decimals| *decimals <= 12)?;
        Some((range.start..range.start + expression.len(), decimals))
    });
    match format {
        Some((expression, decimals)) => RawPiece::Placeholder { expression, decimals: Some(decimals) },
        None => RawPiece::Placeholder { expression: range, decimals: None },
    }
}

/// Decodes `&lt;`, `&#916;` and similar entities. Returns the number of bytes consumed.
fn read_entity(text: &str, place: Span, literal: &mut String, diagnostics: &mut Vec<Diagnostic>) -> usize {
    let name = text[1..].find(';').filter(|end| *end <= 8).map(|end| &text[1..1 + end]);
    let decoded = name.and_then(|name| match name {
        "lt" => Some('<'),
        "gt" => Some('>'),
        "amp" => Some('&'),
        "quot" => Some('"'),
        "apos" => Some('\''),
        "nbsp" => Some('\u{a0}'),
        _ => {
            let number = name.strip_prefix('#')?;
            let code = match number.strip_prefix(['x', 'X']) {
                Some(hexadecimal) => u32::from_str_radix(hexadecimal, 16).ok()?,
                None => number.parse().ok()?,
            };
            char::from_u32(code).filter(|c| !c.is_control())
        }
    });
    match (name, decoded) {
        (Some(name), Some(letter)) => {
            literal.push(letter);
            name.len() + 2
        }
        _ => {
            diagnostics.push(
                Diagnostic::error("scene-syntax", words("this `&` begins no character"), place)
                    .with_hint(words("for the character itself write `&amp;`")),
            );
            literal.push('&');
            1
        }
    }
}

/// Text with runs of blanks replaced by one blank, as browsers show it. Key of a text in translations.
pub fn normalised(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(text: &str, expected: &[&str], messages: &[&str]) {
        let mut diagnostics = Vec::new();
        let pieces: Vec<String> = split(text, 0..text.len(), &mut diagnostics)
            .into_iter()
            .map(|piece| match piece {
                RawPiece::Literal(text) => format!("{text:?}"),
                RawPiece::Placeholder { expression, decimals } => format!("{} {decimals:?}", &text[expression]),
            })
            .collect();
        assert_eq!(pieces, expected);
        assert_eq!(diagnostics.iter().map(|d| d.message.english()).collect::<Vec<_>>(), messages);
    }

    #[test]
    fn placeholders_stand_in_braces() {
        check("t = {t:.2}", &["\"t = \"", "t Some(2)"], &[]);
        check("{y in [cm]}{a < b}", &["y in [cm] None", "a < b None"], &[]);
        check("{{x}} &lt;&#916;&#x394;&nbsp;", &[r#""{x} <ΔΔ\u{a0}""#], &[]);
    }

    #[test]
    fn faults_are_literal() {
        check("{y", &["\"{y\""], &["this `{` has no partner on its line"]);
        check("y} é", &["\"y} é\""], &["this `}` has no partner on its line"]);
        check("a & b &#0; &x;", &["\"a & b &#0; &x;\""], &["this `&` begins no character"; 3]);
    }
}
