//! Expressions of the document (scene, plots, presets, answers) against a checked model.

use crate::dimensions::{Form, Inference, Solver, Type, Types};
use crate::lowering::{Chain, Lowered, Lowering, TooManyNodes, too_many_nodes};
use crate::names::{Meaning, NameCheck, Scope, for_each};
use crate::{
    Compiled, Diagnostic, Expression, ExpressionKind, Kind, Model, Node, NodeId, Span, StatedUnit, has_errors,
};
use units::Unit;

/// What a node is computed from. The numbers are sorted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Dependence {
    /// Indices into [`Model::parameters`].
    pub parameters: Vec<u32>,
    /// Indices into [`Model::states`] whose value at the start is used.
    pub initial: Vec<u32>,
    /// Indices into [`Model::states`].
    pub states: Vec<u32>,
    /// Whether the independent variable is used.
    pub independent: bool,
}

impl Dependence {
    /// Whether the value changes during a run in which no parameter is changed.
    pub fn varies(&self) -> bool {
        self.independent || !self.states.is_empty()
    }
}

/// Compiles expressions of a document against its model. What the names of the model mean, and what was derived from
/// them for one expression, is there for the next.
#[derive(Debug)]
pub struct Compiler<'a> {
    model: &'a mut Model,
    scope: Scope,
    types: Types,
    chains: Vec<Chain>,
    lowered: Lowered,
}

impl<'a> Compiler<'a> {
    /// For expressions that are added to the graph of `model`.
    pub fn new(model: &'a mut Model) -> Self {
        let variables = model.variables();
        let (scope, types) = (model.scope(&variables), model.types(&variables));
        let chains = variables.into_iter().map(|(_, chain)| chain).collect();
        let definitions = model.quantities.iter().map(|quantity| Some(quantity.value.node)).collect();
        Self { scope, types, chains, lowered: Lowered::of(definitions), model }
    }

    /// The model, with what has been compiled in its graph.
    pub fn model(&self) -> &Model {
        self.model
    }

    /// Adds an expression of the document to the model's graph. `unit`, where stated, is checked and becomes the
    /// display unit. What could not be parsed is refused without a further word.
    ///
    /// # Errors
    /// Unknown names, mismatching dimensions, and whatever else would be wrong with it inside the model.
    pub fn compile(&mut self, expression: &Expression, unit: Option<&StatedUnit>) -> Result<Compiled, Vec<Diagnostic>> {
        let mut unreadable = false;
        for_each(expression, |part| unreadable |= part.kind == ExpressionKind::Error);
        if unreadable {
            return Err(Vec::new());
        }
        let mut check = NameCheck::new(&self.scope, Vec::new());
        check.expression(expression);
        let mut diagnostics = check.finish();
        let mut inference = Inference {
            scope: &self.scope,
            types: &mut self.types,
            solver: Solver::default(),
            diagnostics: Vec::new(),
        };
        let mut found = inference.expression(expression);
        if let Some(stated) = unit {
            inference.check_stated(expression, &found, stated);
        }
        if let Type::Number(form) = &found {
            // What nothing decides, such as a literal 0, takes the stated unit or is a pure number.
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
        let node = lowering.expression(expression).map_err(|TooManyNodes| vec![too_many_nodes(expression.span)])?;
        let unit = unit
            .map(|stated| stated.unit.clone())
            .or_else(|| match &expression.kind {
                ExpressionKind::Name { name, order } | ExpressionKind::InitialValue { name, order } => {
                    self.model.lookup(name, *order).map(|named| named.unit)
                }
                _ => None,
            })
            .unwrap_or_else(|| Unit::si(found.dimension()));
        Ok(Compiled { node, kind: found.kind(), unit, span: expression.span })
    }
}

impl Model {
    /// Adds a single expression to the graph; for several there is [`Compiler`], which this uses.
    ///
    /// # Errors
    /// Those of [`Compiler::compile`].
    pub fn compile_expression(
        &mut self,
        expression: &Expression,
        unit: Option<&StatedUnit>,
    ) -> Result<Compiled, Vec<Diagnostic>> {
        Compiler::new(self).compile(expression, unit)
    }

