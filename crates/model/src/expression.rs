//! Expressions of the document (scene, plots, presets, answers) against a checked model.

use crate::dimensions::{Alike, Form, Inference, Solver, Type, Types};
use crate::families::{Bindings, expression_without_families, whole_number};
use crate::functions::{Budget, Functions};
use crate::lowering::{Chain, Lowered, Lowering, TooManyNodes, frictions, own_unit, too_many_nodes, turned};
use crate::names::{Meaning, NameCheck, Scope, for_each};
use crate::notation::primed;
use crate::tables::TableFunction;
use crate::vectors::Vectors;
use crate::{Diagnostic, Expression, ExpressionKind, Over, Span, StatedUnit, has_errors};
use program::{Choices, Compiled, Graph, Kind, Model};
use std::borrow::Cow;
use std::ops::RangeInclusive;
use std::sync::Arc;
use units::{Unit, words};

/// Compiles expressions of a document against its model. Scope, types and lowered nodes are kept from one expression to the
/// next.
#[derive(Debug)]
pub struct Compiler<'a> {
    pub(crate) model: &'a mut Model,
    pub(crate) scope: Scope,
    pub(crate) types: Types,
    chains: Vec<Chain>,
    lowered: Lowered,
    functions: Functions,
    indices: Bindings,
    pub(crate) vectors: Vectors,
    /// Limit for the expansion of function calls.
    budget: Budget,
}

impl<'a> Compiler<'a> {
    /// Compiler for expressions that are added to the graph of `model`.
    pub fn new(model: &'a mut Model) -> Self {
        let variables = variables(model);
        let (scope, types) = (scope(model, &variables), types(model, &variables));
        let chains = variables.into_iter().map(|(_, chain)| chain).collect();
        let definitions = model.quantities.iter().map(|quantity| Some(quantity.value.node)).collect();
        let lowered = Lowered::of(definitions);
        let (functions, indices) = (Functions::default(), Bindings::default());
        let vectors = Vectors::of_names(scope.names());
        let budget = Budget::of_document();
        Self { scope, types, chains, lowered, functions, indices, vectors, budget, model }
    }

    /// Adds the user-defined functions, which the expressions may then call.
    #[must_use]
    pub fn with(mut self, functions: &Functions) -> Self {
        self.scope.declare_functions(functions.names());
        self.functions = functions.clone();
        self
    }

    /// The model, including the nodes compiled so far.
    pub fn model(&self) -> &Model {
        self.model
    }

    /// Binds an index to a value in the expressions that follow, until [`Self::unbind`].
    pub fn bind(&mut self, index: &str, value: i64) {
        self.indices.push(index, value);
    }

    /// Removes the last binding.
    pub fn unbind(&mut self) {
        self.indices.pop();
    }

    /// Integers of a range, both ends included, under the current bindings.
    ///
    /// # Errors
    /// If an end is not composed of integers, sizes and indices.
    pub fn range(&self, over: &Over) -> Result<RangeInclusive<i64>, Box<Diagnostic>> {
        let end = |end| whole_number(end, &self.model.sizes, &self.indices);
        Ok(end(&over.low)?..=end(&over.high)?)
    }

    /// Graph of the model, for operations on compiled values.
    pub fn graph(&mut self) -> &mut Graph {
        &mut self.model.graph
    }

    /// Name with primes, if the expression is a name: `x[3]` for `x[i+1]` while i is 2.
    pub fn name_of(&self, expression: &Expression) -> Option<String> {
        let (written, _) = expression_without_families(expression, &self.model.sizes, &self.indices);
        match &written.kind {
            ExpressionKind::Name { name, order } => Some(primed(name, *order)),
            _ => None,
        }
    }

