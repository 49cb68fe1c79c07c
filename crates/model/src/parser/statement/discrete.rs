//! `discrete n = 0`: a quantity that only events change.

use super::{Salvaged, nothing};
use crate::lexer::Symbol;
use crate::parser::cursor::{Cursor, Read};
use crate::parser::unread;
use crate::{Diagnostic, Expression, Members, Name, StatedUnit, StatementKind};
use units::words;

impl Cursor<'_> {
    /// `discrete n = 0 in [cm]`
    pub(in crate::parser) fn discrete(&mut self) -> Salvaged {
        let start = self.advance();
        let name = match self.plain_name(&words("a discrete quantity")) {
            Ok(name) => name,
            Err(reported) => return (nothing(start), Err(reported)),
        };
        if self.at_indices() {
            let (left, value) = (unread(name.span), unread(name.span.after()));
            let mut members = (left, value, None);
            let read = self.discrete_members(name, &mut members);
            let (left, value, unit) = members;
            return (StatementKind::Members { what: Members::Discrete, left, value, unit }, read);
        }
        let mut value = unread(name.span.after());
        let mut unit = None;
        let read = self.value_at_the_start(&name, &mut value, &mut unit);
        (StatementKind::discrete(name, value, unit), read)
    }

    fn discrete_members(
        &mut self,
        name: Name,
        (left, value, unit): &mut (Expression, Expression, Option<StatedUnit>),
    ) -> Read<()> {
        *left = self.member(name.clone())?.expression;
        self.value_at_the_start(&name, value, unit)
    }

    fn value_at_the_start(&mut self, name: &Name, value: &mut Expression, unit: &mut Option<StatedUnit>) -> Read<()> {
        if self.take(Symbol::Equals).is_none() {
            let wrong = words!("the discrete quantity `{}` needs a value at the start", name.text);
            let diagnostic = Diagnostic::error("discrete-without-value", wrong, name.span);
            return self.fail(diagnostic.with_hint(words!("such as: discrete {} = 0", name.text)));
        }
        *value = self.expression()?.expression;
        *unit = self.stated_unit()?;
        Ok(())
    }
}
