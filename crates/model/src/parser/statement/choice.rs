//! `choice liquid "Liquid" { "Water": rho = 998.2 [kg/m^3] }`: quantities that depend on a choice of the reader.

use super::{Salvaged, nothing};
use crate::lexer::{Symbol, TokenKind};
use crate::parser::cursor::{Cursor, Read, Told};
use crate::{Alternative, ChoiceStatement, ChosenValue, Diagnostic, Quoted, StatementKind};
use units::{Words, words};

const FORM: Words = words("the form is: choice NAME { \"TEXT\": NAME = EXPRESSION }");

impl Cursor<'_> {
    /// `choice liquid "Liquid" { "Water": rho = 998.2 [kg/m^3], eta = 1 [mPa s] }`
    pub(in crate::parser) fn choice(&mut self) -> Salvaged {
        let start = self.advance();
        let name = match self.plain_name(&words("a choice")) {
            Ok(name) => name,
            Err(reported) => return (nothing(start), Err(reported)),
        };
        let mut choice = ChoiceStatement { name, label: None, alternatives: Vec::new() };
        choice.label = self.label();
        let read = self.alternatives(&mut choice);
        (StatementKind::Choice(choice), read)
    }

    fn alternatives(&mut self, choice: &mut ChoiceStatement) -> Read<()> {
        let Some(open) = self.open_brace() else {
            let expected = self.brace_expected("choice-form", choice.name.span);
            return self.fail(expected.with_hint(FORM));
        };
        let mut wrong = false;
        loop {
            self.skip_separators();
            if let Some(end) = self.take(Symbol::RightBrace) {
                if choice.alternatives.is_empty() && !wrong {
                    let empty = words("there is nothing to choose from");
                    self.say(Diagnostic::error("choice-form", empty, open.to(end)).with_hint(FORM));
                }
                return Ok(());
            }
            if *self.peek() == TokenKind::End {
                let unclosed = words("this `{` is not closed");
                return self.fail(Diagnostic::error("unclosed-brace", unclosed, open).with_hint(FORM));
            }
            match self.alternative() {
                Ok(alternative) => choice.alternatives.push(alternative),
                Err(Told) => {
                    wrong = true;
                    self.skip_rest(true);
                }
            }
        }
    }

    pub(in crate::parser) fn skip_separators(&mut self) {
        while self.take(Symbol::Semicolon).is_some()
            || self.take(Symbol::Comma).is_some()
            || *self.peek() == TokenKind::Newline
        {
            self.skip_lines();
        }
    }

    /// `"Water": rho = 998.2 [kg/m^3], eta = 1 [mPa s]`
    fn alternative(&mut self) -> Read<Alternative> {
        let span = self.span();
        let TokenKind::Text(text) = self.peek().clone() else {
            let wrong = words!("the text of an alternative is expected here, not {found}", found = self.found());
            return self.fail(Diagnostic::error("choice-form", wrong, span).with_hint(FORM));
        };
        self.advance();
        if self.take(Symbol::Colon).is_none() {
            let wrong = words!("`:` is expected after the text of an alternative, not {found}", found = self.found());
            let place = if self.at_line_end() { span } else { self.span() };
            return self.fail(Diagnostic::error("choice-form", wrong, place).with_hint(FORM));
        }
        self.skip_lines();
        let mut values = Vec::new();
        loop {
            values.push(self.chosen_value()?);
            let goes_on = *self.peek() == TokenKind::Symbol(Symbol::Comma) && {
                self.advance();
                self.skip_lines();
                matches!(self.peek(), TokenKind::Name { .. })
            };
            if !goes_on {
                return Ok(Alternative { text: Quoted { text, span }, values });
            }
        }
    }

    /// `hidden rho = 998.2 [kg/m^3] "Density"`
    fn chosen_value(&mut self) -> Read<ChosenValue> {
        let hidden = self.begins_with("hidden");
        if hidden {
            self.advance();
        }
        let name = self.plain_name(&words("a quantity"))?;
        if self.take(Symbol::Equals).is_none() {
            let wrong = words!("`=` and a value are expected after `{}`", name.text);
            return self.fail(Diagnostic::error("missing-equals", wrong, name.span));
        }
        self.depth = 0;
        let value = self.expression()?.expression;
        let unit = self.stated_unit()?;
        let label = self.label();
        let separated = matches!(
            self.peek(),
            TokenKind::Newline
                | TokenKind::End
                | TokenKind::Symbol(Symbol::Semicolon | Symbol::Comma | Symbol::RightBrace)
        );
        if separated {
            Ok(ChosenValue { name, value, unit, label, hidden })
        } else {
            self.unexpected_after_expression()
        }
    }
}
