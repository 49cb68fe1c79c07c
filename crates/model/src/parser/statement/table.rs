//! `table eta(T) in [mPa s] "Viscosity" { 273 [K] 1.792  293 1.002 }`: a function defined by points.

use super::{Salvaged, nothing};
use crate::lexer::{Symbol, TokenKind};
use crate::parser::cursor::{Cursor, Read, Told};
use crate::tables::too_many_points;
use crate::{Diagnostic, Point, StatedUnit, StatementKind, TableStatement, limits};
use program::Course;
use units::{Unit, Words, words};

const FORM: Words = words("the form is: table NAME(ARGUMENT) in [UNIT] { X [UNIT] Y  X Y ... }");

impl Cursor<'_> {
    /// True at `table NAME`, `smooth table NAME` or `steps table NAME`. The words are reserved only there.
    pub(in crate::parser) fn is_table(&self) -> bool {
        if self.begins_with("table") {
            return true;
        }
        let table = |kind: &TokenKind| matches!(kind, TokenKind::Name { text, order: 0, .. } if text == "table");
        (self.begins_with("smooth") || self.begins_with("steps"))
            && table(self.peek_ahead(1))
            && matches!(self.peek_ahead(2), TokenKind::Name { .. })
    }

    /// Parses a table. If `whole`, its points may be the rest of the text, without braces.
    pub(in crate::parser) fn table(&mut self, whole: bool) -> Salvaged {
        let course = match () {
            () if self.at_word("smooth") => Course::Smooth,
            () if self.at_word("steps") => Course::Steps,
            () => Course::Linear,
        };
        let mut start = self.advance();
        if course != Course::Linear {
            start = self.advance();
        }
        let name = match self.plain_name(&words("a table")) {
            Ok(name) => name,
            Err(reported) => return (nothing(start), Err(reported)),
        };
        let mut table = TableStatement {
            argument: name.clone(),
            name,
            course,
            label: None,
            argument_unit: None,
            unit: None,
            points: Vec::new(),
            drawn: None,
        };
        let read = self.table_parts(&mut table, whole);
        (StatementKind::Table(table), read)
    }

    fn table_parts(&mut self, table: &mut TableStatement, whole: bool) -> Read<()> {
        let Some(open) = self.take(Symbol::LeftParenthesis) else {
            let name = &table.name.text;
            let wrong =
                words!("the argument of the table `{name}` is expected here, not {found}", found = self.found());
            let place = if self.at_line_end() { table.name.span } else { self.span() };
            return self.fail(Diagnostic::error("table-form", wrong, place).with_hint(FORM));
        };
        table.argument = self.plain_name(&words("an argument"))?;
        if *self.peek() == TokenKind::Symbol(Symbol::Comma) {
            let wrong = words("a table has one argument");
            return self.fail(Diagnostic::error("table-form", wrong, self.span()).with_hint(FORM));
        }
        self.close(open)?;
        table.unit = self.stated_unit()?;
        table.label = self.label();
        if self.at_word("drawn") {
            table.drawn = Some(self.drawn(&mut table.argument_unit)?);
        }
        let brace = self.open_brace();
        if brace.is_none() && table.drawn.is_some() && !(whole && self.points_follow()) {
            return Ok(());
        }
        if brace.is_none() && !(whole && self.at_line_end()) {
            let expected = self.brace_expected("table-form", table.name.span);
            return self.fail(expected.with_hint(FORM));
        }
        loop {
            self.skip_separators();
            if *self.peek() == TokenKind::End {
                let Some(open) = brace else { return Ok(()) };
                let unclosed = words("this `{` is not closed");
                return self.fail(Diagnostic::error("unclosed-brace", unclosed, open).with_hint(FORM));
            }
            if brace.is_some() && self.take(Symbol::RightBrace).is_some() {
                return Ok(());
            }
            if let Err(Told) = self.point(table) {
                self.skip_table(brace.is_some());
                return Err(Told);
            }
        }
    }

    /// Skips the points of an unreadable table.
    fn skip_table(&mut self, in_braces: bool) {
        while *self.peek() != TokenKind::End {
            let closes = *self.peek() == TokenKind::Symbol(Symbol::RightBrace);
            self.advance();
            if closes && in_braces {
                return;
            }
        }
    }

    /// `273 [K] 1.792`
    fn point(&mut self, table: &mut TableStatement) -> Read<()> {
        let start = self.span();
        let x = self.table_number(&mut table.argument_unit, table.points.is_empty())?;
        if let TokenKind::Symbol(Symbol::Comma) = self.peek() {
            let wrong = words("the two numbers of a point are separated by a blank, not by a comma");
            let hint = words("points may be separated by commas, and numbers have a decimal point: `0 1.5, 2 3.5`");
            return self.fail(Diagnostic::error("table-comma", wrong, self.span()).with_hint(hint));
        }
        let missing = matches!(
            self.peek(),
            TokenKind::Newline | TokenKind::End | TokenKind::Symbol(Symbol::RightBrace | Symbol::Semicolon)
        );
        if missing {
            let argument = &table.argument.text;
            let wrong = words!("this {argument} has no value behind it");
            return self.fail(Diagnostic::error("table-form", wrong, start.to(self.last_span())).with_hint(FORM));
        }
        let y = self.table_number(&mut table.unit, table.points.is_empty())?;
        let span = start.to(self.last_span());
        if table.points.len() == limits::TABLE_POINTS {
            self.say(too_many_points(span));
            return Err(Told);
        }
        table.points.push(Point { x, y, span });
        Ok(())
    }

    /// Parses a number in the unit of its column. The first number of a column may state the unit of the whole column.
    pub(in crate::parser) fn table_number(&mut self, column: &mut Option<StatedUnit>, first: bool) -> Read<f64> {
        let start = self.span();
        let Some(value) = self.signed_number() else {
            let wrong = words!("a number is expected here, not {found}", found = self.found());
            return self.fail(Diagnostic::error("table-form", wrong, start).with_hint(FORM));
        };
        let TokenKind::Brackets(inside) = self.peek().clone() else {
            return Ok(value);
        };
        let span = self.advance();
        let unit = self.unit(inside)?;
        if first && column.is_none() {
            *column = Some(StatedUnit { unit: unit.clone(), span });
        }
        let expected = column.as_ref().map_or_else(Unit::dimensionless, |stated| stated.unit.clone());
        if unit.dimension != expected.dimension {
            let wrong = if column.is_none() {
                words("the first numbers of this column have no unit")
            } else {
                words!("[{unit}] is no unit for this column, whose numbers are in [{expected}]",)
            };
            let hint = words("the unit of a column stands behind its first number");
            return self.fail(Diagnostic::error("dimension-mismatch", wrong, span).with_hint(hint));
        }
        Ok(if unit == expected { value } else { expected.from_si(unit.to_si_of(value, &expected)) })
    }
}