    /// Adds an expression of the document to the graph of the model. `unit`, if stated, is checked and becomes the display
    /// unit. An expression with a syntax error fails without a further diagnostic.
    ///
    /// # Errors
    /// Unknown names, mismatching dimensions, and every other error of an expression in a model.
    pub fn compile(&mut self, expression: &Expression, unit: Option<&StatedUnit>) -> Result<Compiled, Vec<Diagnostic>> {
        let written = self.single(expression)?;
        let number = self.vectors.number(&written)?;
        self.compile_number(&number, unit)
    }

    /// Compiles each component of a vector; a number is its own single component.
    ///
    /// # Errors
    /// As in [`Self::compile`].
    pub fn compile_components(&mut self, expression: &Expression) -> Result<Vec<Compiled>, Vec<Diagnostic>> {
        let written = self.single(expression)?;
        let components = self.vectors.components(&written)?;
        components.iter().map(|component| self.compile_number(component, None)).collect()
    }

    /// Expands calls of user-defined functions and members of families.
    pub(crate) fn single<'e>(&mut self, expression: &'e Expression) -> Result<Cow<'e, Expression>, Vec<Diagnostic>> {
        let mut found = Vec::new();
        let called = self.functions.expanded(expression, &mut self.budget, &mut found);
        if has_errors(&found) {
            return Err(found);
        }
        let (written, found) = match called {
            Cow::Borrowed(called) => expression_without_families(called, &self.model.sizes, &self.indices),
            Cow::Owned(called) => {
                let (written, found) = expression_without_families(&called, &self.model.sizes, &self.indices);
                (Cow::Owned(written.into_owned()), found)
            }
        };
        let mut unreadable = false;
        for_each(&written, |part| unreadable |= part.kind == ExpressionKind::Error);
        if unreadable || has_errors(&found) {
            return Err(found);
        }
        Ok(written)
    }

    pub(crate) fn compile_number(
        &mut self,
        expression: &Expression,
        unit: Option<&StatedUnit>,
    ) -> Result<Compiled, Vec<Diagnostic>> {
        if !frictions(expression).is_empty() {
            let message = words("dry friction has a value in the model only");
            let diagnostic = Diagnostic::error("friction-outside", message, expression.span)
                .with_hint(words("give it a name there, as in `F_r = coulomb(x', mu*m*g)`, and use that"));
            return Err(vec![diagnostic]);
        }
        let mut check = NameCheck::outside_model(&self.scope);
        check.expression(expression);
        let mut diagnostics = check.finish();
        let mut inference = Inference {
            scope: &self.scope,
            types: &mut self.types,
            solver: Solver::default(),
            alike: Alike::default(),
            diagnostics: Vec::new(),
        };
        let mut found = inference.expression(expression);
        if let Some(stated) = unit {
            inference.check_stated(expression, &found, stated);
        }
        if let Type::Number(form) = &found {
            // An expression without a definite dimension, such as a literal 0, takes the stated unit or is dimensionless.
            found =
                Type::Number(inference.solver.resolve(form).map_or_else(|_| Form::pure(), |form| form.known.into()));
        }
        diagnostics.append(&mut inference.diagnostics);
        if has_errors(&diagnostics) {
            return Err(diagnostics);
        }
        let Model { graph, texts, .. } = &mut *self.model;
        let mut lowering =
            Lowering { graph, texts, scope: &self.scope, chains: &self.chains, known: &mut self.lowered };
        let mut node = lowering.expression(expression).map_err(|TooManyNodes| vec![too_many_nodes(expression.span)])?;
        let model = &*self.model;
        let own = own_unit(expression, &|name, order| Some(Cow::Owned(model.lookup(name, order)?.unit)));
        let own = own.map(Cow::into_owned);
        if let (Some(own), Some(stated)) = (&own, unit) {
            node = turned(&mut self.model.graph, node, own, &stated.unit);
        }
        // Numbers are shown in SI units, unless they count turns.
        let is_name = matches!(expression.kind, ExpressionKind::Name { .. } | ExpressionKind::InitialValue { .. });
        let unit = unit
            .map(|stated| stated.unit.clone())
            .or_else(|| own.filter(|own| is_name || own.counts_turns() && !own.dimension.is_none()))
            .unwrap_or_else(|| Unit::si(found.dimension()));
        Ok(Compiled { node, kind: found.kind(), unit })
    }

    /// A constant node without a unit.
    pub fn constant(&mut self, value: f64, kind: Kind) -> Compiled {
        Compiled { node: self.model.graph.constant(value), kind, unit: Unit::dimensionless() }
    }

    /// The value divided by its display unit, as a dimensionless number.
    pub fn in_its_unit(&mut self, value: &Compiled) -> Compiled {
        let graph = &mut self.model.graph;
        let unit = graph.constant(value.unit.factor);
        Compiled { node: graph.divide(value.node, unit), kind: value.kind, unit: Unit::dimensionless() }
    }
}

