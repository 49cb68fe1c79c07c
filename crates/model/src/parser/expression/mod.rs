//! Expressions, by precedence climbing (Pratt's method): each operator has a binding strength.

mod bare_unit;
mod comma;
mod juxtaposed;
mod operand;
mod vector;

use super::cursor::{Cursor, Read};
use super::unread;
use crate::lexer::{Keyword, Symbol, TokenKind};
use crate::{BinaryOperator, Diagnostic, Edit, Expression, ExpressionKind, Span, StatedUnit, UnaryOperator};
use units::{Words, words};

/// Maximum nesting depth of parentheses, prefixes, exponents and branches.
pub(super) const DEEPEST: usize = 64;

/// Maximum height of the tree. A sum of n terms has height n, so this also limits the length of a sum.
const HIGHEST: usize = crate::limits::HEIGHT;

/// An expression and the height of its tree.
pub(super) struct Tree {
    pub(super) expression: Expression,
    pub(super) height: usize,
    /// True if it stands in parentheses or after a plus; its tokens then extend beyond its operands.
    pub(super) parenthesised: bool,
}

/// Binding strength of operators, weakest first. Prefix minus stands between product and power.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Strength {
    Any,
    Disjunction,
    Conjunction,
    Negation,
    Comparison,
    Sum,
    Product,
    Signed,
    Power,
}

fn operator(kind: &TokenKind) -> Option<(BinaryOperator, Strength)> {
    Some(match kind {
        TokenKind::Keyword(Keyword::Or) => (BinaryOperator::Or, Strength::Disjunction),
        TokenKind::Keyword(Keyword::And) => (BinaryOperator::And, Strength::Conjunction),
        TokenKind::Symbol(symbol) => match symbol {
            Symbol::Less => (BinaryOperator::Less, Strength::Comparison),
            Symbol::LessOrEqual => (BinaryOperator::LessOrEqual, Strength::Comparison),
            Symbol::Greater => (BinaryOperator::Greater, Strength::Comparison),
            Symbol::GreaterOrEqual => (BinaryOperator::GreaterOrEqual, Strength::Comparison),
            Symbol::EqualTo => (BinaryOperator::Equal, Strength::Comparison),
            Symbol::NotEqualTo => (BinaryOperator::NotEqual, Strength::Comparison),
            Symbol::Plus => (BinaryOperator::Add, Strength::Sum),
            Symbol::Minus => (BinaryOperator::Subtract, Strength::Sum),
            Symbol::Star => (BinaryOperator::Multiply, Strength::Product),
            Symbol::Slash => (BinaryOperator::Divide, Strength::Product),
            Symbol::Caret => (BinaryOperator::Power, Strength::Power),
            _ => return None,
        },
        _ => return None,
    })
}

/// Weakest operator allowed in the right operand of an operator of this strength.
fn right_of(strength: Strength) -> Strength {
    match strength {
        Strength::Any | Strength::Disjunction => Strength::Conjunction,
        Strength::Conjunction => Strength::Negation,
        Strength::Negation | Strength::Comparison => Strength::Sum,
        Strength::Sum => Strength::Product,
        Strength::Product | Strength::Power => Strength::Signed,
        Strength::Signed => Strength::Power,
    }
}

pub(super) fn leaf(kind: ExpressionKind, span: Span) -> Tree {
    Tree { expression: Expression { kind, span }, height: 1, parenthesised: false }
}

