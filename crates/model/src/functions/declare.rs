//! Collects the user-defined functions and rejects recursion.

use super::{Function, Functions};
use crate::components::split_component;
use crate::matching::blocks;
use crate::names::{for_each, for_each_name, list};
use crate::{Diagnostic, ExpressionKind, FunctionStatement, Statement, StatementKind};
use std::collections::HashMap;
use units::words;

impl Functions {
    /// Functions of a model. `None` if they call each other recursively.
    pub(crate) fn collect(statements: &[Statement], diagnostics: &mut Vec<Diagnostic>) -> Option<Self> {
        let mut declared: Vec<&FunctionStatement> = Vec::new();
        let mut numbers: HashMap<&str, usize> = HashMap::new();
        for statement in statements {
            if let StatementKind::Function(function) = &statement.kind
                // A second one is reported with other duplicate names.
                && !numbers.contains_key(function.name.text.as_str())
            {
                numbers.insert(&function.name.text, declared.len());
                declared.push(function);
                check_parameters(function, diagnostics);
            }
        }
        let calls: Vec<Vec<usize>> = declared.iter().map(|function| called(function, &numbers)).collect();
        let mut functions = Self::default();
        let mut circles = false;
        for block in blocks(&calls) {
            let calls_itself = block.iter().any(|&member| calls[member].iter().any(|called| block.contains(called)));
            if calls_itself {
                diagnostics.push(recursion(&declared, &block));
                circles = true;
            }
            for member in block {
                let FunctionStatement { name, parameters, body, unit } = declared[member];
                let function = Function {
                    name: name.text.clone(),
                    parameters: parameters.iter().map(|parameter| parameter.text.clone()).collect(),
                    body: body.clone(),
                    unit: unit.clone(),
                    span: name.span,
                };
                functions.by_name.insert(name.text.clone(), function);
            }
        }
        if circles { None } else { Some(functions) }
    }
}

/// Indices of the functions called in the body of one, each once.
fn called(function: &FunctionStatement, numbers: &HashMap<&str, usize>) -> Vec<usize> {
    let mut called = Vec::new();
    for_each(&function.body, |part| {
        let name = match &part.kind {
            ExpressionKind::Call { function, .. } => function.text.as_str(),
            ExpressionKind::InitialValue { name, order: 0 } => name,
            _ => return,
        };
        if let Some(&number) = numbers.get(name)
            && !called.contains(&number)
        {
            called.push(number);
        }
    });
    called
}

fn check_parameters(function: &FunctionStatement, diagnostics: &mut Vec<Diagnostic>) {
    let mut used: Vec<&str> = Vec::new();
    for_each_name(&function.body, |name, _, _| {
        // `r.x` is a component of an argument `r` that is a vector.
        let name = split_component(name).map_or(name, |(vector, _)| vector);
        if function.parameters.iter().any(|parameter| parameter.text == name) && !used.contains(&name) {
            used.push(name);
        }
    });
    for (index, parameter) in function.parameters.iter().enumerate() {
        let text = &parameter.text;
        if let Some(first) = function.parameters[..index].iter().find(|earlier| earlier.text == *text) {
            let message = words!("`{text}` is declared twice");
            let diagnostic = Diagnostic::error("duplicate-name", message, parameter.span);
            diagnostics.push(diagnostic.with_label(first.span, words("first declared here")));
        } else if !used.contains(&text.as_str()) {
            let message = words!("the value of `{}` does not depend on its argument `{text}`", function.name.text);
            diagnostics.push(
                Diagnostic::error("unused-argument", message, parameter.span)
                    .with_hint(words("leave it out, here and in the calls")),
            );
        }
    }
}

fn recursion(declared: &[&FunctionStatement], members: &[usize]) -> Diagnostic {
    let name = |&member: &usize| &declared[member].name;
    let hint = words("what is computed again and again from itself is a state: `x' = ...`");
    let (first, others) = members.split_first().map_or((&0, members), |parts| parts);
    let message = if others.is_empty() {
        words!("the function `{}` calls itself", name(first).text)
    } else {
        let names: Vec<String> = members.iter().map(|member| format!("`{}`", name(member).text)).collect();
        words!("the functions {names} call each other in a circle", names = list(&names))
    };
    let mut diagnostic = Diagnostic::error("cycle", message, name(first).span).with_hint(hint);
    for other in others {
        diagnostic = diagnostic.with_label(name(other).span, words("and this"));
    }
    diagnostic
}
