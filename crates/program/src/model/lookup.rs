//! Meaning of names, and dependences of values.

use crate::{Choices, Compiled, Kind, Model, Node, NodeId};
use units::Unit;
use units::order::sort;

/// Inputs on which a node depends. Indices are sorted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Dependence {
    /// Indices in [`Model::parameters`].
    pub parameters: Vec<u32>,
    /// Indices in [`Model::states`] whose initial value is used.
    pub initial: Vec<u32>,
    /// Indices in [`Model::states`] whose current value is used.
    pub states: Vec<u32>,
    /// True if the independent variable is used.
    pub independent: bool,
}

impl Dependence {
    /// True if the value changes during a run with constant parameters.
    pub fn varies(&self) -> bool {
        self.independent || !self.states.is_empty()
    }
}

impl Model {
    /// True if a node is the independent variable itself.
    pub fn is_independent(&self, node: NodeId) -> bool {
        self.graph.node(node) == Node::Independent
    }

    /// Value of a name with `order` primes: a parameter, a state, a highest derivative, a defined quantity or the
    /// independent variable. `None` for an unknown name, and for derivatives of defined quantities, which need the compiler
    /// of the language.
    pub fn lookup(&self, name: &str, order: u32) -> Option<Compiled> {
        let number = |node, unit: &Unit| Compiled { node, kind: Kind::Number, unit: unit.clone() };
        let find = |node| self.graph.find(node);
        if let Some(index) = self.states.iter().position(|state| state.variable == name && state.order == order) {
            return Some(number(find(Node::State(index as u32))?, &self.states[index].unit));
        }
        let last = self.states.iter().rfind(|state| state.variable == name);
        if let Some(last) = last.filter(|last| last.order + 1 == order) {
            let dimension = last.unit.dimension.per(self.independent.unit.dimension)?;
            return Some(number(last.derivative, &Unit::si(dimension)));
        }
        if order > 0 {
            return None;
        }
        if name == self.independent.name {
            return Some(number(find(Node::Independent)?, &self.independent.unit));
        }
        if let Some(index) = self.parameters.iter().position(|parameter| parameter.name == name) {
            let parameter = &self.parameters[index];
            let node = find(Node::Parameter(index as u32))?;
            return Some(Compiled { node, kind: parameter.kind(), unit: parameter.unit.clone() });
        }
        self.quantities.iter().find(|quantity| quantity.name == name).map(|quantity| quantity.value.clone())
    }

    /// Value of a name as in [`Self::lookup`], for readers: `None` for a value that they do not see.
    pub fn lookup_shown(&self, name: &str, order: u32) -> Option<Compiled> {
        self.lookup(name, order).filter(|value| !self.is_secret(value.node))
    }

    /// True if runs depend on random draws.
    pub fn is_random(&self) -> bool {
        self.parameters.iter().any(|parameter| parameter.choices == Choices::Seed)
    }

    /// Inputs on which `node` depends.
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
            sort(numbers);
        }
        dependence
    }

    /// True if the model has states, and equations and conditions do not depend on the independent variable: a run can then
    /// start at any time.
    pub fn is_autonomous(&self) -> bool {
        let derivatives = self.states.iter().map(|state| state.derivative);
        let mut nodes = derivatives.chain(self.events.iter().map(|event| event.condition));
        !self.states.is_empty() && !nodes.any(|node| self.depends(node).independent)
    }
}
