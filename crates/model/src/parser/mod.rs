//! The grammar of the model language, and its parser.
//!
//! ```text
//! model       = { statement line-end }
//! statement   = parameter | switch | random | choice | independent | size | event | button | next | function | table
//!             | definition | initial | equation
//! parameter   = [ "hidden" ] "parameter" NAME "=" [ "-" ] NUMBER [ "/" NUMBER ] [ UNIT ]
//!               [ "in" signed ".." signed ] [ "step" NUMBER ] [ "assigned" signed ".." signed "step" NUMBER ] [ TEXT ]
//! switch      = "switch" NAME "=" ( "on" | "off" | "true" | "false" ) [ TEXT ]
//! random      = "random" NAME "=" NUMBER [ "in" signed ".." signed ] [ TEXT ]
//! choice      = "choice" NAME [ TEXT ] "{" alternative { separator alternative } "}"
//! alternative = TEXT ":" chosen { "," chosen }
//! chosen      = [ "hidden" ] NAME "=" expression [ "in" UNIT ] [ TEXT ]
//! assignment  = NAME "=" expression [ "in" UNIT ]
//! independent = "independent" NAME [ "in" UNIT | "by" "1" ] [ TEXT ]
//! next        = "next" NAME [ INDICES ] "=" expression [ over ] [ TEXT ]
//! size        = "size" NAME "=" NUMBER [ "in" signed ".." signed ] [ TEXT ]
//! event       = ( "when" expression | "every" expression [ "from" expression ] ) [ "as" NAME ]
//!               "{" [ action { separator action } ] "}" [ over ] [ TEXT ]
//! group       = "group" TEXT
//! button      = "button" TEXT [ "as" NAME ] "{" [ action { separator action } ] "}"
//! action      = target "=" expression [ over ] | "let" NAME "=" expression | "stop"
//! target      = NAME [ INDICES ] [ PRIMES ] [ AXIS [ PRIMES ] ]
//! separator   = ";" | "," | line-end
//! function    = "function" NAME "(" NAME { "," NAME } ")" "=" expression [ "in" UNIT ] [ TEXT ]
//! table       = [ "smooth" | "steps" ] "table" NAME "(" NAME ")" [ "in" UNIT ] [ TEXT ] ( [ drawn ] points | drawn ) [ TEXT ]
//! points      = "{" { point [ separator ] } "}"
//! drawn       = "drawn" "in" signed ".." signed [ "from" signed-number [ UNIT ] ] "until" signed-number [ UNIT ]
//! point       = signed-number [ UNIT ] signed-number [ UNIT ]
//! definition  = [ "hidden" ] NAME [ INDICES ] "=" expression [ "in" UNIT ] [ over ] [ TEXT ]
//! initial     = target "(" "0" ")" "=" expression [ "in" UNIT ] [ over ] [ TEXT ]
//! equation    = expression "=" expression [ over ] [ TEXT ]
//! over        = "for" NAME "in" expression ".." expression { "," NAME "in" expression ".." expression }
//!
//! expression  = "if" expression "then" expression "else" expression | disjunction
//! disjunction = conjunction { "or" conjunction }
//! conjunction = negation { "and" negation }
//! negation    = "not" negation | comparison
//! comparison  = sum [ ( "<" | "<=" | ">" | ">=" | "==" | "!=" ) sum ]
//! sum         = product { ( "+" | "-" ) product }
//! product     = signed { ( "*" | "/" ) signed }
//! signed      = ( "-" | "+" ) signed | power
//! power       = component [ RAISED ] [ "^" signed ]              (to the right: a^b^c is a^(b^c))
//! component   = operand [ AXIS ]
//! operand     = NUMBER [ UNIT ] | TEXT | target | NAME "." NAME [ PRIMES ] | target "(" "0" ")"
//!             | NAME "(" expression { "," expression } [ over ] ")" | "(" expression ")" | "√" operand
//!             | "(" expression "," expression [ "," expression ] ")" [ UNIT ]
//! ```
//!
//! A statement ends with its line, unless a parenthesis is open or the line ends in an operator; see `layout.rs`. `#`
//! begins a comment. UNIT is `[` ... `]` and is read by the `units` crate; TEXT stands in quotation marks; RAISED are
//! characters such as ²; AXIS is `.x`, `.y` or `.z` without a blank before it; PRIMES follow their name without a blank,
//! and so do INDICES: `[` expression { "," expression } `]`.
//!
//! The parser never fails. It returns what it could parse, with [`ExpressionKind::Error`] for the rest, and reports the
//! reasons. After an error it continues with the next statement, so that each mistake is reported once. Nesting depth is
//! limited, so that no text can exhaust the stack, here or in later traversals.

mod cursor;
mod ending;
mod expression;
mod layout;
mod statement;
#[cfg(test)]
mod tests;

use crate::{Assignment, Diagnostic, Expression, ExpressionKind, Span, StatedUnit, Statement, lexer};
use cursor::Cursor;
use std::ops::Range;

pub(crate) use layout::goes_on;

/// Parses the statements of a model in `parts` of a document, which are byte ranges. Spans count from the beginning of
/// `source`. All statements are returned even after errors: an unreadable one becomes an equation of two
/// [`crate::ExpressionKind::Error`].
pub fn parse(source: &str, parts: &[Range<usize>]) -> (Vec<Statement>, Vec<Diagnostic>) {
    let mut statements = Vec::new();
    let mut diagnostics = Vec::new();
    for part in parts {
        let (tokens, found) = lexer::tokens(source, on_boundaries(source, part));
        let mut cursor = Cursor::new(source, layout::statement_lines(tokens), found);
        statements.extend(cursor.statements());
        diagnostics.extend(cursor.finish());
    }
    (statements, diagnostics)
}

/// Parses an expression that fills `source[range]`, and an optional `in [unit]` after it. Line ends are ignored.
pub fn parse_expression(source: &str, range: Range<usize>) -> (Expression, Option<StatedUnit>, Vec<Diagnostic>) {
    let (tokens, found) = lexer::tokens(source, on_boundaries(source, &range));
    let mut cursor = Cursor::new(source, layout::one_line(tokens), found);
    let (expression, unit) = cursor.whole_expression();
    (expression, unit, cursor.finish())
}

/// Parses assignments that fill `source[range]`, separated by commas, semicolons or line ends: `rho = 13534 [kg/m^3], b =
/// 2*m*omega_0`.
pub fn parse_assignments(source: &str, range: Range<usize>) -> (Vec<Assignment>, Vec<Diagnostic>) {
    let (tokens, found) = lexer::tokens(source, on_boundaries(source, &range));
    let mut cursor = Cursor::new(source, layout::statement_lines(tokens), found);
    let assignments = cursor.assignments();
    (assignments, cursor.finish())
}

/// The part of `range` that lies in `source`, widened to whole characters.
fn on_boundaries(source: &str, range: &Range<usize>) -> Range<usize> {
    let start = source.floor_char_boundary(range.start);
    start..source.floor_char_boundary(range.end).max(start)
}

/// Placeholder for an unreadable expression.
fn unread(span: Span) -> Expression {
    Expression { kind: ExpressionKind::Error, span }
}
