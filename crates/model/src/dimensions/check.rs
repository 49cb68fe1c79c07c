//! Infers and checks the dimensions of a whole model.
//!
//! Dimensions are settled in this order: stated units, definitions without a unit, initial values, equations, and last the
//! values of definitions with a stated unit, which are only checked against it. So a mistake in a definition is reported
//! there, not in the equations that use it. Initial values that are bare numbers come after the equations, because their
//! unit was probably forgotten.

use super::alike::{Alike, Part};
use super::describe::with_article;
use super::form::{Conflict, Form, Solver};
use super::infer::Inference;
use super::mismatch::is_bare;
use super::terms::{Place, Term};
use super::types::{ParameterPlace, Type, Types};
use crate::components::vector_or_family;
use crate::names::{Declarations, Equation, EventEntry, InitialEntry, Meaning, Unknown, for_each_name};
use crate::notation::primed;
use crate::{Diagnostic, Expression, ParameterStatement, Span, StatedUnit, has_errors};
use std::collections::HashMap;
use units::{Dimension, Words, words};

/// Types of all names after the check of a model; every dimension is known. `order` is the evaluation order of the
/// definitions.
pub(crate) fn check_dimensions(
    declarations: &Declarations,
    order: &[usize],
    unknowns: &[Unknown],
    diagnostics: &mut Vec<Diagnostic>,
) -> Types {
    let mut solver = Solver::default();
    let unit = |stated: Option<&StatedUnit>| stated.map_or(Dimension::NONE, |stated| stated.unit.dimension);
    let mut types = Types {
        independent: declarations.independent.1.dimension.into(),
        parameters: declarations.parameters.iter().map(|entry| unit(entry.statement.unit.as_ref()).into()).collect(),
        parameter_places: declarations.parameters.iter().map(|entry| place(entry.statement)).collect(),
        parameter_kinds: declarations.parameters.iter().map(|entry| entry.statement.form.kind()).collect(),
        definitions: vec![Type::Unknown; declarations.definitions.len()],
        numbers: vec![None; declarations.definitions.len()],
        unknowns: unknowns.iter().map(|_| solver.fresh()).collect(),
        unknown_names: unknowns.iter().map(|unknown| unknown.name.to_owned()).collect(),
    };
    let alike = Alike::of(unknowns);
    let mut inference =
        Inference { scope: &declarations.scope, types: &mut types, solver, alike, diagnostics: Vec::new() };
    inference.families(unknowns);
    inference.stated_initial_values(unknowns);
    inference.definitions(declarations, order);
    inference.initial_values(unknowns, |entry| !is_bare(entry.value));
    for equation in &declarations.equations {
        let sides = [equation.left, equation.right];
        inference.check_once(inference.parts(&sides), |inference| {
            let reported = inference.diagnostics.len();
            inference.equation(equation);
            if inference.diagnostics.len() == reported {
                inference.confirm(&sides, declarations);
            }
        });
    }
    inference.initial_values(unknowns, |entry| is_bare(entry.value));
    for definition in &declarations.definitions {
        if let Some(stated) = definition.unit {
            let mut parts = inference.parts(&[definition.value]);
            parts.push(Part::Number(Some(stated.unit.dimension), None));
            inference.check_once(parts, |inference| {
                let reported = inference.diagnostics.len();
                inference.stated(definition.value, stated);
                if inference.diagnostics.len() == reported {
                    inference.confirm(&[definition.value], declarations);
                }
            });
        }
    }
    for event in &declarations.events {
        inference.event(event);
    }
    inference.settle(unknowns, !has_errors(diagnostics));
    diagnostics.append(&mut inference.diagnostics);
    types
}

fn place(parameter: &ParameterStatement) -> ParameterPlace {
    let unit = parameter.unit.as_ref().map(|stated| stated.span);
    ParameterPlace { value: parameter.value_span, unit, is_confirmed: false }
}

