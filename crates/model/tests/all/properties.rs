//! Properties of all models: compiling returns, the result is a model or an error, and a model is consistent.

use crate::common::At;
use model::{Severity, has_errors};
use program::{Model, NodeId, Variable, differentiate_all};
use proptest::prelude::*;

/// Statements that fit together often enough that many models are valid.
const STATEMENTS: &[&str] = &[
    "independent t",
    "parameter k = 2",
    "parameter m = 3 in 1..5",
    "parameter g = 9.8 [m/s^2]",
    "parameter k = 2 [N/m]",
    "x(0) = 1",
    "x(0) = k",
    "x'(0) = 0",
    "x'(0) = y(0)",
    "y(0) = 2",
    "y'(0) = x(0)",
    "x(0) = 0.5 [m]",
];

/// Leaves of expressions.
const LEAVES: &[&str] = &[
    "x", "x'", "x''", "y", "y'", "y''", "k", "m", "t", "1", "0", "2.5", "pi", "a", "b", "a'", "x(0)", "a(0)", "g",
    "1 [m]", "\"text\"",
];

fn expression() -> impl Strategy<Value = String> {
    let leaf = prop::sample::select(LEAVES).prop_map(str::to_owned);
    leaf.prop_recursive(4, 24, 3, |inner| {
        let operator = prop::sample::select(&["+", "-", "*", "/", "^", " < ", " and "][..]);
        let function =
            prop::sample::select(&["sin", "cos", "exp", "ln", "sqrt", "abs", "tanh", "sign", "floor", "-", "not "][..]);
        prop_oneof![
            4 => (inner.clone(), operator, inner.clone()).prop_map(|(a, operator, b)| format!("({a}{operator}{b})")),
            2 => (function, inner.clone()).prop_map(|(function, x)| format!("{function}({x})")),
            1 => (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("max({a}, {b})")),
            1 => (inner.clone(), inner.clone(), inner).prop_map(|(a, b, c)| format!("(if {a} > 0 then {b} else {c})")),
        ]
    })
}

fn statement() -> impl Strategy<Value = String> {
    prop_oneof![
        6 => prop::sample::select(STATEMENTS).prop_map(str::to_owned),
        2 => expression().prop_map(|value| format!("a = {value}")),
        2 => expression().prop_map(|value| format!("b = {value}")),
        2 => expression().prop_map(|value| format!("x'' = {value}")),
        2 => expression().prop_map(|value| format!("y' + {value} = x")),
        1 => (expression(), expression()).prop_map(|(left, right)| format!("{left} = {right}")),
        1 => (expression(), expression()).prop_map(|(when, to)| format!("when {when} > 0 {{ x' = {to} }}")),
    ]
}

/// Models without units, so that most of them are valid.
fn sound() -> impl Strategy<Value = String> {
    let leaf = prop::sample::select(&["x", "x'", "y", "k", "m", "t", "1", "2.5", "x(0)"][..]).prop_map(str::to_owned);
    let value = leaf.prop_recursive(4, 24, 3, |inner| {
        let operator = prop::sample::select(&["+", "-", "*", "/"][..]);
        let function = prop::sample::select(&["sin", "cos", "exp", "atan", "abs", "tanh"][..]);
        prop_oneof![
            3 => (inner.clone(), operator, inner.clone()).prop_map(|(a, operator, b)| format!("({a} {operator} {b})")),
            2 => (function, inner.clone()).prop_map(|(function, x)| format!("{function}({x})")),
            1 => (inner.clone(), inner.clone(), inner).prop_map(|(a, b, c)| format!("(if {a} > {b} then {b} else {c})")),
        ]
    });
    (value.clone(), value.clone(), value).prop_map(|(a, b, c)| {
        format!(
            "independent t\nparameter k = 2\nparameter m = 3\nx(0) = 1\nx'(0) = 0.5\ny(0) = -2\n\
             m*x'' = {a} + y'\n(1 + x^2)*y' = {b}\na = {c}\n"
        )
    })
}

fn check_sound(model: &Model) {
    for number in 0..model.graph.len() as u32 {
        model.graph.for_each_operand(NodeId(number), |operand| assert!(operand.0 < number, "operands come first"));
    }
    for state in &model.states {
        let dependence = model.depends(state.initial);
        assert!(!dependence.varies() && dependence.initial.is_empty());
        assert!((state.derivative.0 as usize) < model.graph.len());
        let known = model.lookup(&state.variable, state.order).unwrap();
        assert_eq!(known.unit, state.unit);
    }
    for quantity in &model.quantities {
        assert_eq!(quantity.varies, model.depends(quantity.value.node).varies());
        assert_eq!(model.lookup(&quantity.name, 0).as_ref(), Some(&quantity.value));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_text_gives_a_model_or_an_error(statements in prop::collection::vec(statement(), 0..12)) {
        let source = statements.join("\n");
        let (model, diagnostics) = model::compile(&source, std::slice::from_ref(&(0..source.len())));
    let model = model.map(|checked| checked.model);
        prop_assert_eq!(model.is_none(), has_errors(&diagnostics));
        for diagnostic in &diagnostics {
            let message = &diagnostic.message.english();
            prop_assert!(!message.is_empty() && !message.ends_with('.'), "{message}");
            for label in &diagnostic.labels {
                prop_assert!(source.get(label.span.range()).is_some(), "{:?}", diagnostic);
            }
        }
        if let Some(model) = model {
            check_sound(&model);
        }
    }

    #[test]
    fn sound_models_are_accepted_and_solve_their_equations(source in sound(), t in -2.0..2.0, x in -2.0..2.0, v in -2.0..2.0, y in -2.0..2.0) {
        let (model, diagnostics) = model::compile(&source, std::slice::from_ref(&(0..source.len())));
    let model = model.map(|checked| checked.model);
        let errors = diagnostics.iter().filter(|diagnostic| diagnostic.severity == Severity::Error).count();
        prop_assert_eq!(errors, 0, "{}{}", source, crate::common::render(&source, &diagnostics));
        let mut model = model.unwrap();
        check_sound(&model);
        let at = At::new(&model, t, &[x, v, y]);
        // Residuals of the equations as written.
        for equation in source.lines().filter(|line| line.contains("x''") || line.starts_with("(1 + x^2)")) {
            let (left, right) = equation.split_once(" = ").unwrap();
            let mut value = |text: &str| {
                let (expression, _, _) = model::parse_expression(text, 0..text.len());
                let compiled = model::Compiler::new(&mut model).compile(&expression, None).unwrap();
                at.value(&model.graph, compiled.node)
            };
            let (left, right) = (value(left), value(right));
            let near = (left - right).abs() <= 1e-9 * (1.0 + left.abs() + right.abs());
            prop_assert!(near || !left.is_finite() || !right.is_finite(), "{} {} {}", equation, left, right);
        }
        let rates: Vec<NodeId> = model.states.iter().map(|state| state.derivative).collect();
        for variable in [Variable::State(0), Variable::Parameter(0), Variable::Independent] {
            prop_assert_eq!(differentiate_all(&mut model.graph, &rates, variable).len(), 3);
        }
        check_sound(&model);
    }
}
