//! Statements that begin with a keyword, and the assignments of presets.

use super::{Salvaged, nothing};
use crate::lexer::{Keyword, Symbol, TokenKind};
use crate::parser::cursor::{Cursor, Read};
use crate::parser::unread;
use crate::{
    AssignedRange, Assignment, Bounds, Diagnostic, Edit, ParameterForm, ParameterStatement, Span, StatedUnit,
    StatementKind,
};
use units::{Words, words};

impl Cursor<'_> {
    /// `parameter b = 50 [kg/s] in 0..20000 step 1`
    pub(in crate::parser) fn parameter(&mut self) -> Salvaged {
        self.valued(&words("a parameter"), ParameterForm::Number, Self::parameter_parts)
    }

    /// Keyword and name of a parameter or a switch, then its parts by `parts`. `what`: words for it in a message.
    pub(super) fn valued(
        &mut self,
        what: &Words,
        form: ParameterForm,
        parts: impl FnOnce(&mut Self, &mut ParameterStatement) -> Read<()>,
    ) -> Salvaged {
        let start = self.advance();
        let name = match self.plain_name(what) {
            Ok(name) => name,
            Err(reported) => return (nothing(start), Err(reported)),
        };
        let mut parameter = ParameterStatement::bare(name, form);
        let read = parts(self, &mut parameter);
        (StatementKind::Parameter(parameter), read)
    }

    fn parameter_parts(&mut self, parameter: &mut ParameterStatement) -> Read<()> {
        if self.take(Symbol::Equals).is_none() {
            let wrong = words!("the parameter `{}` needs a default value", parameter.name.text);
            let diagnostic = Diagnostic::error("parameter-without-value", wrong, parameter.name.span);
            return self.fail(diagnostic.with_hint(words!("such as: parameter {} = 1", parameter.name.text)));
        }
        let start = self.span();
        let value = self.signed_number().map(|value| self.divided(value));
        parameter.value_span = start.to(self.last_span());
        if value.is_some() && *self.peek() == TokenKind::Symbol(Symbol::LeftParenthesis) && self.bare_unit().is_some() {
            return self.refuse_bare_unit(parameter.value_span);
        }
        let goes_on = matches!(
            self.peek(),
            TokenKind::Symbol(
                Symbol::Plus | Symbol::Minus | Symbol::Star | Symbol::Slash | Symbol::Caret | Symbol::LeftParenthesis
            ) | TokenKind::Raised(_)
        );
        let Some(value) = value.filter(|_| !goes_on) else {
            let place = if self.at_line_end() && self.span() == start { self.last_span() } else { start };
            let wrong = words!("the default of the parameter `{}` must be a number", parameter.name.text);
            let is_vector = *self.peek() == TokenKind::Symbol(Symbol::LeftParenthesis) && value.is_none();
            let hint = if is_vector {
                words!(
                    "a vector is defined from parameters that are numbers: {0} = ({0}_x, {0}_y)",
                    parameter.name.text
                )
            } else {
                words!("a value that is computed is a definition: {} = ...", parameter.name.text)
            };
            return self.fail(Diagnostic::error("parameter-value", wrong, place).with_hint(hint));
        };
        if let TokenKind::Name { .. } = self.peek()
            && !self.at_word("step")
            && !self.at_word("assigned")
        {
            return self.refuse_bare_unit(parameter.value_span);
        }
        if let TokenKind::Brackets(inside) = self.peek().clone() {
            let span = self.advance();
            let Ok(unit) = self.unit(inside) else {
                // Without its unit the value is meaningless.
                return self.parameter_limits(parameter);
            };
            parameter.unit = Some(StatedUnit { unit, span });
        }
        parameter.value = value;
        self.parameter_limits(parameter)
    }

    /// Reports `0.5 kg` and `0.5 foo`.
    fn refuse_bare_unit<T>(&mut self, number: Span) -> Read<T> {
        let unit = self.bare_unit().unwrap_or_else(|| self.bare_name());
        let diagnostic = unit.after(&self.source[number.range()]);
        self.fail(diagnostic)
    }

    /// Reports the range `from 0.1 to 2`.
    fn refuse_range_in_words(&mut self) -> Read<()> {
        let from = self.span();
        self.advance();
        let low = self.signed_number();
        let (end, to) = (self.last_span().end, self.span());
        let is_to = self.at_range_word();
        let wrong = words("a range is not written with words");
        let diagnostic = Diagnostic::error("parameter-range", wrong, from).with_hint(range_form());
        self.advance();
        let high = self.span();
        self.fail(if low.is_some() && is_to {
            let dots = Edit { span: Span::new(end, high.start.max(to.end)), text: "..".to_owned() };
            diagnostic.with_fixes(vec![Edit { span: from, text: "in".to_owned() }, dots])
        } else {
            diagnostic
        })
    }

    /// True at a word that separates the ends of a range in other languages.
    fn at_range_word(&self) -> bool {
        ["to", "until", "a", "hasta"].iter().any(|word| self.at_word(word))
    }

    fn parameter_limits(&mut self, parameter: &mut ParameterStatement) -> Read<()> {
        loop {
            let start = self.span();
            if parameter.range.is_none() && self.take_keyword(Keyword::In).is_some() {
                parameter.range = Some(self.bounds(start)?);
            } else if parameter.range.is_none() && ["from", "de", "desde"].iter().any(|word| self.at_word(word)) {
                return self.refuse_range_in_words();
            } else if parameter.assigned.is_none() && self.at_word("assigned") {
                self.advance();
                let bounds = self.bounds(start)?;
                let step = if self.at_word("step") { Some(self.step()?) } else { None };
                parameter.assigned = Some(AssignedRange { bounds, step, span: start.to(self.last_span()) });
            } else if parameter.step.is_none() && self.at_word("step") {
                parameter.step = Some(self.step()?);
            } else {
                return Ok(());
            }
        }
    }

    /// `step 0.002`
    fn step(&mut self) -> Read<f64> {
        let start = self.advance();
        let Some(step) = self.signed_number() else {
            let wrong = words!("after `step` a number is expected, not {found}", found = self.found());
            return self.fail(Diagnostic::error("parameter-step", wrong, start));
        };
        self.refuse_unit(&words("a step"))?;
        Ok(step)
    }

    /// Parses `0..30` after `in`.
    pub(in crate::parser) fn bounds(&mut self, keyword: Span) -> Read<Bounds> {
        let start = self.span();
        if let TokenKind::Brackets(_) = self.peek() {
            let wrong = words("after the `in` of a parameter its range is expected, not a unit");
            let hint = words("write the unit directly after the number, without `in`");
            return self.fail(Diagnostic::error("parameter-range", wrong, start).with_hint(hint));
        }
        let form = range_form();
        let Some(low) = self.signed_number() else {
            let wrong = words!(
                "after the `{word}` of a parameter its range is expected, not {found}",
                word = Words::same(self.source[keyword.range()].to_owned()),
                found = self.found()
            );
            return self.fail(Diagnostic::error("parameter-range", wrong, keyword).with_hint(form.clone()));
        };
        self.refuse_unit(&words("a range"))?;
        if self.take(Symbol::Dots).is_none() {
            if *self.peek() == TokenKind::Symbol(Symbol::Comma) && self.is_between_digits(self.span()) {
                return self.decimal_comma();
            }
            let wrong = words!("`..` is expected in this range, not {found}", found = self.found());
            let place = if self.at_line_end() { start.to(self.last_span()) } else { self.span() };
            let diagnostic = Diagnostic::error("parameter-range", wrong, place).with_hint(form.clone());
            let is_separator = self.at_range_word()
                || matches!(
                    self.peek(),
                    TokenKind::Symbol(Symbol::Minus | Symbol::Comma | Symbol::Colon | Symbol::Semicolon)
                );
            let meant = is_separator && matches!(self.peek_ahead(1), TokenKind::Number(_));
            return self.fail(if meant { diagnostic.with_fix(place, "..") } else { diagnostic });
        }
        let Some(high) = self.signed_number() else {
            let wrong = words("this range has no upper end");
            return self
                .fail(Diagnostic::error("parameter-range", wrong, start.to(self.last_span())).with_hint(form.clone()));
        };
        let span = start.to(self.last_span());
        self.refuse_unit(&words("a range"))?;
        Ok(Bounds { low, high, span })
    }

    fn refuse_unit(&mut self, what: &Words) -> Read<()> {
        let TokenKind::Brackets(_) = self.peek() else {
            return Ok(());
        };
        let wrong = words!("{what} is given in the parameter's own unit, without brackets");
        let place = self.span();
        self.say(Diagnostic::error("unit-in-range", wrong, place));
        self.advance();
        Ok(())
    }

    /// Parses a number with an optional sign. Returns `None` if there is no number; the sign is then consumed.
    pub(in crate::parser) fn signed_number(&mut self) -> Option<f64> {
        let negative = self.take(Symbol::Minus).is_some();
        if !negative {
            self.take(Symbol::Plus);
        }
        let TokenKind::Number(value) = *self.peek() else {
            return None;
        };
        self.advance();
        Some(if negative { -value } else { value })
    }

    /// Divides by the number after `/`, if there is one: `1/3`.
    fn divided(&mut self, value: f64) -> f64 {
        let TokenKind::Number(divisor) = *self.peek_ahead(1) else { return value };
        if divisor == 0.0 || self.take(Symbol::Slash).is_none() {
            return value;
        }
        self.advance();
        value / divisor
    }

    /// `independent x in [m]`
    pub(in crate::parser) fn independent(&mut self) -> Salvaged {
        let start = self.advance();
        let name = match self.plain_name(&words("the independent variable")) {
            Ok(name) => name,
            Err(reported) => return (nothing(start), Err(reported)),
        };
        let unit = self.stated_unit();
        let read = unit.as_ref().map(|_| ()).map_err(|reported| *reported);
        let unit = unit.unwrap_or(None);
        let counts = if read.is_ok() { self.counting(unit.as_ref()) } else { Ok(false) };
        let read = counts.as_ref().map(|_| ()).map_err(|reported| *reported);
        (StatementKind::Independent { name, unit, counts: counts.unwrap_or(false) }, read)
    }

    /// Parses assignments up to the end of the tokens.
    pub(in crate::parser) fn assignments(&mut self) -> Vec<Assignment> {
        let mut assignments = Vec::new();
        loop {
            self.skip_lines();
            if *self.peek() == TokenKind::End {
                return assignments;
            }
            self.depth = 0;
            let read = self.assignment(&mut assignments).and_then(|()| self.assignment_end());
            if read.is_err() {
                self.skip_rest(true);
                self.take(Symbol::Semicolon);
                self.take(Symbol::RightBrace);
            }
        }
    }

    fn assignment(&mut self, assignments: &mut Vec<Assignment>) -> Read<()> {
        let name = self.plain_name(&words("a parameter"))?;
        if self.take(Symbol::Equals).is_none() {
            let wrong = words!("`=` and a value are expected after `{}`", name.text);
            return self.fail(Diagnostic::error("missing-equals", wrong, name.span));
        }
        let read = self.expression();
        let value = match &read {
            Ok(_) => None,
            Err(_) => Some(unread(self.span())),
        };
        let outcome = read.as_ref().map(|_| ()).map_err(|reported| *reported);
        let value = value.or_else(|| read.ok().map(|tree| tree.expression)).unwrap_or_else(|| unread(name.span));
        let unit = outcome.and_then(|()| self.stated_unit());
        let outcome = unit.as_ref().map(|_| ()).map_err(|reported| *reported);
        assignments.push(Assignment { name, value, unit: unit.unwrap_or(None) });
        outcome
    }

    fn assignment_end(&mut self) -> Read<()> {
        let comma = *self.peek() == TokenKind::Symbol(Symbol::Comma);
        if comma && matches!(self.peek_ahead(1), TokenKind::Number(_)) {
            return self.decimal_comma();
        }
        let ended = comma && {
            self.advance();
            true
        } || self.take(Symbol::Semicolon).is_some()
            || self.at_line_end();
        if ended { Ok(()) } else { self.unexpected_after_expression() }
    }
}

/// Form of a range, for hints.
fn range_form() -> Words {
    words("a range is written LOW..HIGH, such as: in 0..30")
}
