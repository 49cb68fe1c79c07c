//! The equations of motion, ready to be run.

use engine::{Compiler, Run, RunError, Setup, SideBySide};
use program::{Model, NodeId};
use std::rc::Rc;

/// A model with the compiler for its steps.
#[derive(Clone, Copy, Debug)]
pub struct Motion<'a> {
    model: &'a Model,
    /// `None`: steps are interpreted.
    compiler: Option<&'a Rc<dyn Compiler>>,
}

impl<'a> Motion<'a> {
    pub(crate) fn new(model: &'a Model, compiler: Option<&'a Rc<dyn Compiler>>) -> Self {
        Self { model, compiler }
    }

    /// Number of states.
    pub(crate) fn states(&self) -> usize {
        self.model.states.len()
    }

    /// Starts a run.
    pub(crate) fn start(&self, setup: Setup) -> Result<Run, RunError> {
        let mut run = Run::start(self.model, setup)?;
        if let Some(compiler) = self.compiler {
            run.compile(compiler.as_ref());
        }
        Ok(run)
    }

    /// Runs side by side with this setup but other parameters, for which `nodes` are read at each row; `None` if they are made one by
    /// one.
    pub(crate) fn side_by_side(&self, setup: &Setup, nodes: &[NodeId]) -> Option<Box<dyn SideBySide>> {
        self.compiler?.side_by_side(self.model, setup, nodes)
    }
}
