//! Equations of the model in textbook notation: MathML Core from the syntax tree.

mod cases;
mod expression;
mod family;
mod map;
mod table;
#[cfg(test)]
mod tests;
mod vectors;

use crate::choices::definitions;
use crate::vectors::Vectors;
use crate::{Action, EventExtras, Expression, ExpressionKind, Members, Over, Statement, StatementKind};
use expression::{Typesetter, at_start_of_run};
use units::markup::escaped;

/// Each displayed statement as a `<math display="block">` element, in text order: definitions, equations, initial values
/// and events. Parameters are shown as controls, not here. `translate` translates text values (`"underdamped"`).
pub fn typeset(statements: &[Statement], translate: &dyn Fn(&str) -> String) -> Vec<String> {
    typeset_each(statements, translate).concat()
}

/// The elements of each statement; none for a statement that is unreadable or not displayed.
pub fn typeset_each(statements: &[Statement], translate: &dyn Fn(&str) -> String) -> Vec<Vec<String>> {
    let vectors = Vectors::of(statements);
    let typesetter = Typesetter { translate, vectors: &vectors };
    map::with_counts(statements).iter().map(|statement| typesetter.rows(statement)).collect()
}

/// The elements of the statement with index `number`, in the context of its model.
pub fn typeset_one(statements: &[Statement], number: usize) -> Vec<String> {
    let vectors = Vectors::of(statements);
    let typesetter = Typesetter { translate: &str::to_owned, vectors: &vectors };
    map::with_counts(statements).get(number).map_or_else(Vec::new, |statement| typesetter.rows(statement))
}

/// An expression as an inline `<math>` element.
pub fn typeset_expression(expression: &Expression) -> String {
    let typesetter = Typesetter { translate: &str::to_owned, vectors: &Vectors::default() };
    format!("<math>{}</math>", typesetter.expression(expression))
}

impl Typesetter<'_> {
    fn rows(&self, statement: &Statement) -> Vec<String> {
        match &statement.kind {
            StatementKind::Equation { left, right }
                if [left, right].iter().all(|side| side.kind == ExpressionKind::Error) =>
            {
                Vec::new()
            }
            StatementKind::Choice(choice) => {
                definitions(choice).filter_map(|definition| self.kind(&definition.kind, &[])).collect()
            }
            kind => self.kind(kind, &statement.over).into_iter().collect(),
        }
    }

    fn kind(&self, kind: &StatementKind, over: &[Over]) -> Option<String> {
        let equals = |left: String, right: &Expression| format!("{left}<mo>=</mo>{}", self.expression(right));
        let row = match kind {
            StatementKind::Parameter(_)
            | StatementKind::Choice(_)
            | StatementKind::Size(_)
            | StatementKind::Group(_)
            | StatementKind::Independent { .. } => return None,
            StatementKind::Table(table) => self.table(table),
            StatementKind::Definition { name, value, .. } => equals(self.name(&name.text, 0, None), value),
            StatementKind::InitialValue { name, order, value, .. } => {
                equals(at_start_of_run(&self.name(&name.text, *order, None)), value)
            }
            StatementKind::Function(function) => {
                equals(self.declared(&function.name, &function.parameters), &function.body)
            }
            StatementKind::Discrete { name, value, .. } => {
                equals(at_start_of_run(&self.name(&name.text, 0, None)), value)
            }
            StatementKind::Equation { left, right } => equals(self.expression(left), right),
            StatementKind::Members { what, left, value, .. } => match (&left.kind, what) {
                (ExpressionKind::Member { name, indices, .. }, Members::Discrete) => {
                    equals(at_start_of_run(&self.member(name, indices, 0)), value)
                }
                _ => equals(self.expression(left), value),
            },
            StatementKind::Event { actions, extras: EventExtras { next: true, .. }, .. } => self.next(actions.first()?),
            StatementKind::Event { condition, actions, extras } => {
                let named = |action: &Action| equals(self.name(&action.name.text, 0, None), &action.value);
                let mut actions: Vec<String> =
                    extras.names.iter().map(named).chain(actions.iter().map(|action| self.action(action))).collect();
                actions.extend(extras.stop.map(|_| "<mtext>stop</mtext>".to_owned()));
                let condition = match (extras.every.as_deref(), &extras.button) {
                    (Some((interval, from)), _) => self.moments(interval, from.as_ref()),
                    (None, Some(title)) => format!("<mtext>{}</mtext>", escaped(&(self.translate)(&title.text))),
                    (None, None) => self.expression(condition),
                };
                format!("{condition}<mo>⟹</mo>{}", actions.join("<mo separator=\"true\">,</mo>"))
            }
        };
        let over = self.for_all(over);
        Some(format!("<math display=\"block\"><mrow>{row}{over}</mrow></math>"))
    }

    /// Times of a periodic event: t = from + n interval.
    fn moments(&self, interval: &Expression, from: Option<&Expression>) -> String {
        let from = from.map(|from| format!("{}<mo>+</mo>", self.expression(from))).unwrap_or_default();
        format!("<mi>t</mi><mo>=</mo>{from}<mi>n</mi><mo>·</mo>{}", self.expression(interval))
    }

    /// An assignment of the value after an event.
    fn action(&self, action: &Action) -> String {
        let target = match action.component {
            None => self.member(&action.name.text, &action.indices, action.order),
            Some(axis) => self.component(&action.name.text, &action.indices, axis, action.order, None),
        };
        let (value, over) = (self.expression(&action.value), self.for_all(&action.over));
        format!("<mrow>{target}<mo>←</mo>{value}{over}</mrow>")
    }
}