    /// The value of a name with `order` primes: a parameter, a state, a highest derivative, a defined quantity, the
    /// independent variable. `None` for an unknown name, and for derivatives that the model does not already have
    /// (primes of defined quantities): these are for [`Compiler::compile`].
    pub fn lookup(&self, name: &str, order: u32) -> Option<Compiled> {
        let number = |node, unit: &Unit, span| Compiled { node, kind: Kind::Number, unit: unit.clone(), span };
        if let Some(index) = self.states.iter().position(|state| state.variable == name && state.order == order) {
            let state = &self.states[index];
            return Some(number(self.graph.find(Node::State(index as u32))?, &state.unit, state.span));
        }
        let (_, chain) = self.variables().into_iter().find(|(variable, _)| *variable == name).unzip();
        if let Some(chain) = chain
            && chain.highest == order
        {
            let state = &self.states[chain.first_state + order as usize - 1];
            let dimension = state.unit.dimension.per(self.independent.unit.dimension)?;
            return Some(number(chain.rate, &Unit::si(dimension), state.span));
        }
        if order > 0 {
            return None;
        }
        if name == self.independent.name {
            return Some(number(self.graph.find(Node::Independent)?, &self.independent.unit, Span::default()));
        }
        if let Some(index) = self.parameters.iter().position(|parameter| parameter.name == name) {
            let parameter = &self.parameters[index];
            return Some(number(self.graph.find(Node::Parameter(index as u32))?, &parameter.unit, parameter.span));
        }
        self.quantities.iter().find(|quantity| quantity.name == name).map(|quantity| quantity.value.clone())
    }

    /// What `node` is computed from.
    pub fn depends(&self, node: NodeId) -> Dependence {
        let mut dependence = Dependence::default();
        for id in self.graph.reachable(&[node]) {
            match self.graph.node(id) {
                Node::Parameter(index) => dependence.parameters.push(index),
                Node::Initial(index) => dependence.initial.push(index),
                Node::State(index) => dependence.states.push(index),
                Node::Independent => dependence.independent = true,
                _ => {}
            }
        }
        for numbers in [&mut dependence.parameters, &mut dependence.initial, &mut dependence.states] {
            numbers.sort_unstable();
        }
        dependence
    }

    /// Whether there are equations of motion, and they and the events are the same at all times: then a run can begin at any
    /// reading of the clock.
    pub fn is_autonomous(&self) -> bool {
        let derivatives = self.states.iter().map(|state| state.derivative);
        let mut nodes = derivatives.chain(self.events.iter().map(|event| event.condition));
        !self.states.is_empty() && !nodes.any(|node| self.depends(node).independent)
    }

    /// The unknown functions by name, in the order of their states.
    fn variables(&self) -> Vec<(&str, Chain)> {
        let mut variables: Vec<(&str, Chain)> = Vec::new();
        for (index, state) in self.states.iter().enumerate() {
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

    fn scope(&self, variables: &[(&str, Chain)]) -> Scope {
        let mut scope = Scope::new(&self.independent.name);
        for (index, parameter) in self.parameters.iter().enumerate() {
            scope.declare(&parameter.name, Meaning::Parameter(index));
        }
        for (index, quantity) in self.quantities.iter().enumerate() {
            scope.declare(&quantity.name, Meaning::Definition(index));
        }
        for (index, (name, _)) in variables.iter().enumerate() {
            scope.declare(name, Meaning::Variable(index));
        }
        scope
    }

    fn types(&self, variables: &[(&str, Chain)]) -> Types {
        let of_quantity = |value: &Compiled| match value.kind {
            Kind::Number => Type::Number(value.unit.dimension.into()),
            Kind::Truth => Type::Truth,
            Kind::Text => Type::Text,
        };
        Types {
            independent: self.independent.unit.dimension.into(),
            parameters: self.parameters.iter().map(|parameter| parameter.unit.dimension.into()).collect(),
            definitions: self.quantities.iter().map(|quantity| of_quantity(&quantity.value)).collect(),
            numbers: self.quantities.iter().map(|quantity| self.graph.as_constant(quantity.value.node)).collect(),
            unknowns: variables.iter().map(|(_, chain)| self.states[chain.first_state].unit.dimension.into()).collect(),
            unknown_names: variables.iter().map(|(name, _)| (*name).to_owned()).collect(),
        }
    }
}
