//! Statements that begin with a word of the language, and the assignments of presets.

use super::Assignment;
use super::cursor::{Cursor, Read, Told};
use super::statement::{Salvaged, nothing};
use super::unread;
use crate::lexer::{Keyword, Symbol, TokenKind};
use crate::{
    Action, Bounds, Diagnostic, EventExtras, ParameterForm, ParameterStatement, Span, StatedUnit, StatementKind,
};
use units::{Words, words};

const EVENT_FORM: Words =
    words("the form is: when CONDITION { y' = EXPRESSION }", "la forma es: when CONDICIÓN { y' = EXPRESIÓN }");

impl Cursor<'_> {
    /// `parameter b = 50 [kg/s] in 0..20000 step 1`
    pub(super) fn parameter(&mut self) -> Salvaged {
        let start = self.advance();
        let name = match self.plain_name(&words("a parameter", "un parámetro")) {
            Ok(name) => name,
            Err(reported) => return (nothing(start), Err(reported)),
        };
        let span = name.span;
        let mut parameter = ParameterStatement {
            name,
            value: f64::NAN,
            value_span: span,
            unit: None,
            range: None,
            step: None,
            form: ParameterForm::Number,
        };
        let read = self.parameter_parts(&mut parameter);
        (StatementKind::Parameter(parameter), read)
    }

    fn parameter_parts(&mut self, parameter: &mut ParameterStatement) -> Read<()> {
        if self.take(Symbol::Equals).is_none() {
            let wrong = words!(
                "the parameter `{}` needs a default value",
                "el parámetro `{}` necesita un valor predeterminado",
                parameter.name.text
            );
            let diagnostic = Diagnostic::error("parameter-without-value", wrong, parameter.name.span);
            return self.fail(diagnostic.with_hint(words!(
                "such as: parameter {} = 1",
                "por ejemplo: parameter {} = 1",
                parameter.name.text
            )));
        }
        let start = self.span();
        let value = self.signed_number();
        parameter.value_span = start.to(self.last_span());
        let goes_on = matches!(
            self.peek(),
            TokenKind::Symbol(
                Symbol::Plus | Symbol::Minus | Symbol::Star | Symbol::Slash | Symbol::Caret | Symbol::LeftParenthesis
            ) | TokenKind::Raised(_)
        );
        let Some(value) = value.filter(|_| !goes_on) else {
            let place = if self.at_line_end() && self.span() == start { self.last_span() } else { start };
            let wrong = words!(
                "the default of the parameter `{}` must be a number",
                "el valor predeterminado del parámetro `{}` debe ser un número",
                parameter.name.text
            );
            let hint = words!(
                "a value that is computed is a definition: {} = ...",
                "un valor que se calcula es una definición: {} = ...",
                parameter.name.text
            );
            return self.fail(Diagnostic::error("parameter-value", wrong, place).with_hint(hint));
        };
        if let TokenKind::Name { .. } = self.peek()
            && !self.at_word("step")
        {
            let place = self.span();
            let unit = &self.source[place.range()];
            let wrong = words!(
                "`{unit}` cannot stand directly after a number",
                "`{unit}` no puede ir justo después de un número"
            );
            let hint = words!(
                "a unit stands in brackets: {} [{unit}]",
                "una unidad va entre corchetes: {} [{unit}]",
                &self.source[parameter.value_span.range()]
            );
            return self.fail(Diagnostic::error("unit-without-brackets", wrong, place).with_hint(hint));
        }
        if let TokenKind::Brackets(inside) = self.peek().clone() {
            let span = self.advance();
            let Ok(unit) = self.unit(inside) else {
                // Without its unit the value means nothing.
                return self.parameter_limits(parameter);
            };
            parameter.unit = Some(StatedUnit { unit, span });
        }
        parameter.value = value;
        self.parameter_limits(parameter)
    }

    fn parameter_limits(&mut self, parameter: &mut ParameterStatement) -> Read<()> {
        loop {
            let start = self.span();
            if parameter.range.is_none() && self.take_keyword(Keyword::In).is_some() {
                parameter.range = Some(self.bounds(start)?);
            } else if parameter.step.is_none() && self.at_word("step") {
                self.advance();
                let Some(step) = self.signed_number() else {
                    let wrong = words!(
                        "after `step` a number is expected, not {found}",
                        "después de `step` se espera un número, no {found}",
                        found = self.found()
                    );
                    return self.fail(Diagnostic::error("parameter-step", wrong, start));
                };
                self.refuse_unit(&words("a step", "un paso"))?;
                parameter.step = Some(step);
            } else {
                return Ok(());
            }
        }
    }

    /// `0..30` after `in`.
    pub(super) fn bounds(&mut self, keyword: Span) -> Read<Bounds> {
        let start = self.span();
        if let TokenKind::Brackets(_) = self.peek() {
            let wrong = words(
                "after the `in` of a parameter its range is expected, not a unit",
                "después del `in` de un parámetro se espera su intervalo, no una unidad",
            );
            let hint = words(
                "write the unit directly after the number, without `in`",
                "escribe la unidad justo después del número, sin `in`",
            );
            return self.fail(Diagnostic::error("parameter-range", wrong, start).with_hint(hint));
        }
        let form = words(
            "a range is written LOW..HIGH, such as: in 0..30",
            "un intervalo se escribe MÍNIMO..MÁXIMO, por ejemplo: in 0..30",
        );
        let Some(low) = self.signed_number() else {
            let wrong = words!(
                "after the `in` of a parameter its range is expected, not {found}",
                "después del `in` de un parámetro se espera su intervalo, no {found}",
                found = self.found()
            );
            return self.fail(Diagnostic::error("parameter-range", wrong, keyword).with_hint(form.clone()));
        };
        self.refuse_unit(&words("a range", "un intervalo"))?;
        if self.take(Symbol::Dots).is_none() {
            let wrong = words!(
                "`..` is expected in this range, not {found}",
                "en este intervalo se espera `..`, no {found}",
                found = self.found()
            );
            let place = if self.at_line_end() { start.to(self.last_span()) } else { self.span() };
            return self.fail(Diagnostic::error("parameter-range", wrong, place).with_hint(form.clone()));
        }
        let Some(high) = self.signed_number() else {
            let wrong = words("this range has no upper end", "este intervalo no tiene extremo superior");
            return self
                .fail(Diagnostic::error("parameter-range", wrong, start.to(self.last_span())).with_hint(form.clone()));
        };
        let span = start.to(self.last_span());
        self.refuse_unit(&words("a range", "un intervalo"))?;
        Ok(Bounds { low, high, span })
    }

    fn refuse_unit(&mut self, what: &Words) -> Read<()> {
        let TokenKind::Brackets(_) = self.peek() else {
            return Ok(());
        };
        let wrong = words!(
            "{what} is given in the parameter's own unit, without brackets",
            "{what} se da en la unidad del propio parámetro, sin corchetes",
            what = what
        );
        let place = self.span();
        self.say(Diagnostic::error("unit-in-range", wrong, place));
        self.advance();
        Ok(())
    }

    /// A number with an optional sign. If there is none, at most the sign is read.
    pub(super) fn signed_number(&mut self) -> Option<f64> {
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

    /// `independent x in [m]`
    pub(super) fn independent(&mut self) -> Salvaged {
        let start = self.advance();
        let name = match self.plain_name(&words("the independent variable", "la variable independiente")) {
            Ok(name) => name,
            Err(reported) => return (nothing(start), Err(reported)),
        };
        let unit = self.stated_unit();
        let read = unit.as_ref().map(|_| ()).map_err(|reported| *reported);
        (StatementKind::Independent { name, unit: unit.unwrap_or(None) }, read)
    }

    /// `when y < 0 [m] { y' = -e*y' }`
    pub(super) fn event(&mut self) -> Salvaged {
        let start = self.advance();
        let condition = match self.expression() {
            Ok(tree) => tree.expression,
            Err(reported) => return (nothing(start), Err(reported)),
        };
        self.refuse_equals(words("condition", "una condición"));
        let (mut actions, mut extras) = (Vec::new(), EventExtras::default());
        let mut read = self.event_name(&mut extras);
        if matches!(self.peek(), TokenKind::Newline) && *self.peek_ahead(1) == TokenKind::Symbol(Symbol::LeftBrace) {
            self.skip_lines();
        }
        if read.is_ok() {
            read = self.actions(start, &mut actions, &mut extras);
        }
        (StatementKind::Event { condition, actions, extras }, read)
    }

    pub(super) fn actions(&mut self, start: Span, actions: &mut Vec<Action>, extras: &mut EventExtras) -> Read<()> {
        let Some(open) = self.take(Symbol::LeftBrace) else {
            let wrong =
                words!("`{{` is expected here, not {found}", "aquí se espera `{{`, no {found}", found = self.found());
            let place = if self.at_line_end() { self.last_span() } else { self.span() };
            let diagnostic = Diagnostic::error("missing-braces", wrong, place)
                .with_label(start, words("of this event", "de este evento"));
            return self.fail(diagnostic.with_hint(EVENT_FORM));
        };
        let mut wrong_actions = false;
        loop {
            while self.take(Symbol::Semicolon).is_some()
                || self.take(Symbol::Comma).is_some()
                || *self.peek() == TokenKind::Newline
            {
                self.skip_lines();
            }
            let unclosed = matches!(
                self.peek(),
                TokenKind::End | TokenKind::Keyword(Keyword::Parameter | Keyword::Independent | Keyword::When)
            );
            if unclosed {
                self.say(
                    Diagnostic::error("unclosed-brace", words("this `{` is not closed", "esta `{` no se cierra"), open)
                        .with_hint(EVENT_FORM),
                );
                self.back_to_line_end();
                return Ok(());
            }
            if let Some(end) = self.take(Symbol::RightBrace) {
                let nothing = actions.is_empty() && extras.stop.is_none() && extras.name.is_none();
                if nothing && !wrong_actions {
                    let wrong = words("this event changes nothing", "este evento no cambia nada");
                    let diagnostic = Diagnostic::error("empty-event", wrong, open.to(end));
                    self.say(diagnostic.with_hint(EVENT_FORM));
                }
                return Ok(());
            }
            if self.at_stop() {
                extras.stop = Some(self.advance());
                continue;
            }
            let read = if self.at_let() {
                self.advance();
                self.action().map(|action| extras.names.push(action))
            } else {
                self.action().map(|action| actions.push(action))
            };
            match read {
                Ok(()) => {}
                Err(Told) => {
                    wrong_actions = true;
                    self.skip_rest(true);
                }
            }
        }
    }

    fn action(&mut self) -> Read<Action> {
        let span = self.span();
        let TokenKind::Name { text, order, end } = self.peek().clone() else {
            let wrong = words!(
                "an action such as y' = 0 [m/s] is expected here, not {found}",
                "aquí se espera una acción como y' = 0 [m/s], no {found}",
                found = self.found()
            );
            return self.fail(Diagnostic::error("event-action", wrong, span));
        };
        self.advance();
        let mut order = order;
        let mut indices = Vec::new();
        if order == 0 && self.at_indices() {
            indices = self.indices()?.0;
            order = self.primes_here()?;
        }
        if self.take(Symbol::Equals).is_none() {
            let diagnostic = if *self.peek() == TokenKind::Symbol(Symbol::LeftParenthesis) {
                let wrong = words(
                    "an action sets the value at the event, not the one at the start",
                    "una acción fija el valor en el evento, no el inicial",
                );
                Diagnostic::error("event-action", wrong, span)
            } else {
                let wrong =
                    words!("`=` is expected here, not {found}", "aquí se espera `=`, no {found}", found = self.found());
                let place = if self.at_line_end() { span } else { self.span() };
                Diagnostic::error("event-action", wrong, place)
            };
            return self.fail(diagnostic.with_hint(EVENT_FORM));
        }
        let value = self.expression()?.expression;
        let over = self.over()?;
        let separated = matches!(
            self.peek(),
            TokenKind::Newline
                | TokenKind::End
                | TokenKind::Symbol(Symbol::Semicolon | Symbol::Comma | Symbol::RightBrace)
        );
        if !separated {
            return self.unexpected_after_expression();
        }
        let name = crate::Name { text, span: Span::new(span.start, end) };
        Ok(Action { name, indices, order, value, over })
    }

    /// Assignments up to the end.
    pub(super) fn assignments(&mut self) -> Vec<Assignment> {
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
        let name = self.plain_name(&words("a parameter", "un parámetro"))?;
        if self.take(Symbol::Equals).is_none() {
            let wrong = words!(
                "`=` and a value are expected after `{}`",
                "después de `{}` se esperan `=` y un valor",
                name.text
            );
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
