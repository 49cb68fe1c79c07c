//! `switch drag = on "With drag"`: a parameter that is on or off.

use super::Salvaged;
use crate::lexer::{Symbol, TokenKind};
use crate::parser::cursor::{Cursor, Read};
use crate::{Diagnostic, ParameterForm, ParameterStatement};
use units::words;

impl Cursor<'_> {
    /// `switch drag = on`
    pub(in crate::parser) fn switch(&mut self) -> Salvaged {
        self.valued(&words("a switch"), ParameterForm::Switch, Self::on_or_off)
    }

    fn on_or_off(&mut self, switch: &mut ParameterStatement) -> Read<()> {
        let equals = self.take(Symbol::Equals).is_some();
        let value = match self.peek() {
            TokenKind::Name { text, order: 0, .. } if equals => match text.as_str() {
                "on" | "true" => Some(1.0),
                "off" | "false" => Some(0.0),
                _ => None,
            },
            _ => None,
        };
        let Some(value) = value else {
            let name = &switch.name.text;
            let wrong = words!("the switch `{name}` is `on` or `off` at the start");
            let place = if self.at_line_end() || !equals { switch.name.span } else { self.span() };
            let hint = words!("such as: `switch {name} = on`");
            return self.fail(Diagnostic::error("switch-value", wrong, place).with_hint(hint));
        };
        switch.value = value;
        switch.value_span = self.advance();
        Ok(())
    }
}
