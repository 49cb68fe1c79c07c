//! Checks that every name and function in an expression exists and is used according to its kind.

use super::foreign;
use super::scope::{Meaning, Scope};
use super::traverse::for_each;
use super::unknown_name::{Unknown, unknown_name};
use crate::chance;
use crate::limits;
use crate::notation::{primed, quote};
use crate::spanish_functions::in_english;
use crate::{BinaryOperator, Diagnostic, Expression, ExpressionKind, FunctionStatement, Name, Span};
use program::Size;
use program::functions::Function;
use std::collections::HashSet;
use units::words;

/// Collects errors in the names of expressions. An unknown name is reported once, with all its places.
#[derive(Debug)]
pub(crate) struct NameCheck<'a> {
    scope: &'a Scope,
    /// Unknown names that are reported elsewhere.
    reported: Vec<&'a str>,
    unknown: Vec<Unknown<'a>>,
    /// Places of names covered by a diagnostic that already gives a replacement.
    told: Vec<Span>,
    diagnostics: Vec<Diagnostic>,
    /// Names that are valid only in the current function: arguments, indices and sizes.
    local: Vec<&'a str>,
    /// True for the model, where an unknown name can be declared.
    in_model: bool,
}

impl<'a> NameCheck<'a> {
    /// Empty check. The names in `reported` are not reported again.
    pub fn new(scope: &'a Scope, reported: Vec<&'a str>) -> Self {
        Self {
            scope,
            reported,
            unknown: Vec::new(),
            told: Vec::new(),
            diagnostics: Vec::new(),
            local: Vec::new(),
            in_model: true,
        }
    }

    /// Empty check for an expression of the document, where nothing can be declared.
    pub fn outside_model(scope: &'a Scope) -> Self {
        Self { in_model: false, ..Self::new(scope, Vec::new()) }
    }

    /// Checks one expression.
    pub fn expression(&mut self, expression: &'a Expression) {
        for_each(expression, |part| match &part.kind {
            ExpressionKind::Name { name, order } => self.name(name, *order, part.span),
            ExpressionKind::InitialValue { name, order } => self.initial_value(name, *order, part.span),
            ExpressionKind::Call { function, arguments } => self.call(function, arguments, part.span),
            ExpressionKind::Binary(BinaryOperator::Equal | BinaryOperator::NotEqual, left, right) => {
                self.alternative(left, right);
                self.alternative(right, left);
            }
            ExpressionKind::Binary(BinaryOperator::Power, base, exponent) => self.power(base, exponent, part.span),
            _ => {}
        });
    }

    /// Checks the body of a user-defined function, which may never be called.
    pub fn function(&mut self, function: &'a FunctionStatement, sizes: &'a [Size]) {
        self.local.extend(function.parameters.iter().map(|parameter| parameter.text.as_str()));
        self.local.extend(sizes.iter().map(|size| size.name.as_str()));
        for_each(&function.body, |part| {
            if let ExpressionKind::Reduction { over, .. } = &part.kind {
                self.local.extend(over.iter().map(|over| over.index.text.as_str()));
            }
        });
        self.expression(&function.body);
        self.local.clear();
    }

    /// Reports `e^(-x)`, unless `e` is a name of the model.
    fn power(&mut self, base: &Expression, exponent: &Expression, span: Span) {
        let is_e = matches!(&base.kind, ExpressionKind::Name { name, order: 0 } if name == "e");
        if !is_e || self.local.contains(&"e") || self.scope.meaning("e").is_some() {
            return;
        }
        let ours = format!("exp({})", quote(exponent));
        let message = words!("the power of `e` is written `{ours}` here");
        let diagnostic = Diagnostic::error("foreign-power", message, span);
        let is_shortened = ours.contains("...");
        self.diagnostics.push(if is_shortened { diagnostic } else { diagnostic.with_fix(span, ours) });
        self.told.push(base.span);
    }

    /// Reports `liquid == "Watr"`, which is never true.
    fn alternative(&mut self, name: &Expression, text: &Expression) {
        let (ExpressionKind::Name { name, order: 0 }, ExpressionKind::Text(word)) = (&name.kind, &text.kind) else {
            return;
        };
        let Some(texts) = self.scope.choice(name).filter(|texts| !texts.contains(word)) else { return };
        let message = words!("`{name}` has no alternative \"{word}\"");
        let texts: Vec<String> = texts.iter().map(|text| format!("\"{text}\"")).collect();
        let hint = words!("it can be: {}", texts.join(", "));
        self.diagnostics.push(Diagnostic::error("not-a-choice", message, text.span).with_hint(hint));
    }

    fn name(&mut self, name: &'a str, order: u32, span: Span) {
        if self.local.contains(&name) || self.told.contains(&span) {
            return;
        }
        let (what, value) = match self.scope.meaning(name) {
            None => return self.unknown(name, order, span, ""),
            Some(Meaning::Parameter(_)) => (words("a parameter"), 0),
            Some(Meaning::Pi) => (words("a constant"), 0),
            Some(Meaning::Independent) => (words("the independent variable"), 1),
            Some(Meaning::Definition(_) | Meaning::Variable(_)) => return,
        };
        if order > 0 {
            let value = if order == 1 { value } else { 0 };
            let written = primed(name, order);
            let message = words!("`{written}` is always {value}: `{name}` is {what}");
            self.diagnostics.push(Diagnostic::error("prime-of-constant", message, span));
        }
    }

