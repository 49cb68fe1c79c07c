//! `function Re(v, d) = rho*abs(v)*d/eta`: a user-defined function.

use super::{Salvaged, nothing};
use crate::lexer::{Symbol, TokenKind};
use crate::parser::cursor::{Cursor, Read};
use crate::parser::unread;
use crate::{Diagnostic, FunctionStatement, StatementKind};
use units::words;

impl Cursor<'_> {
    /// `function Re(v, d) = rho*abs(v)*d/eta in [1]`
    pub(in crate::parser) fn function(&mut self) -> Salvaged {
        let start = self.advance();
        let name = match self.plain_name(&words("a function")) {
            Ok(name) => name,
            Err(reported) => return (nothing(start), Err(reported)),
        };
        let body = unread(name.span.after());
        let mut function = FunctionStatement { name, parameters: Vec::new(), body, unit: None };
        let read = self.function_parts(&mut function);
        (StatementKind::Function(function), read)
    }

    fn function_parts(&mut self, function: &mut FunctionStatement) -> Read<()> {
        let name = function.name.text.clone();
        let form = words!("the form is: function {name}(x) = ...");
        let Some(open) = self.take(Symbol::LeftParenthesis) else {
            let wrong =
                words!("the arguments of the function `{name}` are expected here, not {found}", found = self.found());
            let place = if self.at_line_end() { function.name.span } else { self.span() };
            return self.fail(Diagnostic::error("function-form", wrong, place).with_hint(form));
        };
        if *self.peek() == TokenKind::Symbol(Symbol::RightParenthesis) {
            let wrong = words!("the function `{name}` has no argument");
            let hint = words!("what depends on nothing else is a definition: `{name} = ...`");
            return self.fail(Diagnostic::error("function-form", wrong, open.to(self.span())).with_hint(hint));
        }
        let mut separators = Vec::new();
        loop {
            function.parameters.push(self.plain_name(&words("an argument"))?);
            let separator = self.take(Symbol::Comma).or_else(|| self.take(Symbol::Semicolon));
            let Some(separator) = separator else { break };
            separators.push(separator);
        }
        let end = self.close(open)?;
        self.check_separators(&function.name, &separators, end);
        if self.take(Symbol::Equals).is_none() {
            let wrong = words!("`=` is expected after the arguments of `{name}`, not {found}", found = self.found());
            let place = if self.at_line_end() { function.name.span } else { self.span() };
            return self.fail(Diagnostic::error("function-form", wrong, place).with_hint(form));
        }
        function.body = self.expression()?.expression;
        function.unit = self.stated_unit()?;
        Ok(())
    }
}
