//! Reports of dimension mismatches: the part at fault, the factor it lacks, and possible remedies in the model.

use super::describe::{Factor, Row, as_factor, table, with_article};
use super::form::{Conflict, Form};
use super::infer::Inference;
use super::terms::{LEFT_SIDE, Place, RIGHT_SIDE, Term};
use super::types::Type;
use crate::limits;
use crate::notation::quote;
use crate::{Diagnostic, Expression, ExpressionKind, Span, UnaryOperator};
use units::{Dimension, Exponent, Words, words};

/// True for a number without a unit, possibly negated, and for components of such numbers.
pub(crate) fn is_bare(expression: &Expression) -> bool {
    match &expression.kind {
        ExpressionKind::Number { unit, .. } => unit.is_none(),
        ExpressionKind::Unary(UnaryOperator::Negate, operand) => is_bare(operand),
        ExpressionKind::Component { of, .. } => of.operands().into_iter().all(is_bare),
        _ => false,
    }
}

impl Inference<'_> {
    /// Requires one dimension of all terms, and returns it. If they differ, the terms that differ from most others are
    /// reported, and the result is unknown, to avoid errors that follow from this one.
    pub fn equal(&mut self, terms: &[Term], place: Place) -> Type {
        let usable: Vec<(usize, &Term, &Form)> = terms
            .iter()
            .enumerate()
            .filter_map(|(index, term)| term.form.as_ref().map(|form| (index, term, form)))
            .collect();
        let Some(&(_, _, first)) = usable.first() else {
            return if terms.is_empty() { Type::Number(self.solver.fresh()) } else { Type::Unknown };
        };
        let reference = self.most_common(&usable).unwrap_or_else(|| first.clone());
        let mut odd: Vec<(usize, &Term, &Form)> = Vec::new();
        for &(index, term, form) in &usable {
            match self.solver.unify(form, &reference, term.expression.span) {
                Ok(()) => {}
                Err(Conflict::Different) => odd.push((index, term, form)),
                Err(Conflict::TooLarge) => return self.too_large(term.expression.span),
            }
        }
        if !odd.is_empty() && !self.has_told_enough() {
            let normal: Vec<(usize, &Term, &Form)> =
                usable.iter().filter(|(index, ..)| odd.iter().all(|(other, ..)| other != index)).copied().collect();
            self.report_odd(&odd, &normal, place);
        }
        if odd.is_empty() { Type::Number(reference) } else { Type::Unknown }
    }

    /// True once [`limits::TOLD`] diagnostics are reported. Explanations take time, and a hostile text could ask for many.
    pub fn has_told_enough(&self) -> bool {
        self.diagnostics.len() >= limits::TOLD
    }

    /// Known dimension of most terms; the first of several.
    fn most_common(&self, terms: &[(usize, &Term, &Form)]) -> Option<Form> {
        let mut counts: Vec<(Dimension, usize)> = Vec::new();
        for (_, _, form) in terms {
            let Some(dimension) = self.solver.resolve(form).ok().and_then(|form| form.dimension()) else {
                continue;
            };
            match counts.iter_mut().find(|(known, _)| *known == dimension) {
                Some((_, count)) => *count += 1,
                None => counts.push((dimension, 1)),
            }
        }
        let greatest = counts.iter().map(|&(_, count)| count).max()?;
        counts.iter().find(|&&(_, count)| count == greatest).map(|&(dimension, _)| dimension.into())
    }

    fn report_odd(&mut self, odd: &[(usize, &Term, &Form)], normal: &[(usize, &Term, &Form)], place: Place) {
        let (Some(&(index, term, form)), Some(&(normal_index, normal_term, normal_form))) =
            (odd.first(), normal.first())
        else {
            return;
        };
        let row = |index: usize, term: &Term| place.part(index, term.expression);
        let subject = row(index, term);
        let mut diagnostic = self.mismatch(
            &subject,
            (term.expression, form),
            (&row(normal_index, normal_term), normal_form),
            &Words::default(),
        );
        diagnostic = diagnostic.with_label(normal_term.expression.span, self.what(normal_form));
        for (_, other, form) in odd.iter().skip(1).take(limits::PLACES) {
            diagnostic = diagnostic.with_label(other.expression.span, self.what(form));
        }
        for (_, other, form) in normal.iter().skip(1).take(limits::PLACES) {
            diagnostic = diagnostic.with_label(other.expression.span, self.what(form));
        }
        let diagnostic = self.with_origins(diagnostic, &[form, normal_form]);
        let diagnostic = self.with_remedy(diagnostic, term.expression, form, normal_form);
        self.diagnostics.push(self.without_units(diagnostic, form, normal_form));
    }

    /// For a model without any units, adds the hint to remove the unit of the independent variable.
    fn without_units(&self, diagnostic: Diagnostic, found: &Form, expected: &Form) -> Diagnostic {
        let is_pure = |form: &Form| form.dimension().is_some_and(|dimension| dimension.is_none());
        let independent = self.types.independent.known;
        let of_independent = self.factor(found, expected).is_some_and(|factor| {
            (1..=4).any(|order| independent.power(Exponent::from(order)) == Some(factor.dimension()))
        });
        if is_pure(&self.types.independent) || !of_independent || !self.types.parameters.iter().all(is_pure) {
            return diagnostic;
        }
        let name = &self.scope.independent;
        diagnostic.with_hint(words!("or, for equations without units, add the line `independent {name}`"))
    }

    /// Reports an equation whose sides are consistent but have different dimensions.
    pub fn report_sides(&mut self, span: Span, left: (&Expression, &Form), right: (&Expression, &Form)) {
        if self.has_told_enough() {
            return;
        }
        let message = match self.factor(left.1, right.1) {
            Some(factor) => words!("the left side of the equation {verdict}", verdict = factor.verdict()),
            None => words("the left side of the equation differs from the right side"),
        };
        let diagnostic = Diagnostic::error("dimension-mismatch", message, span)
            .with_label(left.0.span, self.what(left.1))
            .with_label(right.0.span, self.what(right.1))
            .with_note(self.table(&[(&LEFT_SIDE, left.1), (&RIGHT_SIDE, right.1)]));
        let diagnostic = self.with_dimensions(diagnostic, left.1, right.1);
        let diagnostic = self.with_origins(diagnostic, &[left.1, right.1]);
        let hint = self.factor(left.1, right.1).map(|factor| {
            let thing = as_factor(factor.dimension());
            let offers = self.offers(factor, left.0);
            let mut unitless = self.forgotten_unit(left.0, factor.lacking());
            if unitless.is_empty() {
                unitless = self.forgotten_unit(right.0, factor.lacking().inverse());
            }
            let (multiply, divide) = (words("multiply"), words("divide"));
            let (change, opposite) = match factor {
                Factor::Lacking(_) => (multiply, divide),
                Factor::Excess(_) => (divide, multiply),
            };
            words!("{change} the left side by {thing}{offers}, or {opposite} the right side by one{unitless}",)
        });
        let diagnostic = match hint {
            Some(hint) => diagnostic.with_hint(hint),
            None => diagnostic,
        };
        self.diagnostics.push(self.without_units(diagnostic, left.1, right.1));
    }

    /// Reports a value whose dimension differs from the one stated or needed.
    pub fn report_value(&mut self, value: (&Expression, &Form), needed: (&str, &Form, Span), context: &Words) {
        if self.has_told_enough() {
            return;
        }
        let subject = Words::same(format!("`{}`", quote(value.0)));
        let title = Words::same(needed.0.to_owned());
        let what = self.what(needed.1);
        // The label of a stated unit is at the unit itself; that of a name covers the name only, without its primes.
        let is_name = needed.0.starts_with('`');
        let label = if is_name { words!("{title} is {what}") } else { what };
        let diagnostic = self.mismatch(&subject, value, (&title, needed.1), context).with_label(needed.2, label);
        let diagnostic = self.with_origins(diagnostic, &[value.1, needed.1]);
        let mut diagnostic = self.with_remedy(diagnostic, value.0, value.1, needed.1);
        let found = self.solver.resolve(value.1).ok().and_then(|form| form.dimension()).map(units::Unit::si);
        let is_usual = |unit: &units::Unit| {
            !unit.dimension.is_none() && unit.dimension.base().all(|(_, exponent)| exponent.is_whole())
        };
        let is_stated = !is_name
            && self
                .factor(value.1, needed.1)
                .is_some_and(|factor| self.has_confirmed_parameters(value.0) || !self.has_offer(factor, value.0));
        if let Some(unit) = found.filter(|unit| is_stated && diagnostic.fixes.is_empty() && is_usual(unit)) {
            diagnostic = diagnostic
                .with_hint(words!("or state the unit that it has: [{unit}]"))
                .with_fix(needed.2, format!("[{unit}]"));
        }
        self.diagnostics.push(diagnostic);
    }

    /// Diagnostic for a value that must be dimensionless and is not.
    pub fn not_pure(&self, expression: &Expression, form: &Form, what: &Words) -> Diagnostic {
        let kind = self.what(form);
        let quoted = quote(expression);
        let message = words!("{what} must be a pure number, but `{quoted}` is {kind}");
        let (subject, needed) = (Words::same(format!("`{quoted}`")), words("needed"));
        let diagnostic = Diagnostic::error("dimension-mismatch", message, expression.span)
            .saying(kind)
            .with_note(self.table(&[(&subject, form), (&needed, &Form::pure())]));
        let diagnostic = self.with_dimensions(diagnostic, form, &Form::pure());
        self.with_remedy(self.with_origins(diagnostic, &[form]), expression, form, &Form::pure())
    }

    fn mismatch(
        &self,
        subject: &Words,
        (expression, found): (&Expression, &Form),
        (other, expected): (&Words, &Form),
        context: &Words,
    ) -> Diagnostic {
        let message = match self.factor(found, expected) {
            Some(_) if is_bare(expression) => {
                words!("{subject} has no unit, but {needed} is needed{context}", needed = self.what(expected),)
            }
            Some(factor) => {
                words!("{subject} {verdict}{context}", verdict = factor.verdict())
            }
            None => {
                words!("{subject} does not fit {other}{context}")
            }
        };
        let diagnostic = Diagnostic::error("dimension-mismatch", message, expression.span)
            .saying(self.what(found))
            .with_note(self.table(&[(subject, found), (other, expected)]));
        self.with_dimensions(diagnostic, found, expected)
    }

    /// States both dimensions as data, if both are known.
    fn with_dimensions(&self, diagnostic: Diagnostic, found: &Form, needed: &Form) -> Diagnostic {
        let known = |form: &Form| self.solver.resolve(form).ok().and_then(|form| form.dimension());
        match (known(found), known(needed)) {
            (Some(found), Some(needed)) => diagnostic.of_dimensions(found, needed),
            _ => diagnostic,
        }
    }

    pub fn factor(&self, found: &Form, expected: &Form) -> Option<Factor> {
        let ratio = found.per(expected).and_then(|ratio| self.solver.resolve(&ratio)).ok()?;
        ratio.dimension().map(Factor::of)
    }

    /// `a length`, `the dimension kg m^3`.
    pub fn what(&self, form: &Form) -> Words {
        let resolved = self.solver.resolve(form).ok().and_then(|form| form.dimension());
        resolved.map_or_else(|| words("of unknown dimension"), with_article)
    }

    fn table(&self, rows: &[(&Words, &Form)]) -> Words {
        let rows: Vec<Row> = rows
            .iter()
            .map(|(title, form)| {
                let form = self.solver.resolve(form).unwrap_or_else(|_| (*form).clone());
                Row { title: (*title).clone(), form }
            })
            .collect();
        let names = self.types.unknown_names.clone();
        let name_of = move |index| format!("[{}]", names.get(index).map_or("?", String::as_str));
        Words::each(move |language| table(&rows, language, &name_of))
    }

    /// Adds the places that determined the dimensions of the unknown functions involved.
    fn with_origins(&self, mut diagnostic: Diagnostic, forms: &[&Form]) -> Diagnostic {
        for (name, form) in self.types.unknown_names.iter().zip(&self.types.unknowns) {
            let involved = forms.iter().any(|found| {
                form.unknown.iter().any(|variable| found.unknown.iter().any(|other| other.0 == variable.0))
            });
            let Some(origin) = self.solver.origin(form).filter(|_| involved) else {
                continue;
            };
            let reported =
                diagnostic.labels.iter().any(|label| label.span.start <= origin.start && origin.end <= label.span.end);
            if !reported {
                diagnostic = diagnostic
                    .with_label(origin, words!("from here `{name}` is taken to be {what}", what = self.what(form)));
            }
        }
        diagnostic
    }
}