    fn initial_value(&mut self, name: &'a str, order: u32, span: Span) {
        if self.local.contains(&name) || self.scope.is_function(name) {
            return;
        }
        if self.scope.meaning(name).is_none() {
            return self.unknown(name, order, span, "(0)");
        }
        self.name(name, order, span);
        if order == 0
            && let Some(Meaning::Parameter(_) | Meaning::Pi | Meaning::Independent) = self.scope.meaning(name)
        {
            let message = words!("`{name}` has no initial value: it is not an unknown of the equations");
            self.diagnostics.push(
                Diagnostic::error("initial-value-of-constant", message, span)
                    .with_hint(words!("write `{name}` alone, or `{name}*0` for a product")),
            );
        }
    }

    fn unknown(&mut self, name: &'a str, order: u32, span: Span, ending: &str) {
        if self.reported.contains(&name) {
            return;
        }
        let count = self.unknown.len();
        let place = (span, "'".repeat(order as usize) + ending);
        match self.unknown.iter_mut().find(|known| known.name == name) {
            Some(known) => {
                known.order = order.max(known.order);
                // The body of a function is expanded in each call, so a place can occur repeatedly.
                if !known.places.contains(&place) {
                    known.places.push(place);
                }
            }
            None if count < limits::TOLD => self.unknown.push(Unknown { name, order, places: vec![place] }),
            None => {}
        }
    }

    fn call(&mut self, name: &Name, arguments: &[Expression], span: Span) {
        if chance::draws(&name.text) && !chance::has_stream(arguments) && !self.scope.is_function(&name.text) {
            self.diagnostics.push(chance::out_of_place(name));
            return;
        }
        if let Some(function) = Function::named(&name.text) {
            if !function.takes(arguments.len()) {
                self.wrong_count(function, arguments, name.span);
            }
            return;
        }
        let text = &name.text;
        if self.scope.table(text).is_some() && arguments.len() != 1 {
            let message = words!("`{text}` is a table and takes 1 argument");
            self.diagnostics.push(Diagnostic::error("wrong-argument-count", message, name.span));
        }
        if self.scope.is_function(text) {
            return;
        }
        let message = words!("there is no function `{text}`");
        let mut diagnostic = Diagnostic::error("unknown-function", message, name.span);
        if self.scope.meaning(text).is_some() {
            diagnostic.message = words!("`{text}` is not a function");
            if let [Expression { kind: ExpressionKind::Name { name, order: 0 }, .. }] = arguments
                && let Some(Meaning::Independent) = self.scope.meaning(name)
            {
                diagnostic = diagnostic.with_hint(words!("`{text}` alone is its value at `{name}`"));
                diagnostic = diagnostic.with_fix(span, text.as_str());
            } else if let Some(late) =
                arguments.first().and_then(|argument| foreign::at_another_time(self.scope, name, argument, span))
            {
                diagnostic = late;
            } else if let [argument] = arguments {
                diagnostic = diagnostic
                    .with_hint(words!("for a product write `{text}*({})`", quote(argument)))
                    .with_fix(name.span.after(), "*");
            }
        } else if let Some(refusal) = foreign::of_runs(name, arguments) {
            diagnostic = refusal;
        } else if let Some(hint) = foreign::instead_of(self.scope, name, arguments) {
            diagnostic = diagnostic.with_hint(hint);
            if let Some(derivative) = foreign::derivative_of(name, arguments) {
                diagnostic = diagnostic.with_fix(span, derivative);
            }
        } else if let Some(near) = in_english(text).or_else(|| self.scope.near_function(text)) {
            diagnostic = diagnostic.meaning(near);
        }
        self.diagnostics.push(diagnostic);
    }

    fn wrong_count(&mut self, function: &Function, arguments: &[Expression], span: Span) {
        let message = match (function.name, function.arity(), arguments.len()) {
            (name, takes, 1) => {
                words!("`{name}` takes {takes}, and 1 was given")
            }
            (name, takes, given) => words!("`{name}` takes {takes}, and {given} were given"),
        };
        let diagnostic = Diagnostic::error("wrong-argument-count", message, span);
        self.diagnostics.push(match decimal_comma(arguments) {
            Some(comma) => diagnostic.with_hint(words("a number has a decimal point")).with_fix(comma, "."),
            None => diagnostic,
        });
    }

    /// Returns all diagnostics, each once.
    pub fn finish(mut self) -> Vec<Diagnostic> {
        let mut places = HashSet::new();
        self.diagnostics.retain(|diagnostic| places.insert((diagnostic.code, diagnostic.span())));
        let (scope, in_model) = (self.scope, self.in_model);
        self.diagnostics.extend(self.unknown.iter().map(|unknown| unknown_name(scope, unknown, in_model)));
        self.diagnostics
    }
}

/// Place of the comma between two arguments that look like one number with a decimal comma: `sin(0,5)`.
fn decimal_comma(arguments: &[Expression]) -> Option<Span> {
    let is_number = |argument: &Expression| matches!(argument.kind, ExpressionKind::Number { .. });
    arguments.windows(2).find_map(|pair| {
        let [before, after] = pair else { return None };
        let comma = Span::new(before.span.end, after.span.start);
        let touches = comma.end == comma.start + 1;
        (touches && is_number(before) && is_number(after)).then_some(comma)
    })
}
