//! Expands vectors in statements.

use super::expressions::{Value, Writer, zero};
use super::faults;
use super::known::{CROSS, DOT, NORM, Vectors};
use crate::components::{AXES, component_name, split_component};
use crate::names::for_each;
use crate::{
    Action, Diagnostic, Expression, ExpressionKind, FunctionStatement, Name, Quoted, StatedUnit, Statement,
    StatementKind, limits,
};
use program::functions::Function;
use units::words;

pub(super) fn write_out(
    vectors: &Vectors,
    statements: &[Statement],
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Statement> {
    let mut writer = Writer::new(vectors);
    let mut written = Vec::with_capacity(statements.len());
    for statement in statements {
        writer.taken(statement);
        let label = statement.label.as_ref();
        for (axis, kind) in writer.kinds(&statement.kind) {
            let label = label.map(|label| axis.map_or_else(|| label.clone(), |axis| of_component(label, axis)));
            written.push(Statement { label, ..Statement::of(kind, statement.span) });
        }
        if written.len() > limits::STATEMENTS {
            let message = words("with its vectors written out in components, the model is too large");
            writer.refuse(Diagnostic::error("model-too-large", message, statement.span));
            break;
        }
    }
    diagnostics.extend(writer.finish());
    written
}

/// Label of a component: `Position x`, `Position x (au)`.
fn of_component(label: &Quoted, axis: usize) -> Quoted {
    let name = AXES.get(axis).copied().unwrap_or_default();
    let (text, rest) = match label.text.strip_suffix(')').and_then(|text| text.rfind(" (")) {
        Some(at) => label.text.split_at(at),
        None => (label.text.as_str(), ""),
    };
    Quoted { text: format!("{text} {name}{rest}"), span: label.span }
}

/// Expanded statements: one per component, with its axis; `None` as the axis of a number.
type Kinds = Vec<(Option<usize>, StatementKind)>;

impl Writer<'_> {
    fn kinds(&mut self, kind: &StatementKind) -> Kinds {
        let one = |kind| vec![(None, kind)];
        match kind {
            StatementKind::Definition { name, value, unit } => {
                if let Some((vector, _)) = split_component(&name.text)
                    && let Some(dimension) = self.vectors.dimension(vector)
                {
                    self.refuse(faults::component_defined(&name.text, vector, dimension, name.span));
                    return Vec::new();
                }
                let of = |name, value, unit| StatementKind::Definition { name, value, unit };
                self.assigned(name, value, unit.as_ref(), of)
            }
            StatementKind::InitialValue { name, order, value, unit } => {
                let of = |name, value, unit| StatementKind::InitialValue { name, order: *order, value, unit };
                self.assigned(name, value, unit.as_ref(), of)
            }
            StatementKind::Discrete { name, value, unit, .. } => {
                self.assigned(name, value, unit.as_ref(), StatementKind::discrete)
            }
            StatementKind::Equation { left, right } => self.equation(left, right),
            StatementKind::Choice(choice) => {
                let mut choice = choice.clone();
                for alternative in &mut choice.alternatives {
                    let values = std::mem::take(&mut alternative.values);
                    for one in values {
                        let parts = self.parts(&one.name, &one.value);
                        let (unit, label, hidden) = (one.unit, one.label, one.hidden);
                        alternative.values.extend(parts.into_iter().map(|(_, name, value)| crate::ChosenValue {
                            name,
                            value,
                            unit: unit.clone(),
                            label: label.clone(),
                            hidden,
                        }));
                    }
                }
                one(StatementKind::Choice(choice))
            }
            StatementKind::Event { condition, actions, extras } => {
                let condition = if extras.every.is_some() { condition.clone() } else { self.number(condition) };
                let (actions, names) = (self.actions(actions), self.actions(&extras.names));
                let every = extras
                    .every
                    .as_ref()
                    .map(|every| Box::new((self.number(&every.0), every.1.as_ref().map(|from| self.number(from)))));
                let extras = crate::EventExtras { names, every, ..extras.clone() };
                one(StatementKind::Event { condition, actions, extras })
            }
            StatementKind::Function(function) => one(StatementKind::Function(self.function(function))),
            StatementKind::Parameter(_)
            | StatementKind::Size(_)
            | StatementKind::Table(_)
            | StatementKind::Group(_)
            | StatementKind::Independent { .. }
            | StatementKind::Members { .. } => one(kind.clone()),
        }
    }

    /// Assignments to a name: one per component of a vector, with its own value.
    fn parts(&mut self, name: &Name, value: &Expression) -> Vec<(Option<usize>, Name, Expression)> {
        let Some(dimension) = self.vectors.dimension(&name.text) else {
            if let Some((vector, member)) = name.text.rsplit_once('.')
                && let Some(dimension) = self.vectors.dimension(vector)
                && split_component(&name.text).is_none_or(|(_, axis)| axis >= dimension)
            {
                self.refuse(faults::no_component(vector, member, dimension, name.span));
            }
            return vec![(None, name.clone(), self.number(value))];
        };
        let mut found = self.value(value);
        if found.is_zero() {
            found = zero(dimension, value.span);
        }
        match found {
            Value::Vector(parts) if parts.len() == dimension => {
                let parts = self.components(Value::Vector(parts));
                let named = |(axis, value)| {
                    (Some(axis), Name { text: component_name(&name.text, axis), span: name.span }, value)
                };
                parts.into_iter().enumerate().map(named).collect()
            }
            Value::Vector(parts) => {
                let own = Expression::named(&name.text, name.span);
                self.refuse(faults::different_dimensions((&own, dimension), (value, parts.len())));
                Vec::new()
            }
            Value::Number(_) => {
                self.refuse(faults::number_for_vector(&name.text, dimension, value));
                Vec::new()
            }
            Value::Unknown => Vec::new(),
        }
    }

    fn assigned(
        &mut self,
        name: &Name,
        value: &Expression,
        unit: Option<&StatedUnit>,
        of: impl Fn(Name, Expression, Option<StatedUnit>) -> StatementKind,
    ) -> Kinds {
        let parts = self.parts(name, value);
        parts.into_iter().map(|(axis, name, value)| (axis, of(name, value, unit.cloned()))).collect()
    }

    fn equation(&mut self, left: &Expression, right: &Expression) -> Kinds {
        let (one, two) = (self.value(left), self.value(right));
        let Some((one, two)) = self.alike((left, one), (right, two)) else { return Vec::new() };
        let is_vector = matches!(one, Value::Vector(_));
        let (one, two) = (self.components(one), self.components(two));
        let sides = one.into_iter().zip(two).enumerate();
        sides
            .map(|(axis, (left, right))| (is_vector.then_some(axis), StatementKind::Equation { left, right }))
            .collect()
    }

    fn actions(&mut self, actions: &[Action]) -> Vec<Action> {
        let mut written = Vec::with_capacity(actions.len());
        for action in actions {
            let parts = self.parts(&action.name, &action.value);
            written.extend(parts.into_iter().map(|(_, name, value)| Action::of(name, action.order, value)));
        }
        written
    }

    /// Calls of functions were expanded before. A function with vectors has no further use.
    fn function(&self, function: &FunctionStatement) -> FunctionStatement {
        let mut vectors = false;
        for_each(&function.body, |part| {
            vectors |= match &part.kind {
                ExpressionKind::Tuple { .. } | ExpressionKind::Component { .. } => true,
                ExpressionKind::Call { function, .. } => [NORM, DOT, CROSS].contains(&function.text.as_str()),
                ExpressionKind::Name { name, .. }
                | ExpressionKind::InitialValue { name, .. }
                | ExpressionKind::Member { name, .. } => {
                    let own = |vector: &str| function.parameters.iter().any(|parameter| parameter.text == vector);
                    self.vectors.dimension(name).is_some()
                        || split_component(name)
                            .is_some_and(|(vector, _)| own(vector) || self.vectors.dimension(vector).is_some())
                }
                _ => false,
            };
        });
        let mut function = function.clone();
        if vectors {
            function.body.kind = ExpressionKind::Number { value: 0.0, unit: None };
        }
        function
    }

    /// Reports other things with the name of a vector.
    fn taken(&mut self, statement: &Statement) {
        let reserved = |name: &Name| Function::reserving(&name.text).is_some() || name.text == "pi";
        let (name, other): (&Name, _) = match &statement.kind {
            StatementKind::Parameter(parameter) => (&parameter.name, words("a parameter")),
            StatementKind::Independent { name, .. } => (name, words("the independent variable")),
            StatementKind::Function(function) => (&function.name, words("a function")),
            StatementKind::Choice(choice) => (&choice.name, words("a choice")),
            StatementKind::Event { extras, .. } => match &extras.name {
                Some(name) => (name, words("an event")),
                None => return,
            },
            StatementKind::Definition { name, .. }
            | StatementKind::InitialValue { name, .. }
            | StatementKind::Discrete { name, .. }
                if reserved(name) =>
            {
                (name, words("reserved"))
            }
            _ => return,
        };
        if self.vectors.dimension(&name.text).is_some() {
            self.refuse(faults::taken(&name.text, &other, name.span));
        }
    }
}
