//! Expressions of the document (scene, plots, presets, answers) against a checked model.

use crate::{Compiled, Diagnostic, Expression, Model, NodeId, StatedUnit};

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

impl Model {
    /// Adds an expression of the document to the model's graph. `unit`, where stated, is checked and becomes the
    /// display unit.
    ///
    /// # Errors
    /// Unknown names, mismatching dimensions, and whatever else would be wrong with it inside the model.
    pub fn compile_expression(
        &mut self,
        expression: &Expression,
        unit: Option<&StatedUnit>,
    ) -> Result<Compiled, Vec<Diagnostic>> {
        let _ = (expression, unit);
        Err(Vec::new())
    }

    /// The value of a name with `order` primes: a parameter, a state, a highest derivative, a defined quantity, the
    /// independent variable. `None` for an unknown name, and for derivatives that the model does not already have
    /// (primes of defined quantities): these are for [`Model::compile_expression`].
    pub fn lookup(&self, name: &str, order: u32) -> Option<Compiled> {
        let _ = (name, order);
        None
    }

    /// What `node` is computed from.
    pub fn depends(&self, node: NodeId) -> Dependence {
        let _ = node;
        Dependence::default()
    }
}
