//! Values remembered by events. After `when y < 0 [m] as landing { ... }`, `landing.x` is x just before the last landing.
//! `landing.time` is the time of the last landing, `.count` the number of landings, `.interval` the time since the one
//! before.
//!
//! All of it becomes ordinary statements. A remembered value is a discrete quantity that the event sets: `landing.x.`, with
//! a point at its end. `landing.x` is a definition that has no value before the first landing. `let u = e*y'` inside an
//! event becomes the definition `let.u`.

use crate::components::AXES;
use crate::names::for_each;
use crate::syntax::{expressions, expressions_mut, independent, rewrite};
use crate::vectors::Vectors;
use crate::{
    Action, BinaryOperator, Diagnostic, EventExtras, Expression, ExpressionKind, Name, Span, Statement, StatementKind,
};
use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use units::words;

/// Number of firings of the event.
const COUNT: &str = "count";
/// Time of the last firing.
const TIME: &str = "time";
/// Time between the last two firings.
const INTERVAL: &str = "interval";

/// True if the compiler has added the state. Such names cannot occur in source text.
pub(crate) fn is_hidden(name: &str) -> bool {
    name.ends_with('.') || name.contains(' ')
}

/// Replaces everything that events remember by ordinary statements.
pub(crate) fn write_out<'a>(
    statements: Cow<'a, [Statement]>,
    vectors: &Vectors,
    diagnostics: &mut Vec<Diagnostic>,
) -> Cow<'a, [Statement]> {
    let uses_any = statements.iter().any(|statement| match &statement.kind {
        StatementKind::Event { extras, .. } => extras.name.is_some() || !extras.names.is_empty(),
        _ => false,
    });
    let mut mentions = Mentions { vectors, found: Vec::new() };
    statements.iter().for_each(|statement| expressions(statement).into_iter().for_each(|one| mentions.note(one)));
    if !uses_any && mentions.found.is_empty() {
        return statements;
    }
    let events = event_names(&statements, diagnostics);
    mentions.refuse_unknown(&events, diagnostics);
    let mut writer =
        Writer { declared: declared(&statements), independent: independent(&statements), added: Vec::new() };
    let mut number = 0;
    let mut written: Vec<Statement> = Vec::new();
    for statement in statements.iter() {
        let mut statement = statement.clone();
        let span = statement.span;
        if let StatementKind::Event { actions, extras, .. } = &mut statement.kind {
            number += 1;
            writer.names(number, actions, extras, diagnostics);
            if let Some(name) = &extras.name
                && events.get(name.text.as_str()) == Some(&name.span)
            {
                let wanted = mentions.of(&name.text);
                writer.remember(name, &wanted, actions, span);
            }
        }
        expressions_mut(&mut statement).into_iter().for_each(|one| mentions.primes_into_names(one));
        written.push(statement);
    }
    for statement in &mut writer.added {
        expressions_mut(statement).into_iter().for_each(|one| mentions.primes_into_names(one));
    }
    written.append(&mut writer.added);
    Cow::Owned(written)
}

/// Names of events with their places. Reports a name that is given twice.
fn event_names<'a>(statements: &'a [Statement], diagnostics: &mut Vec<Diagnostic>) -> HashMap<&'a str, Span> {
    let mut events: HashMap<&str, Span> = HashMap::new();
    for statement in statements {
        let StatementKind::Event { extras: EventExtras { name: Some(name), .. }, .. } = &statement.kind else {
            continue;
        };
        if let Some(&first) = events.get(name.text.as_str()) {
            let message = words!("two events are called `{}`", name.text);
            diagnostics.push(
                Diagnostic::error("duplicate-name", message, name.span).with_label(first, words("the first is here")),
            );
        } else {
            events.insert(&name.text, name.span);
        }
    }
    events
}

/// Names that the model declares.
fn declared(statements: &[Statement]) -> HashSet<String> {
    let name = |statement: &Statement| match &statement.kind {
        StatementKind::Parameter(parameter) => Some(parameter.name.text.clone()),
        StatementKind::Definition { name, .. }
        | StatementKind::InitialValue { name, .. }
        | StatementKind::Discrete { name, .. }
        | StatementKind::Independent { name, .. } => Some(name.text.clone()),
        _ => None,
    };
    statements.iter().filter_map(name).collect()
}

/// Uses of values that events remember.
#[derive(Debug)]
struct Mentions<'a> {
    /// Needed because `r.x` can be a component of a vector.
    vectors: &'a Vectors,
    /// Event, member, derivative order, and first place of use.
    found: Vec<(String, String, u32, Span)>,
}

