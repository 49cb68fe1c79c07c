//! Vectors: `(1, 0) [au]` by their components, and components, `r[i].x`, `(a - b).y`.

use super::{Tree, leaf};
use crate::components::AXES;
use crate::lexer::{Symbol, TokenKind};
use crate::parser::cursor::{Cursor, Read};
use crate::{Diagnostic, Expression, ExpressionKind, Span, limits};
use units::words;

impl Cursor<'_> {
    /// Parses the rest of `(1, 0) [au]` after the first component; `open` is its parenthesis.
    pub(in crate::parser) fn tuple(&mut self, first: Tree, open: Span) -> Read<Tree> {
        let mut height = first.height;
        let mut parts = vec![first.expression];
        while self.take(Symbol::Comma).is_some() {
            let part = self.expression()?;
            self.refuse_equals(words("parenthesis"));
            height = height.max(part.height);
            parts.push(part.expression);
        }
        let end = self.close(open)?;
        let mut span = open.to(end);
        if parts.len() > AXES.len() {
            let count = parts.len();
            let wrong = words!("a vector has 2 or 3 components, and this has {count}");
            self.say(Diagnostic::error("vector-components", wrong, span).with_hint(words(
                "what has a number for each of many things is a family: `x[i] = ... for i in 1..10`",
            )));
            return Ok(leaf(ExpressionKind::Error, span));
        }
        let mut unit = None;
        if let TokenKind::Brackets(inside) = self.peek().clone() {
            span = span.to(self.advance());
            let Ok(read) = self.unit(inside) else { return Ok(leaf(ExpressionKind::Error, span)) };
            unit = Some(read);
        }
        if *self.peek() == TokenKind::Primes {
            return self.prime_after();
        }
        Ok(Tree { height: height + 1, ..leaf(ExpressionKind::Tuple { parts, unit }, span) })
    }

    /// Parses a component of `whole`, if it comes next.
    pub(in crate::parser) fn component_of(&mut self, whole: Tree) -> Read<Tree> {
        let TokenKind::Component { axis, order } = *self.peek() else { return Ok(whole) };
        if order > 0 {
            return self.prime_after();
        }
        let span = whole.expression.span.to(self.advance());
        let of = Box::new(whole.expression);
        Ok(Tree { height: whole.height + 1, ..leaf(ExpressionKind::Component { of, axis }, span) })
    }

    /// Parses a component after an index and `order` primes, if it comes next. Returns its axis and the total number of
    /// primes.
    pub(in crate::parser) fn axis_after(&mut self, order: u32) -> Read<(Option<usize>, u32)> {
        let TokenKind::Component { axis, order: more } = *self.peek() else { return Ok((None, order)) };
        if order + more > limits::ORDER {
            let wrong = words!("{} primes are too many", order + more);
            return self.fail(Diagnostic::error("order-too-high", wrong, self.span()));
        }
        self.advance();
        Ok((Some(axis), order + more))
    }

    fn prime_after(&mut self) -> Read<Tree> {
        let diagnostic = Diagnostic::error("prime-after-expression", words("a prime belongs to a name"), self.span())
            .with_hint(words("give the vector a name (d = ...) and write d'"));
        self.fail(diagnostic)
    }

    /// Reports `r[1].x(0) = 2`: the initial value of a vector is given as a whole. Returns true if `left` is such a
    /// component.
    pub(in crate::parser) fn component_at_start(&mut self, left: &Expression) -> bool {
        let ExpressionKind::Component { of, .. } = &left.kind else { return false };
        let ExpressionKind::Member { at_start: true, .. } = &of.kind else { return false };
        let wrong = words("the value at the start is given for the vector as a whole");
        self.say(
            Diagnostic::error("component-at-start", wrong, left.span).with_hint(words("such as: r[1](0) = (0, 1) [m]")),
        );
        true
    }
}
