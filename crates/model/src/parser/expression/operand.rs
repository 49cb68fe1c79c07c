//! Operands: numbers with their units, texts, names, initial values, calls and parentheses.

use super::{DEEPEST, Tree, leaf};
use crate::lexer::{Keyword, Symbol, TokenKind};
use crate::parser::cursor::{Cursor, Read};
use crate::{Diagnostic, Expression, ExpressionKind, Name, Span};
use program::functions::Function;
use units::words;

impl Cursor<'_> {
    /// Parses an operand and an optional component after it.
    pub(in crate::parser) fn operand(&mut self) -> Read<Tree> {
        let whole = self.whole_operand()?;
        self.component_of(whole)
    }

    fn whole_operand(&mut self) -> Read<Tree> {
        let span = self.span();
        match *self.peek() {
            TokenKind::Number(value) => {
                self.advance();
                self.number(value, span)
            }
            TokenKind::Text(_) => Ok(leaf(ExpressionKind::Text(self.take_text()), span)),
            TokenKind::Name { order, end, .. } => {
                let name = Name { text: self.take_text(), span: Span::new(span.start, end) };
                if order == 0 && self.at_indices() { self.member(name) } else { self.name(name, order, span) }
            }
            TokenKind::Symbol(Symbol::LeftParenthesis) => {
                self.advance();
                let mut inside = self.expression()?;
                self.refuse_equals(words("parenthesis"));
                if *self.peek() == TokenKind::Symbol(Symbol::Comma) {
                    return self.tuple(inside, span);
                }
                let end = self.close(span)?;
                inside.expression.span = span.to(end);
                inside.parenthesised = true;
                self.refuse_prime()?;
                Ok(inside)
            }
            TokenKind::Symbol(Symbol::Root) => {
                self.advance();
                if self.depth >= DEEPEST {
                    return self.too_deep(span, words("this is nested too deeply"));
                }
                self.depth += 1;
                let inside = self.operand();
                self.depth -= 1;
                let function = Name { text: "sqrt".to_owned(), span };
                let inside = inside?;
                Ok(call(function, vec![inside], span))
            }
            _ => self.missing_operand(),
        }
    }

    fn number(&mut self, value: f64, span: Span) -> Read<Tree> {
        let TokenKind::Brackets(inside) = self.peek().clone() else {
            self.refuse_prime()?;
            return Ok(leaf(ExpressionKind::Number { value, unit: None }, span));
        };
        let end = self.advance();
        let kind = match self.unit(inside) {
            Ok(unit) => ExpressionKind::Number { value, unit: Some(unit) },
            Err(_) => ExpressionKind::Error,
        };
        Ok(leaf(kind, span.to(end)))
    }

    /// Parses a name, a call or an initial value.
    fn name(&mut self, name: Name, order: u32, span: Span) -> Read<Tree> {
        let Some(parenthesis) = self.take(Symbol::LeftParenthesis) else {
            return Ok(leaf(ExpressionKind::Name { name: name.text, order }, span));
        };
        if let TokenKind::Number(value) = *self.peek()
            && value == 0.0
            && *self.peek_ahead(1) == TokenKind::Symbol(Symbol::RightParenthesis)
            && (order > 0 || Function::reserving(&name.text).is_none())
        {
            self.advance();
            let end = self.advance();
            return Ok(leaf(ExpressionKind::InitialValue { name: name.text, order }, span.to(end)));
        }
        if order > 0 {
            return self.derivative_call(&name, order, span, parenthesis);
        }
        let mut arguments = Vec::new();
        let mut separators = Vec::new();
        if *self.peek() != TokenKind::Symbol(Symbol::RightParenthesis) {
            loop {
                arguments.push(self.expression()?);
                self.refuse_equals(words("function's argument"));
                if self.at_for() {
                    return self.reduction(name, arguments, parenthesis);
                }
                let separator = self.take(Symbol::Comma).or_else(|| self.take(Symbol::Semicolon));
                let Some(separator) = separator else { break };
                separators.push(separator);
            }
        }
        let end = self.close(parenthesis)?;
        self.check_separators(&name, &separators, end);
        self.refuse_prime()?;
        if name.text == "log" {
            let diagnostic =
                Diagnostic::error("ambiguous-logarithm", words("it is not clear which logarithm `log` is"), name.span)
                    .with_hint(words("write ln for the natural logarithm or log10 for the decimal one"))
                    .with_fix(name.span, "ln")
                    .with_fix(name.span, "log10");
            self.say(diagnostic);
            return Ok(leaf(ExpressionKind::Error, span.to(end)));
        }
        Ok(call(name, arguments, span.to(end)))
    }

    /// Reports `y'(t)` and `y'(1)`: only `y'(0)` is defined.
    fn derivative_call(&mut self, name: &Name, order: u32, span: Span, parenthesis: Span) -> Read<Tree> {
        let argument = self.expression()?;
        let end = self.close(parenthesis)?;
        let written = &self.source[span.range()];
        let diagnostic = Diagnostic::error(
            "initial-value-not-at-zero",
            words!("only 0 can stand in the parenthesis after `{written}`"),
            argument.expression.span,
        )
        .with_note(words!("{written}(0) is the value at the start, {written} alone the present one"));
        let diagnostic = match argument.expression.kind {
            ExpressionKind::Number { .. } => diagnostic,
            ExpressionKind::Name { .. } => diagnostic.with_fix(parenthesis.to(end), ""),
            _ => diagnostic.with_hint(words!("a product is written with *: {written}*(...)")),
        };
        self.say(diagnostic);
        Ok(leaf(ExpressionKind::Name { name: name.text.clone(), order }, span.to(end)))
    }

    /// Consumes the `)` that closes the `(` at `open`.
    pub(in crate::parser) fn close(&mut self, open: Span) -> Read<Span> {
        if let Some(end) = self.take(Symbol::RightParenthesis) {
            return Ok(end);
        }
        if *self.peek() == TokenKind::Symbol(Symbol::Comma) {
            return self.decimal_comma();
        }
        let diagnostic = if self.at_line_end() {
            Diagnostic::error("unclosed-parenthesis", words("this `(` is not closed"), open)
                .with_label(self.last_span().after(), words("`)` is missing, here at the latest"))
        } else {
            let wrong = words!("`)` is expected here, not {found}", found = self.found());
            Diagnostic::error("unclosed-parenthesis", wrong, self.span()).with_label(open, words("closes this `(`"))
        };
        self.fail(diagnostic.with_fix(self.last_span().after(), ")"))
    }

    /// Reports a prime after a number or a parenthesis, as in `(a + b)'`.
    fn refuse_prime(&mut self) -> Read<()> {
        if *self.peek() != TokenKind::Primes {
            return Ok(());
        }
        let diagnostic = Diagnostic::error("prime-after-expression", words("a prime belongs to a name"), self.span())
            .with_hint(words("give the expression a name (v = ...) and write v'"));
        self.fail(diagnostic)
    }

    fn missing_operand(&mut self) -> Read<Tree> {
        let span = self.span();
        let last = self.last_span();
        let written = &self.source[last.range()];
        let line_end = self.at_line_end();
        let place = if line_end { last } else { span };
        let found = self.found();
        let diagnostic = match self.peek() {
            TokenKind::Brackets(_) => {
                Diagnostic::error("unit-without-number", words("a unit belongs to a number"), span)
                    .with_hint(words("such as 1 [m]; to state the unit of an expression, write `in [m]` after it"))
            }
            TokenKind::Primes => Diagnostic::error("prime-after-expression", words("a prime belongs to a name"), span)
                .with_hint(words("write it directly after the name: y'")),
            TokenKind::Keyword(Keyword::Then | Keyword::Else | Keyword::In) => {
                let wrong = words!("an expression is expected before {found}");
                Diagnostic::error("missing-expression", wrong, place)
            }
            TokenKind::Keyword(Keyword::Parameter | Keyword::Independent | Keyword::When) => {
                let wrong = words!("{found} is a word of the language and cannot be a name");
                Diagnostic::error("reserved-word", wrong, place)
            }
            _ if line_end && last.start < last.end => {
                let wrong = words!("an expression is expected after `{written}`");
                Diagnostic::error("missing-expression", wrong, place)
            }
            _ if line_end => Diagnostic::error("missing-expression", words("an expression is expected here"), place),
            _ => Diagnostic::error("missing-expression", words!("an expression is expected here, not {found}"), place),
        };
        self.fail(diagnostic)
    }
}

fn call(function: Name, arguments: Vec<Tree>, span: Span) -> Tree {
    let height = arguments.iter().map(|argument| argument.height).max().unwrap_or(0) + 1;
    let span = arguments.last().map_or(span, |last| span.to(last.expression.span));
    let arguments = arguments.into_iter().map(|argument| argument.expression).collect();
    let kind = ExpressionKind::Call { function, arguments };
    Tree { expression: Expression { kind, span }, height, parenthesised: false }
}