/// The unknown functions by name, in the order of their states.
fn variables(model: &Model) -> Vec<(&str, Chain)> {
    let mut variables: Vec<(&str, Chain)> = Vec::new();
    for (index, state) in model.states.iter().enumerate() {
        if state.order == 0 {
            let chain = Chain { first_state: index, highest: 0, rate: state.derivative };
            variables.push((&state.variable, chain));
        }
        if let Some((_, chain)) = variables.last_mut() {
            chain.highest = state.order + 1;
            chain.rate = state.derivative;
        }
    }
    variables
}

fn scope(model: &Model, variables: &[(&str, Chain)]) -> Scope {
    let mut scope = Scope::new(&model.independent.name);
    for (index, parameter) in model.parameters.iter().enumerate() {
        scope.declare(&parameter.name, Meaning::Parameter(index));
        scope.declare_label(&parameter.name, parameter.label.as_deref());
        if let Choices::Texts(_) = parameter.choices {
            let texts = parameter.words(&model.texts).into_iter().map(str::to_owned).collect();
            scope.declare_choice(&parameter.name, texts);
        }
    }
    for table in &model.tables {
        if let Some(interpolation) = model.graph.interpolations().get(table.interpolation as usize) {
            let function = TableFunction {
                argument_name: table.argument.clone(),
                argument: table.argument_unit.dimension,
                value: table.unit.dimension,
                interpolation: Arc::clone(interpolation),
                drawn: None,
                span: Span::default(),
            };
            scope.declare_table(&table.name, function);
        }
    }
    for (index, quantity) in model.quantities.iter().enumerate() {
        scope.declare(&quantity.name, Meaning::Definition(index));
        scope.declare_label(&quantity.name, quantity.label.as_deref());
    }
    for state in &model.states {
        scope.declare_label(&primed(&state.variable, state.order), state.label.as_deref());
    }
    for (index, (name, _)) in variables.iter().enumerate() {
        scope.declare(name, Meaning::Variable(index));
    }
    scope
}

fn types(model: &Model, variables: &[(&str, Chain)]) -> Types {
    let of_quantity = |value: &Compiled| match value.kind {
        Kind::Number => Type::Number(value.unit.dimension.into()),
        Kind::Truth => Type::Truth,
        Kind::Text => Type::Text,
    };
    Types {
        independent: model.independent.unit.dimension.into(),
        parameters: model.parameters.iter().map(|parameter| parameter.unit.dimension.into()).collect(),
        parameter_places: Vec::new(),
        parameter_kinds: model.parameters.iter().map(program::Parameter::kind).collect(),
        definitions: model.quantities.iter().map(|quantity| of_quantity(&quantity.value)).collect(),
        numbers: model.quantities.iter().map(|quantity| model.graph.as_constant(quantity.value.node)).collect(),
        unknowns: variables.iter().map(|(_, chain)| model.states[chain.first_state].unit.dimension.into()).collect(),
        unknown_names: variables.iter().map(|(name, _)| (*name).to_owned()).collect(),
    }
}
