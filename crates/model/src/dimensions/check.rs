//! Infers and checks the dimensions of a whole model.
//!
//! What the author states counts before what follows from it: first stated units, then definitions without one, initial
//! values, equations, and at last the values of definitions with a stated unit, which are only checked against it. So a
//! slip in a definition is reported there, and not in the equations that use it. An initial value that is a bare number comes
//! after the equations: its unit was likely forgotten.

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

/// What is known about the names of a model once it has been checked; every dimension in it is known. `order` is that of
/// the definitions.
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
    /// The members of a family have one dimension, and so have the components of a vector.
    fn families(&mut self, unknowns: &[Unknown]) {
        let mut first: HashMap<&str, usize> = HashMap::new();
        for (index, unknown) in unknowns.iter().enumerate() {
            let Some(family) = vector_or_family(unknown.name) else { continue };
            let first = *first.entry(family).or_insert(index);
            if first != index {
                // Nothing is known of either yet, so this cannot fail.
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
                    let message = words!(
                        "the stated unit does not fit: `{written}` is {what}",
                        "la unidad declarada no concuerda: `{written}` es {what}",
                        what = self.what(&own)
                    );
                    let mut diagnostic =
                        Diagnostic::error("dimension-mismatch", message, stated.span).saying(self.what(&needed));
                    if let Some(origin) = self.solver.origin(&self.types.unknowns[index]) {
                        diagnostic = diagnostic.with_label(origin, words("this decides it", "esto la determina"));
                    }
                    self.diagnostics.push(diagnostic);
                }
            }
        }
    }

    /// The dimension of an unknown with primes.
    fn state(&self, index: usize, order: u32) -> Option<Form> {
        self.derivative(self.types.unknowns.get(index)?, order)
    }

    /// Definitions in an order in which each comes after those it uses. A stated unit is believed for now.
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

    /// Those that are `wanted`.
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

    /// What becomes the value of a state must have its dimension.
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
                let context = words!(" for {title}", " para {title}");
                self.report_value((value, &form), (&title, own, span), &context);
            }
        }
    }

    /// The dimension of what must be a number.
    fn as_number(&mut self, value: &Expression, found: &Type, user: &Words) -> Option<Form> {
        match found {
            Type::Number(form) => return Some(form.clone()),
            Type::Unknown => return None,
            Type::Truth | Type::Text => {}
        }
        let message = words!(
            "{user} must be a number, but this is {kind}",
            "{user} debe ser un número, pero esto es {kind}",
            user = user,
            kind = found.described()
        );
        self.refuse(Diagnostic::error("type-mismatch", message, value.span));
        None
    }

    /// Infers a value and checks it against the unit stated for it.
    fn stated(&mut self, value: &Expression, stated: &StatedUnit) {
        let found = self.expression(value);
        self.check_stated(value, &found, stated);
    }

    /// Checks a value against the unit stated for it.
    pub fn check_stated(&mut self, value: &Expression, found: &Type, stated: &StatedUnit) {
        let Some(form) = self.as_number(value, found, &words("what has a unit", "lo que tiene unidad")) else { return };
        let needed = Form::from(stated.unit.dimension);
        match self.solver.unify(&form, &needed, stated.span) {
            Ok(()) => {}
            Err(Conflict::TooLarge) => {
                self.too_large(value.span);
            }
            Err(Conflict::Different) => {
                let title = format!("[{}]", stated.unit);
                let context = words!(" for the stated unit {title}", " para la unidad declarada {title}");
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

    /// Notes that the parameters in expressions fit there, also those in definitions without a stated unit.
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

    /// The dimension of terms that are all known and all of one dimension.
    fn common(&self, terms: &[Term]) -> Option<Dimension> {
        let dimension = |term: &Term| self.solver.resolve(term.form.as_ref()?).ok()?.dimension();
        let first = dimension(terms.first()?)?;
        terms.iter().all(|term| dimension(term) == Some(first)).then_some(first)
    }

    fn event(&mut self, event: &EventEntry) {
        self.truth(event.condition, &words("the condition of an event", "la condición de un evento"));
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

    /// Puts what was found out into the types; what nothing decides is a pure number. With an error elsewhere, `warn` is
    /// false: the dimension is open only because of that.
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
                    "nada determina la dimensión de `{name}`; se toma como {what}",
                    what = with_article(Dimension::NONE)
                );
                self.diagnostics.push(Diagnostic::warning("undetermined-dimension", message, unknown.span).with_hint(
                    words!(
                        "state it with the initial value: `{name}(0) = 0 in [m]`",
                        "declárala con el valor inicial: `{name}(0) = 0 in [m]`"
                    ),
                ));
            }
            // A pure number fits what is free, so this cannot fail.
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