impl Inference<'_> {
    /// Requires one dimension for the members of a family and for the components of a vector.
    fn families(&mut self, unknowns: &[Unknown]) {
        let mut first: HashMap<&str, usize> = HashMap::new();
        for (index, unknown) in unknowns.iter().enumerate() {
            let Some(family) = vector_or_family(unknown.name) else { continue };
            let first = *first.entry(family).or_insert(index);
            if first != index {
                // Both dimensions are still unknown, so this cannot fail.
                let (one, other) = (&self.types.unknowns[first], &self.types.unknowns[index]);
                let _ = self.solver.unify(one, other, unknown.span);
            }
        }
    }

    /// `y(0) = h in [cm]` makes y a length, whatever h is.
    fn stated_initial_values(&mut self, unknowns: &[Unknown]) {
        for (index, unknown) in unknowns.iter().enumerate() {
            for entry in unknown.initial.iter().flatten() {
                let Some(stated) = entry.unit else { continue };
                let Some(own) = self.state(index, entry.order) else { continue };
                let needed = Form::from(stated.unit.dimension);
                if self.solver.unify(&own, &needed, stated.span) == Err(Conflict::Different) {
                    let written = primed(unknown.name, entry.order);
                    let message = words!("the stated unit does not fit: `{written}` is {what}", what = self.what(&own));
                    let mut diagnostic =
                        Diagnostic::error("dimension-mismatch", message, stated.span).saying(self.what(&needed));
                    if let Some(origin) = self.solver.origin(&self.types.unknowns[index]) {
                        diagnostic = diagnostic.with_label(origin, words("this decides it"));
                    }
                    self.diagnostics.push(diagnostic);
                }
            }
        }
    }

    /// Dimension of the derivative of an unknown with `order` primes.
    fn state(&self, index: usize, order: u32) -> Option<Form> {
        self.derivative(self.types.unknowns.get(index)?, order)
    }

    /// Infers definitions in evaluation order. A stated unit is trusted here and checked later.
    fn definitions(&mut self, declarations: &Declarations, order: &[usize]) {
        for &index in order {
            let definition = &declarations.definitions[index];
            self.types.numbers[index] = if definition.unit.is_none() { self.constant(definition.value) } else { None };
            self.types.definitions[index] = match definition.unit {
                Some(stated) => Type::Number(stated.unit.dimension.into()),
                None => self.defined(index, definition.value),
            };
        }
    }

    /// Checks the initial values that `wanted` selects.
    fn initial_values(&mut self, unknowns: &[Unknown], wanted: impl Fn(&InitialEntry) -> bool) {
        for (index, unknown) in unknowns.iter().enumerate() {
            for entry in unknown.initial.iter().flatten().filter(|entry| wanted(entry)) {
                let mut parts = self.parts(&[entry.value]);
                parts.push(match entry.unit {
                    Some(stated) => Part::Number(Some(stated.unit.dimension), None),
                    None => Part::Name(Meaning::Variable(self.alike.first(index)), entry.order, None),
                });
                self.check_once(parts, |own| {
                    if let Some(stated) = entry.unit {
                        own.stated(entry.value, stated);
                    } else if let Some(form) = own.state(index, entry.order) {
                        let written = primed(unknown.name, entry.order);
                        own.assigned(entry.value, &written, &form, entry.name.span);
                    }
                });
            }
        }
    }

    /// Requires that a value assigned to a state has the dimension of the state.
    fn assigned(&mut self, value: &Expression, written: &str, own: &Form, span: Span) {
        let found = self.expression(value);
        let Some(form) = self.as_number(value, &found, &Words::same(format!("`{written}`"))) else { return };
        match self.solver.unify(own, &form, value.span) {
            Ok(()) => {}
            Err(Conflict::TooLarge) => {
                self.too_large(value.span);
            }
            Err(Conflict::Different) => {
                let title = format!("`{written}`");
                let context = words!(" for {title}");
                self.report_value((value, &form), (&title, own, span), &context);
            }
        }
    }

    /// Dimension of a value that must be a number. Reports other types.
    fn as_number(&mut self, value: &Expression, found: &Type, user: &Words) -> Option<Form> {
        match found {
            Type::Number(form) => return Some(form.clone()),
            Type::Unknown => return None,
            Type::Truth | Type::Text => {}
        }
        let message = words!("{user} must be a number, but this is {kind}", kind = found.described());
        self.refuse(Diagnostic::error("type-mismatch", message, value.span));
        None
    }

    /// Infers a value and checks it against its stated unit.
    fn stated(&mut self, value: &Expression, stated: &StatedUnit) {
        let found = self.expression(value);
        self.check_stated(value, &found, stated);
    }

    /// Checks a value of type `found` against its stated unit.
    pub fn check_stated(&mut self, value: &Expression, found: &Type, stated: &StatedUnit) {
        let Some(form) = self.as_number(value, found, &words("what has a unit")) else { return };
        let needed = Form::from(stated.unit.dimension);
        match self.solver.unify(&form, &needed, stated.span) {
            Ok(()) => {}
            Err(Conflict::TooLarge) => {
                self.too_large(value.span);
            }
            Err(Conflict::Different) => {
                let title = format!("[{}]", stated.unit);
                let context = words!(" for the stated unit {title}");
                self.report_value((value, &form), (&title, &needed, stated.span), &context);
            }
        }
    }

    fn equation(&mut self, equation: &Equation) {
        let (mut left, mut right) = (Vec::new(), Vec::new());
        self.terms(equation.left, &mut left);
        self.terms(equation.right, &mut right);
        if let (Some(left_form), Some(right_form)) = (self.common(&left), self.common(&right))
            && left_form != right_form
        {
            let (left_form, right_form) = (Form::from(left_form), Form::from(right_form));
            self.report_sides(equation.span, (equation.left, &left_form), (equation.right, &right_form));
            return;
        }
        left.append(&mut right);
        self.equal(&left, Place::Sum);
    }

    /// Marks the parameters in consistent expressions as confirmed, also those in definitions without a stated unit.
    fn confirm(&mut self, expressions: &[&Expression], declarations: &Declarations) {
        let mut waiting = expressions.to_vec();
        let mut seen = vec![false; declarations.definitions.len()];
        while let Some(expression) = waiting.pop() {
            for_each_name(expression, |name, _, _| match self.scope.meaning(name) {
                Some(Meaning::Parameter(index)) => self.types.parameter_places[index].is_confirmed = true,
                Some(Meaning::Definition(index)) if !std::mem::replace(&mut seen[index], true) => {
                    let definition = &declarations.definitions[index];
                    waiting.extend(definition.unit.is_none().then_some(definition.value));
                }
                _ => {}
            });
        }
    }

    /// Common dimension of the terms, if all are known and equal.
    fn common(&self, terms: &[Term]) -> Option<Dimension> {
        let dimension = |term: &Term| self.solver.resolve(term.form.as_ref()?).ok()?.dimension();
        let first = dimension(terms.first()?)?;
        terms.iter().all(|term| dimension(term) == Some(first)).then_some(first)
    }

    fn event(&mut self, event: &EventEntry) {
        self.truth(event.condition, &words("the condition of an event"));
        for action in event.actions {
            match self.scope.meaning(&action.name.text) {
                Some(Meaning::Variable(index)) => {
                    if let Some(own) = self.state(index, action.order) {
                        let written = primed(&action.name.text, action.order);
                        self.assigned(&action.value, &written, &own, action.name.span);
                    }
                }
                _ => {
                    self.expression(&action.value);
                }
            }
        }
    }

    /// Writes the inferred dimensions into the types; an undetermined dimension becomes a pure number. `warn` is false
    /// after an error elsewhere, which may be the cause of the undetermined dimension.
    fn settle(&mut self, unknowns: &[Unknown], warn: bool) {
        for (index, unknown) in unknowns.iter().enumerate() {
            let own = self.types.unknowns[index].clone();
            if self.solver.resolve(&own).is_ok_and(|form| form.dimension().is_some()) {
                continue;
            }
            let name = unknown.name;
            if warn && !has_errors(&self.diagnostics) {
                let message = words!(
                    "nothing decides the dimension of `{name}`; it is taken to be {what}",
                    what = with_article(Dimension::NONE)
                );
                self.diagnostics.push(
                    Diagnostic::warning("undetermined-dimension", message, unknown.span)
                        .with_hint(words!("state it with the initial value: `{name}(0) = 0 in [m]`")),
                );
            }
            // A pure number fits a free dimension, so this cannot fail.
            let _ = self.solver.unify(&own, &Form::pure(), unknown.span);
        }
        let settled = |solver: &Solver, form: &Form| {
            solver.resolve(form).map_or_else(|_| Form::pure(), |form| Form::from(form.known))
        };
        for form in &mut self.types.unknowns {
            *form = settled(&self.solver, form);
        }
        for definition in &mut self.types.definitions {
            if let Type::Number(form) = definition {
                *form = settled(&self.solver, form);
            }
        }
    }
}