impl Cursor<'_> {
    /// Parses an expression. The next token is then the first that cannot continue it.
    pub(super) fn expression(&mut self) -> Read<Tree> {
        self.climb(Strength::Any)
    }

    /// Parses an expression up to the end of the tokens, with an optional `in [unit]`.
    pub(super) fn whole_expression(&mut self) -> (Expression, Option<StatedUnit>) {
        let start = self.span();
        let read = self.expression();
        let unit = if read.is_ok() { self.stated_unit() } else { Ok(None) };
        if read.is_ok() && unit.is_ok() && *self.peek() != TokenKind::End {
            let _told = self.unexpected_after_expression::<()>();
        }
        match read {
            Ok(tree) => (tree.expression, unit.unwrap_or(None)),
            Err(_) => (unread(start.to(self.last_span())), None),
        }
    }

    fn climb(&mut self, weakest: Strength) -> Read<Tree> {
        if self.depth >= DEEPEST {
            return self.too_deep(self.span(), words("this is nested too deeply"));
        }
        self.depth += 1;
        let read = self.prefix(weakest).and_then(|left| self.infix(left, weakest));
        self.depth -= 1;
        read
    }

    pub(super) fn too_deep<T>(&mut self, span: Span, wrong: Words) -> Read<T> {
        let diagnostic = Diagnostic::error("too-deep", wrong, span)
            .with_hint(words("define parts of it as quantities of their own"));
        self.fail(diagnostic)
    }

    fn prefix(&mut self, weakest: Strength) -> Read<Tree> {
        let start = self.span();
        match self.peek() {
            TokenKind::Keyword(Keyword::If) => self.branches(),
            TokenKind::Keyword(Keyword::Not) => {
                self.advance();
                let operand = self.climb(if weakest > Strength::Negation { weakest } else { Strength::Negation })?;
                Ok(unary(UnaryOperator::Not, operand, start))
            }
            TokenKind::Symbol(Symbol::Minus) => {
                self.advance();
                let operand = self.climb(Strength::Signed)?;
                Ok(unary(UnaryOperator::Negate, operand, start))
            }
            TokenKind::Symbol(Symbol::Plus) => {
                self.advance();
                let mut operand = self.climb(Strength::Signed)?;
                operand.expression.span = start.to(operand.expression.span);
                operand.parenthesised = true;
                Ok(operand)
            }
            _ => self.operand(),
        }
    }

    fn infix(&mut self, mut left: Tree, weakest: Strength) -> Read<Tree> {
        loop {
            if let TokenKind::Raised(exponent) = *self.peek() {
                let span = self.advance();
                let value = leaf(ExpressionKind::Number { value: f64::from(exponent), unit: None }, span);
                left = self.join(BinaryOperator::Power, left, value, span)?;
                continue;
            }
            let Some((operator, strength)) = operator(self.peek()) else {
                // `2 g`, `(a)(b)`: reported, then parsed as the product that was meant.
                if weakest <= Strength::Product && self.begins_operand() {
                    self.missing_operator(&left.expression);
                    let right = self.climb(right_of(Strength::Product))?;
                    let span = right.expression.span;
                    left = self.join(BinaryOperator::Multiply, left, right, span)?;
                    continue;
                }
                return Ok(left);
            };
            if strength < weakest {
                return Ok(left);
            }
            let place = self.advance();
            let mut right = self.climb(right_of(strength))?;
            if operator == BinaryOperator::Power {
                self.refuse_unit_in_exponent(&left, &mut right);
            }
            if strength == Strength::Comparison {
                self.refuse_chain(&left, place)?;
            }
            left = self.join(operator, left, right, place)?;
        }
    }

    fn join(&mut self, operator: BinaryOperator, left: Tree, right: Tree, place: Span) -> Read<Tree> {
        let height = left.height.max(right.height) + 1;
        if height > HIGHEST {
            return self.too_deep(place, words("this expression is too long"));
        }
        let span = left.expression.span.to(right.expression.span);
        let kind = ExpressionKind::Binary(operator, Box::new(left.expression), Box::new(right.expression));
        Ok(Tree { expression: Expression { kind, span }, height, parenthesised: false })
    }

    /// Reports `a < b < c`.
    fn refuse_chain(&mut self, left: &Tree, place: Span) -> Read<()> {
        use BinaryOperator::{Equal, Greater, GreaterOrEqual, Less, LessOrEqual, NotEqual};
        let ExpressionKind::Binary(Less | LessOrEqual | Greater | GreaterOrEqual | Equal | NotEqual, _, middle) =
            &left.expression.kind
        else {
            return Ok(());
        };
        if left.parenthesised {
            return Ok(());
        }
        let source = self.source;
        let middle = &source[middle.span.range()];
        let first = &source[left.expression.span.range()];
        let sign = &source[place.range()];
        let hint = words!("write both: {first} and {middle} {sign} ...");
        self.say(
            Diagnostic::error("chained-comparison", words("comparisons cannot be chained"), place).with_hint(hint),
        );
        Ok(())
    }

    /// True if the next token can only begin another operand.
    fn begins_operand(&self) -> bool {
        matches!(
            self.peek(),
            TokenKind::Number(_) | TokenKind::Name { .. } | TokenKind::Symbol(Symbol::LeftParenthesis | Symbol::Root)
        ) && !self.at_step()
            && !self.at_event_word()
            && !self.at_for()
    }

    /// True at `step` before a number, which is a keyword only in a parameter statement.
    fn at_step(&self) -> bool {
        let number = matches!(self.peek_ahead(1), TokenKind::Number(_));
        number && matches!(self.peek(), TokenKind::Name { text, order: 0, .. } if text == "step")
    }

    /// Reports `10^3 [m]`: the unit belongs to the number before it, which is the exponent.
    fn refuse_unit_in_exponent(&mut self, base: &Tree, exponent: &mut Tree) {
        let Expression { kind: ExpressionKind::Number { value, unit: Some(unit) }, span } = &exponent.expression else {
            return;
        };
        if unit.dimension.is_none() {
            return;
        }
        let diagnostic =
            Diagnostic::error("unit-in-exponent", words!("`[{unit}]` belongs to the exponent {value} here"), *span);
        let is_ten = matches!(base.expression.kind, ExpressionKind::Number { value, unit: None } if value == 10.0);
        self.say(if is_ten {
            diagnostic.with_hint(words!("powers of ten are part of a number: 1e{value} [{unit}]"))
        } else {
            diagnostic.with_hint(words!("to state the unit of the expression, write: in [{unit}]"))
        });
        exponent.expression.kind = ExpressionKind::Error;
    }

    fn branches(&mut self) -> Read<Tree> {
        let start = self.advance();
        let condition = self.expression()?;
        self.refuse_equals(words("condition"));
        self.expect_keyword(Keyword::Then, "then", start)?;
        let yes = self.expression()?;
        self.expect_keyword(Keyword::Else, "else", start)?;
        let no = self.expression()?;
        let height = condition.height.max(yes.height).max(no.height) + 1;
        if height > HIGHEST {
            return self.too_deep(start, words("this expression is too long"));
        }
        let span = start.to(no.expression.span);
        let [condition, yes, no] = [condition, yes, no].map(|tree| Box::new(tree.expression));
        let kind = ExpressionKind::If(condition, yes, no);
        Ok(Tree { expression: Expression { kind, span }, height, parenthesised: false })
    }

    /// Error for an event written as `if CONDITION then y' = -y'` or `if CONDITION { y' = -y' }`, at the token where another one
    /// is expected. `start`: the `if`, which begins a statement.
    fn event_meant(&self, keyword: Keyword, start: Span) -> Option<Diagnostic> {
        let source = self.source;
        let before = source[..start.start].rsplit('\n').next().unwrap_or_default();
        if !before.trim().is_empty() {
            return None;
        }
        let when = Edit { span: start, text: "when".to_owned() };
        let edits = match (keyword, self.peek()) {
            (Keyword::Then, TokenKind::Symbol(Symbol::LeftBrace)) => vec![when],
            (Keyword::Else, TokenKind::Symbol(Symbol::Equals)) => {
                let at = start.end + source[start.end..self.span().start].rfind("then")?;
                let line = source[at..].lines().next().unwrap_or_default();
                let end = at + line.split('#').next().unwrap_or_default().trim_end().len();
                let brace = Edit { span: Span::new(at, at + "then".len()), text: "{".to_owned() };
                vec![when, brace, Edit { span: Span::new(end, end), text: " }".to_owned() }]
            }
            _ => return None,
        };
        let wrong = words("what changes at a moment is an event, which begins with `when`");
        let hint = words("the form is: when CONDITION { y' = EXPRESSION }");
        Some(Diagnostic::error("event-action", wrong, start).with_hint(hint).with_fixes(edits))
    }

    fn expect_keyword(&mut self, keyword: Keyword, word: &str, start: Span) -> Read<()> {
        if self.take_keyword(keyword).is_some() {
            return Ok(());
        }
        if let Some(event) = self.event_meant(keyword, start) {
            return self.fail(event);
        }
        let code = if keyword == Keyword::Then { "missing-then" } else { "missing-else" };
        let diagnostic = if self.at_line_end() && *self.peek_ahead(1) == TokenKind::Keyword(keyword) {
            let wrong = words!("the line ends before the `{word}` of this `if`");
            let end = self.last_span().after();
            // The next line belongs to the same mistake.
            self.advance();
            Diagnostic::error(code, wrong, start)
                .with_label(end, words("the statement ends here"))
                .with_hint(words!("put `{word}` at the end of this line, or the whole `if` into parentheses"))
        } else {
            let wrong = words!("`{word}` is expected here, not {found}", found = self.found());
            let place = if self.at_line_end() { self.last_span().after() } else { self.span() };
            let diagnostic = Diagnostic::error(code, wrong, place)
                .with_label(start, words("of this `if`"))
                .with_hint(words("the form is: if CONDITION then VALUE else VALUE"));
            // A literal 0 fits every dimension.
            let is_last =
                self.at_line_end() || matches!(self.peek(), TokenKind::Text(_) | TokenKind::Keyword(Keyword::In));
            if keyword == Keyword::Else && is_last {
                diagnostic.with_fix(self.last_span().after(), " else 0")
            } else {
                diagnostic
            }
        };
        self.fail(diagnostic)
    }

    /// Reports `=` in a condition, where `==` is meant.
    pub(super) fn refuse_equals(&mut self, what: Words) {
        if *self.peek() == TokenKind::Symbol(Symbol::Equals) {
            let wrong = words!("`=` does not compare; it cannot stand in a {what}");
            let diagnostic = Diagnostic::error("equals-in-condition", wrong, self.span());
            self.say(diagnostic.with_hint(words("to compare, write ==")));
            self.advance();
            // Skips the right side; a second message about it is not needed.
            let _ = self.climb(Strength::Sum);
        }
    }
}

fn unary(operator: UnaryOperator, operand: Tree, start: Span) -> Tree {
    let span = start.to(operand.expression.span);
    let height = operand.height + 1;
    let kind = ExpressionKind::Unary(operator, Box::new(operand.expression));
    Tree { expression: Expression { kind, span }, height, parenthesised: false }
}
