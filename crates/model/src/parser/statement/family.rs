//! Families: `size N = 20`, members such as `x[i+1]''`, and `for i in 1..N`.

use super::{Salvaged, nothing};
use crate::lexer::{self, Keyword, Symbol, TokenKind};
use crate::parser::cursor::{Cursor, Read};
use crate::parser::expression::{Tree, leaf};
use crate::parser::layout;
use crate::{Diagnostic, Expression, ExpressionKind, Name, Over, SizeStatement, Span, StatementKind, limits};
use std::ops::Range;
use units::alphabet::primes;
use units::words;

/// Functions that combine the values for all indices.
const REDUCTIONS: [&str; 3] = ["sum", "min", "max"];

impl Cursor<'_> {
    /// `size N = 20 in 2..200`
    pub(in crate::parser) fn size(&mut self) -> Salvaged {
        let start = self.advance();
        let name = match self.plain_name(&words("a size")) {
            Ok(name) => name,
            Err(reported) => return (nothing(start), Err(reported)),
        };
        let span = name.span;
        let mut size = SizeStatement { name, value: 1, value_span: span, range: None };
        let read = self.size_parts(&mut size);
        (StatementKind::Size(size), read)
    }

    fn size_parts(&mut self, size: &mut SizeStatement) -> Read<()> {
        let equals = self.take(Symbol::Equals).is_some();
        let place = self.span();
        let value = if equals { self.signed_number() } else { None };
        let whole = value.filter(|value| value.fract() == 0.0 && *value >= 0.0);
        let Some(value) = whole else {
            let place = if self.at_line_end() && self.span() == place { self.last_span() } else { place };
            let wrong = words!("the size `{}` must be a whole number", size.name.text);
            let hint = words!("such as: size {} = 20", size.name.text);
            return self.fail(Diagnostic::error("size-value", wrong, place).with_hint(hint));
        };
        size.value_span = place.to(self.last_span());
        if value > f64::from(limits::MEMBERS) {
            let wrong = words!("a size is at most {}", limits::MEMBERS);
            self.say(Diagnostic::error("model-too-large", wrong, size.value_span));
            return Ok(());
        }
        size.value = value as u32;
        if let Some(keyword) = self.take_keyword(Keyword::In) {
            size.range = Some(self.bounds(keyword)?);
        }
        Ok(())
    }

    /// True at `for NAME in`. The word is reserved only there.
    pub(in crate::parser) fn at_for(&self) -> bool {
        matches!(self.peek(), TokenKind::Name { text, order: 0, .. } if text == "for") && self.at_index(1)
    }

    fn at_index(&self, ahead: usize) -> bool {
        matches!(self.peek_ahead(ahead), TokenKind::Name { order: 0, .. })
            && *self.peek_ahead(ahead + 1) == TokenKind::Keyword(Keyword::In)
    }

    /// Parses `for i in 1..N, j in 1..M` if it comes next.
    pub(in crate::parser) fn over(&mut self) -> Read<Vec<Over>> {
        let mut over = Vec::new();
        if !self.at_for() {
            return Ok(over);
        }
        self.advance();
        loop {
            let index = self.plain_name(&words("an index"))?;
            self.take_keyword(Keyword::In);
            let low = self.expression()?.expression;
            if self.take(Symbol::Dots).is_none() {
                let wrong = words!("`..` is expected in this range, not {found}", found = self.found());
                let place = if self.at_line_end() { self.last_span().after() } else { self.span() };
                return self.fail(
                    Diagnostic::error("index-range", wrong, place)
                        .with_hint(words!("the range of an index is written `for {} in 1..10`", index.text)),
                );
            }
            let high = self.expression()?.expression;
            over.push(Over { index, low, high });
            if *self.peek() != TokenKind::Symbol(Symbol::Comma) || !self.at_index(1) {
                return Ok(over);
            }
            self.advance();
        }
    }

    /// Parses `x[i+1]''` or `x[i](0)` after `name`; the index comes next.
    pub(in crate::parser) fn member(&mut self, name: Name) -> Read<Tree> {
        let (indices, mut height) = self.indices()?;
        height += 1;
        let order = self.primes_here()?;
        let vector = name.span.to(self.last_span());
        let (axis, order) = self.axis_after(order)?;
        let at_start = *self.peek() == TokenKind::Symbol(Symbol::LeftParenthesis)
            && *self.peek_ahead(1) == TokenKind::Number(0.0)
            && *self.peek_ahead(2) == TokenKind::Symbol(Symbol::RightParenthesis);
        if at_start {
            (0..3).for_each(|_| {
                self.advance();
            });
        }
        let span = name.span.to(self.last_span());
        let kind = ExpressionKind::Member { name: name.text, indices, order, at_start };
        let Some(axis) = axis else { return Ok(Tree { height, ..leaf(kind, span) }) };
        let of = Box::new(Expression { kind, span: vector });
        Ok(Tree { height: height + 1, ..leaf(ExpressionKind::Component { of, axis }, span) })
    }

    /// True at an index: brackets without a blank before them.
    pub(in crate::parser) fn at_indices(&self) -> bool {
        matches!(self.peek(), TokenKind::Brackets(_)) && self.span().start == self.last_span().end
    }

    /// Parses `[i, j+1]`. Also returns the height of the highest index expression.
    pub(in crate::parser) fn indices(&mut self) -> Read<(Vec<Expression>, usize)> {
        let TokenKind::Brackets(inside) = self.peek().clone() else {
            return Ok((Vec::new(), 0));
        };
        self.advance();
        let mut cursor = self.inside(inside);
        let mut indices = Vec::new();
        let mut height = 0;
        let read = loop {
            match cursor.expression() {
                Ok(tree) => {
                    height = height.max(tree.height);
                    indices.push(tree.expression);
                }
                Err(reported) => break Err(reported),
            }
            if cursor.take(Symbol::Comma).is_none() {
                break if *cursor.peek() == TokenKind::End { Ok(()) } else { cursor.unexpected_after_expression() };
            }
        };
        for diagnostic in cursor.finish() {
            self.say(diagnostic);
        }
        read.map(|()| (indices, height))
    }

    /// Cursor for the content of brackets.
    fn inside(&self, inside: Range<usize>) -> Cursor<'_> {
        let (tokens, found) = lexer::tokens(self.source, inside);
        let mut cursor = Cursor::new(self.source, layout::one_line(tokens), found);
        cursor.depth = self.depth;
        cursor
    }

    /// Parses the primes directly after an index and returns their number.
    pub(in crate::parser) fn primes_here(&mut self) -> Read<u32> {
        if *self.peek() != TokenKind::Primes || self.span().start != self.last_span().end {
            return Ok(0);
        }
        let span = self.span();
        let order = self.source[span.range()].chars().filter_map(primes).sum();
        if order > limits::ORDER {
            let wrong = words!("{order} primes are too many");
            return self.fail(
                Diagnostic::error("order-too-high", wrong, span)
                    .with_note(words!("derivatives up to the order {} are possible", limits::ORDER)),
            );
        }
        self.advance();
        Ok(order)
    }

    /// Parses `sum(x[i] for i in 1..N)` from `for` on.
    pub(in crate::parser) fn reduction(&mut self, function: Name, body: Vec<Tree>, open: Span) -> Read<Tree> {
        let place = self.span();
        let over = self.over()?;
        let end = self.close(open)?;
        let span = function.span.to(end);
        let is_known = REDUCTIONS.contains(&function.text.as_str());
        let Ok([body]) = <[Tree; 1]>::try_from(body) else {
            let wrong = words("one expression stands before `for`");
            return self.fail(Diagnostic::error("index-range", wrong, place));
        };
        if !is_known {
            let wrong = words!("`for` cannot stand in `{}`; it belongs to sum, min and max", function.text);
            return self.fail(Diagnostic::error("index-range", wrong, place));
        }
        let height = body.height + 1;
        let kind = ExpressionKind::Reduction { function, body: Box::new(body.expression), over };
        Ok(Tree { height, ..leaf(kind, span) })
    }
}
