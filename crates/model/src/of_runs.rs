//! Aggregates of whole runs: `maximum(x) - minimum(x)` over the values of a parameter.
//!
//! Inside the model the same functions apply to the run so far (`so_far.rs`). Here each call is a number that is known only
//! at the end of a run. An extra parameter after those of the model stands for it.

use crate::dimensions::Form;
use crate::lowering::turned;
use crate::names::{Meaning, for_each};
use crate::notation::quote;
use crate::syntax::rewrite;
use crate::{Compiler, Diagnostic, Expression, ExpressionKind, Span, StatedUnit};
use program::{Aggregate, AggregateKind, Compiled, Kind};
use units::words;

/// A replaced call: its name in the rest of the expression, and its argument.
struct Call {
    kind: AggregateKind,
    name: String,
    argument: Expression,
    span: Span,
}

impl Compiler<'_> {
    /// Adds an expression with aggregates of a run to the graph of the model. Its aggregates, over the times from `from` on
    /// (SI), are appended to `aggregates`; each is an extra parameter after those of the model.
    ///
    /// # Errors
    /// The errors of [`Compiler::compile`], nested aggregates, and more aggregates than [`Aggregate::MOST`].
    pub fn compile_of_run(
        &mut self,
        expression: &Expression,
        unit: Option<&StatedUnit>,
        from: f64,
        aggregates: &mut Vec<Aggregate>,
    ) -> Result<Compiled, Vec<Diagnostic>> {
        let written = self.single(expression)?;
        let mut number = self.vectors.number(&written)?.into_owned();
        let calls = self.take_calls(&mut number)?;
        let declared = self.model.parameters.len();
        let mut former = Vec::with_capacity(calls.len());
        let mut failed = Vec::new();
        let mut unit_of_call = None;
        for call in calls {
            let of = match self.compile_number(&call.argument, None) {
                Ok(of) if of.kind == Kind::Number => of,
                Ok(_) => {
                    failed.push(no_number(&call));
                    continue;
                }
                Err(found) => {
                    failed.extend(found);
                    continue;
                }
            };
            let of_time = self.model.independent.unit.dimension;
            let dimension = match call.kind {
                AggregateKind::Integral => of.dimension().times(of_time),
                _ => Some(of.dimension()),
            };
            let Some(dimension) = dimension else {
                failed.push(no_unit(call.span));
                continue;
            };
            let aggregate = Aggregate { kind: call.kind, of: of.node, from };
            let known = aggregates.iter().position(|other| *other == aggregate);
            let number_of_it = known.unwrap_or(aggregates.len());
            if known.is_none() {
                aggregates.push(aggregate);
            }
            if aggregates.len() > Aggregate::MOST {
                failed.push(too_many(call.span));
                break;
            }
            let place = declared + number_of_it;
            let length = self.types.parameters.len().max(place + 1);
            self.types.parameters.resize(length, Form::pure());
            self.types.parameter_kinds.resize(length, Kind::Number);
            if let Some(form) = self.types.parameters.get_mut(place) {
                *form = dimension.into();
            }
            let is_whole = matches!(&number.kind, ExpressionKind::Name { name, order: 0 } if *name == call.name);
            if is_whole && call.kind != AggregateKind::Integral {
                unit_of_call = Some(of.unit);
            }
            let before = self.scope.exchange(&call.name, Some(Meaning::Parameter(place)));
            former.push((call.name, before));
        }
        let compiled = if failed.is_empty() { self.compile_number(&number, unit) } else { Err(failed) };
        for (name, before) in former.into_iter().rev() {
            self.scope.exchange(&name, before);
        }
        self.types.parameters.truncate(declared);
        self.types.parameter_kinds.truncate(declared);
        let mut value = compiled?;
        match (unit_of_call, unit) {
            (Some(of), Some(stated)) => value.node = turned(&mut self.model.graph, value.node, &of, &stated.unit),
            (Some(of), None) => value.unit = of,
            (None, _) => {}
        }
        Ok(value)
    }

    /// Replaces the calls by names and returns them.
    fn take_calls(&self, number: &mut Expression) -> Result<Vec<Call>, Vec<Diagnostic>> {
        let kind_of = |part: &Expression| match &part.kind {
            ExpressionKind::Call { function, arguments } if arguments.len() == 1 => {
                AggregateKind::named(&function.text).filter(|_| !self.scope.is_function(&function.text))
            }
            _ => None,
        };
        let mut calls: Vec<Call> = Vec::new();
        let mut nested = Vec::new();
        rewrite(number, &mut |part| {
            let Some(kind) = kind_of(part) else { return };
            let ExpressionKind::Call { arguments, .. } = &part.kind else { return };
            let Some(argument) = arguments.first().cloned() else { return };
            for_each(&argument, |inner| {
                if kind_of(inner).is_some() {
                    nested.push(one_in_another(inner, part.span));
                }
            });
            let quoted = quote(part);
            let is_used = calls.iter().any(|call| call.name == quoted);
            let name = if is_used { format!("{quoted} {}", calls.len()) } else { quoted };
            let span = part.span;
            *part = Expression::named(&name, span);
            calls.push(Call { kind, name, argument, span });
        });
        if nested.is_empty() { Ok(calls) } else { Err(nested) }
    }
}

fn one_in_another(inner: &Expression, outer: Span) -> Diagnostic {
    let message = words!(
        "`{}` is one number of the whole run, known only at its end: it cannot stand inside another such function",
        quote(inner)
    );
    Diagnostic::error("aggregate-inside", message, inner.span).with_label(outer, words("inside this one")).with_hint(
        words!(
            "give what the run has been so far a name in the model, as in `so_far = {}`, and use that",
            quote(inner)
        ),
    )
}

fn too_many(span: Span) -> Diagnostic {
    let message = words!("a plot cannot take more than {} numbers of each run", Aggregate::MOST);
    Diagnostic::error("too-large", message, span)
}

fn no_number(call: &Call) -> Diagnostic {
    let message = words!("`{}` is taken of numbers only", call.name);
    Diagnostic::error("not-a-number", message, call.argument.span).with_hint(words("write `if ... then 1 else 0`"))
}

fn no_unit(span: Span) -> Diagnostic {
    let message = words("the unit of this integral is out of range");
    Diagnostic::error("dimension-overflow", message, span)
}
