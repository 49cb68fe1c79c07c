//! Commas: decimal commas and separators of arguments.

use crate::parser::cursor::{Cursor, Read};
use crate::{Diagnostic, Name, Span};
use units::words;

/// Functions with any number of arguments, for which `1,5` is two arguments.
const OF_ANY_NUMBER: [&str; 3] = ["min", "max", "sum"];

/// Number of digits after a comma that may separate thousands.
const THOUSANDS: usize = 3;

impl Cursor<'_> {
    /// Reports a comma in a place where none is allowed; between digits it was meant as a decimal point.
    pub(in crate::parser) fn decimal_comma<T>(&mut self) -> Read<T> {
        let comma = self.span();
        if !self.is_between_digits(comma) {
            let wrong = words("a comma cannot stand here");
            return self.fail(Diagnostic::error("unexpected-token", wrong, comma));
        }
        let wrong = words("a number has a decimal point here, not a comma");
        let diagnostic = Diagnostic::error("decimal-comma", wrong, comma).with_fix(comma, ".");
        let is_digit = |c: char| c.is_ascii_digit();
        let before = &self.source[..comma.start];
        let before = &before[before.trim_end_matches(is_digit).len()..];
        let after = &self.source[comma.end..];
        let after = &after[..after.len() - after.trim_start_matches(is_digit).len()];
        let is_ambiguous = after.len() == THOUSANDS && before.len() <= THOUSANDS && !before.starts_with('0');
        self.fail(if is_ambiguous {
            diagnostic
                .with_hint(words!("a decimal comma means {before}.{after}, a separator of thousands {before}{after}"))
                .with_fix(comma, "")
        } else {
            diagnostic
        })
    }

    /// True if the comma stands directly between two digits.
    pub(in crate::parser) fn is_between_digits(&self, comma: Span) -> bool {
        let bytes = self.source.as_bytes();
        let is_digit = |at: Option<usize>| at.and_then(|at| bytes.get(at)).is_some_and(u8::is_ascii_digit);
        is_digit(comma.start.checked_sub(1)) && is_digit(Some(comma.end))
    }

    /// Reports decimal commas in arguments: `max(1,5; 2)` and `max(1,5)`. If semicolons separate arguments, commas are
    /// decimal; otherwise they may be.
    pub(in crate::parser) fn check_separators(&mut self, function: &Name, separators: &[Span], end: Span) {
        let source = self.source;
        let is_semicolon = |span: &&Span| &source[span.range()] == ";";
        if let Some(first) = separators.iter().find(is_semicolon) {
            let call = function.span.to(end);
            let mut written = String::new();
            let mut at = call.start;
            let mut has_decimal = false;
            for separator in separators {
                written += &source[at..separator.start];
                let is_decimal = !is_semicolon(&separator) && self.is_between_digits(*separator);
                has_decimal |= is_decimal;
                written += if is_decimal { "." } else { "," };
                at = separator.end;
            }
            written += &source[at..call.end];
            let wrong = words("arguments are separated by `,` here, not by `;`");
            let diagnostic = Diagnostic::error("argument-separator", wrong, *first);
            let diagnostic = diagnostic.with_hint(if has_decimal {
                words!("with decimal points, write {written}")
            } else {
                words!("write {written}")
            });
            return self.say(diagnostic.with_fix(call, written));
        }
        if !OF_ANY_NUMBER.contains(&function.text.as_str()) {
            return;
        }
        for comma in separators.iter().filter(|comma| self.is_between_digits(**comma)).copied().collect::<Vec<_>>() {
            let wrong = words("this comma separates two arguments");
            self.say(
                Diagnostic::warning("decimal-comma", wrong, comma)
                    .with_hint(words(
                        "a number has a decimal point; between two arguments write a blank after the comma",
                    ))
                    .with_fix(comma, ".")
                    .with_fix(comma, ", "),
            );
        }
    }
}
