//! Ends of statements and expressions, and errors about unexpected text after them.

use super::cursor::{Cursor, Read};
use crate::lexer::{Keyword, Symbol, TokenKind};
use crate::{Diagnostic, Quoted, Span, StatementKind};
use units::words;

impl Cursor<'_> {
    /// Requires the end of a statement.
    pub(super) fn statement_end(&mut self, kind: &StatementKind, label: Option<&Quoted>) -> Read<()> {
        if self.at_line_end() {
            return Ok(());
        }
        if let Some(span) = self.take(Symbol::Semicolon) {
            let diagnostic =
                Diagnostic::error("semicolon", words("a statement ends with its line, not with `;`"), span);
            let another = !self.at_line_end();
            self.say(if another {
                let hint = words("put the next statement on a line of its own");
                diagnostic.with_hint(hint).with_fix(span, "\n")
            } else {
                diagnostic.with_fix(span, "")
            });
            return Ok(());
        }
        if let Some(label) = label {
            let wrong = words!("the label is the last part of a statement, but {found} follows", found = self.found());
            let diagnostic = Diagnostic::error("label-not-last", wrong, label.span);
            return self.fail(diagnostic.with_label(self.span(), words("belongs before the label")));
        }
        let span = self.span();
        if let (TokenKind::Name { .. }, StatementKind::Parameter(_)) = (self.peek(), kind) {
            let rest = self.source[span.start..].lines().next().unwrap_or_default();
            let label = rest.split('#').next().unwrap_or_default().trim_end();
            if label.chars().all(|c| c.is_alphabetic() || c == ' ') {
                let wrong = words!("`{label}` cannot stand here");
                let place = Span::new(span.start, span.start + label.len());
                let hint = words("a label stands in double quotation marks");
                let diagnostic = Diagnostic::error("unexpected-token", wrong, place);
                return self.fail(diagnostic.with_hint(hint).with_fix(place, format!("\"{label}\"")));
            }
        }
        if let (TokenKind::Keyword(Keyword::In), StatementKind::Equation { .. }) = (self.peek(), kind) {
            let diagnostic = Diagnostic::error("unit-of-equation", words("an equation has no unit to be stated"), span);
            return self.fail(diagnostic.with_hint(words("state units where a name or an initial value is defined")));
        }
        self.unexpected_after_expression()
    }

    /// True if the preceding token ends in a prime.
    fn ends_in_prime(&self) -> bool {
        let last = self.source[self.last_span().range()].chars().next_back();
        last.is_some_and(|last| units::alphabet::primes(last).is_some())
    }

    /// Reports the token that cannot follow an expression.
    pub(super) fn unexpected_after_expression<T>(&mut self) -> Read<T> {
        let span = self.span();
        let found = self.found();
        let diagnostic = match self.peek() {
            TokenKind::Symbol(Symbol::Comma) => return self.decimal_comma(),
            TokenKind::Brackets(_) if span.start == self.last_span().end && self.ends_in_prime() => {
                let wrong = words("the index stands before the primes");
                Diagnostic::error("index-after-primes", wrong, span).with_hint(words("such as x[i]'"))
            }
            TokenKind::Brackets(_) => {
                let wrong = words!("{found} follows something that is not a number");
                Diagnostic::error("unit-without-number", wrong, span)
                    .with_note(words("after a name or a parenthesis, brackets are kept for indices"))
                    .with_hint(words!("to state the unit of the expression, write: in {}", &self.source[span.range()]))
                    .with_fix(
                        Span::new(span.start, span.start),
                        if self.last_span().end < span.start { "in " } else { " in " },
                    )
            }
            TokenKind::Symbol(Symbol::Equals) => {
                Diagnostic::error("second-equals", words("there is an `=` already"), span)
                    .with_hint(words("write each equation on a line of its own; to compare, write =="))
            }
            TokenKind::Symbol(Symbol::RightParenthesis) => {
                Diagnostic::error("unmatched-parenthesis", words("this `)` closes nothing"), span)
            }
            TokenKind::Symbol(Symbol::RightBrace) => {
                Diagnostic::error("unmatched-brace", words("this `}` closes nothing"), span)
            }
            TokenKind::Symbol(Symbol::LeftBrace) => {
                Diagnostic::error("unexpected-token", words("braces belong to events"), span)
                    .with_hint(words("such as: when y < 0 [m] { y' = -y' }"))
            }
            TokenKind::Primes => {
                let rest = self.source[span.end..].lines().next().unwrap_or_default();
                let diagnostic = Diagnostic::error("prime-after-expression", words("a prime belongs to a name"), span);
                if rest.contains(['\'', '’']) {
                    diagnostic.with_hint(words("a text stands in double quotation marks"))
                } else {
                    diagnostic.with_hint(words("write it directly after the name: y'"))
                }
            }
            TokenKind::Keyword(Keyword::In) => Diagnostic::error(
                "unexpected-token",
                words("`in` can stand here only once, and not in parentheses"),
                span,
            ),
            TokenKind::Keyword(Keyword::Then | Keyword::Else) => {
                Diagnostic::error("unexpected-token", words!("there is no `if` to which this {found} belongs"), span)
            }
            TokenKind::Text(_) => Diagnostic::error("unexpected-token", words("a text cannot stand here"), span),
            _ => Diagnostic::error("unexpected-token", words!("{found} cannot stand here"), span),
        };
        self.fail(diagnostic)
    }
}