impl Mentions<'_> {
    fn note(&mut self, expression: &Expression) {
        for_each(expression, |part| {
            if let ExpressionKind::Name { name, order } = &part.kind
                && !name.contains(['(', ' '])
                && !self.vectors.is_component(name)
                && let Some((event, member)) = name.split_once('.')
                && !self.found.iter().any(|(e, m, o, _)| e == event && m == member && o == order)
            {
                self.found.push((event.to_owned(), member.to_owned(), *order, part.span));
            }
        });
    }

    fn refuse_unknown(&self, events: &HashMap<&str, Span>, diagnostics: &mut Vec<Diagnostic>) {
        for (event, member, _, span) in self.found.iter().filter(|(event, ..)| !events.contains_key(event.as_str())) {
            let message = words!("there is no event `{event}`");
            let diagnostic = Diagnostic::error("unknown-name", message, *span)
                .with_hint(words!("name it: when ... as {event} {{ ... }}"));
            diagnostics.push(if AXES.contains(&member.as_str()) {
                diagnostic.with_hint(words!(
                    "or, if it is a vector, give it a value as a whole: {event} = (..., ...) or {event}(0) = (..., ...)"
                ))
            } else {
                diagnostic
            });
        }
    }

    /// Members used of one event, without count, time and interval.
    fn of(&self, event: &str) -> Vec<(&str, u32, Span)> {
        let common = |member: &str| [COUNT, TIME, INTERVAL].contains(&member);
        let own = self.found.iter().filter(|(of, member, ..)| of == event && !common(member));
        own.map(|(_, member, order, span)| (member.as_str(), *order, *span)).collect()
    }

    /// Moves primes into the name: `landing.y'` is the remembered value of y', not a derivative.
    fn primes_into_names(&self, expression: &mut Expression) {
        rewrite(expression, &mut |part| {
            if let ExpressionKind::Name { name, order } = &mut part.kind
                && name.contains('.')
                && !name.ends_with('.')
                && !name.contains(['(', ' '])
                && !self.vectors.is_component(name)
            {
                name.extend(std::iter::repeat_n('\'', std::mem::take(order) as usize));
            }
        });
    }
}

/// Collects the generated statements.
#[derive(Debug)]
struct Writer {
    declared: HashSet<String>,
    independent: String,
    added: Vec<Statement>,
}

impl Writer {
    /// Replaces the `let` names of the event with this number by definitions.
    fn names(
        &mut self,
        number: usize,
        actions: &mut [Action],
        extras: &mut EventExtras,
        diagnostics: &mut Vec<Diagnostic>,
    ) {
        if extras.names.is_empty() {
            return;
        }
        let event = match &extras.name {
            Some(name) => format!("{}.let", name.text),
            None if number == 1 => "let".to_owned(),
            None => format!("let{number}"),
        };
        let mut names = std::mem::take(&mut extras.names);
        let own: HashMap<String, String> =
            names.iter().map(|one| (one.name.text.clone(), format!("{event}.{}", one.name.text))).collect();
        for name in &names {
            if name.order > 0 || self.declared.contains(&name.name.text) || name.name.text == self.independent {
                let message = words!("`{}` has a meaning already, and `let` names something new", name.name.text);
                diagnostics.push(Diagnostic::error("let-of-known-name", message, name.name.span).with_hint(words!(
                    "without `let` it sets what there is; or choose another name, such as `{}_1`",
                    name.name.text
                )));
            }
        }
        let mut rename = |part: &mut Expression| {
            if let ExpressionKind::Name { name, order: 0 } = &mut part.kind
                && let Some(inside) = own.get(name)
            {
                name.clone_from(inside);
            }
        };
        actions.iter_mut().for_each(|action| rewrite(&mut action.value, &mut rename));
        names.iter_mut().for_each(|name| rewrite(&mut name.value, &mut rename));
        for Action { name, value, .. } in names {
            let text = own.get(&name.text).cloned().unwrap_or_default();
            self.define(Name { text, span: name.span }, value);
        }
    }

    /// Makes an event remember the quantities `wanted`, and its count, time and interval.
    fn remember(&mut self, event: &Name, wanted: &[(&str, u32, Span)], actions: &mut Vec<Action>, span: Span) {
        let at = event.span;
        let kept = |member: &str| format!("{}.{member}.", event.text);
        let value_kept = |member: &str| Expression::named(&kept(member), at);
        let time = || Expression::named(&self.independent, at);
        let one = Expression::number(1.0, at);
        let counted = Expression::binary(BinaryOperator::Add, value_kept(COUNT), one, at);
        let interval = Expression::binary(BinaryOperator::Subtract, time(), value_kept(TIME), at);
        let mut all = vec![
            (COUNT.to_owned(), counted, None, at),
            (TIME.to_owned(), time(), Some(0.0), at),
            (INTERVAL.to_owned(), interval, Some(1.0), at),
        ];
        for &(member, order, span) in wanted {
            let primes = "'".repeat(order as usize);
            all.push((format!("{member}{primes}"), Expression::derivative(member, order, span), Some(0.0), span));
        }
        for (member, value, beyond, place) in all {
            let state = Name { text: kept(&member), span: place };
            actions.push(Action::of(state.clone(), 0, value));
            let mut value = value_kept(&member);
            if let Some(count) = beyond {
                // No value until the event has fired more than `count` times.
                let count = Expression::number(count, at);
                let condition = Expression::binary(BinaryOperator::Greater, value_kept(COUNT), count, at);
                value = Expression::conditional(condition, value, Expression::nothing(place), place);
            }
            self.define(Name { text: format!("{}.{member}", event.text), span: place }, value);
            let kind = StatementKind::discrete(state, Expression::number(0.0, place), None);
            self.added.push(Statement::of(kind, span));
        }
    }

    fn define(&mut self, name: Name, value: Expression) {
        let span = name.span;
        let kind = StatementKind::Definition { name, value, unit: None };
        self.added.push(Statement::of(kind, span));
    }
}
