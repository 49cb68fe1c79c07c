//! The ghost: the scene with the measured values in place of the computed ones.

use crate::Session;
use engine::Routine;
use program::{Graph, Node};

/// What a value of the scene follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Follows {
    /// Nothing that moves by itself: parameters, the time.
    Nothing,
    /// What is measured.
    Measured,
    /// What is only computed, perhaps beside what is measured.
    Computed,
}

/// What evaluates the scene with measured values.
#[derive(Debug)]
pub(crate) struct Ghost {
    routine: Routine,
    /// Which of the measured columns are put in.
    columns: Vec<usize>,
    /// What each value of the scene follows.
    follows: Vec<Follows>,
    /// The parameters, and after them the measured values.
    inputs: Vec<f64>,
    values: Vec<f64>,
}

impl Session {
    /// What each value of the scene follows; empty when none follows a measurement. Only positions count: the level is
    /// what a film shows.
    pub fn ghost_follows(&self) -> &[Follows] {
        self.data.ghost.as_ref().map_or(&[], |ghost| &ghost.follows)
    }

    /// The names of the records that the outline in the scene follows; empty when there is no outline.
    pub fn ghost_records(&self) -> Vec<String> {
        let Some(ghost) = &self.data.ghost else { return Vec::new() };
        let ids = ghost.columns.iter().filter_map(|column| Some(self.data.measured.get(*column)?.record));
        let mut names: Vec<String> = ids.filter_map(|id| Some(self.record(id)?.name.clone())).collect();
        names.dedup();
        names
    }

    /// The values of the scene as the measurement has them at the time shown; none before, after or in a gap of it.
    pub fn ghost_values(&mut self) -> Option<&[f64]> {
        let time = self.course.time();
        let ghost = self.data.ghost.as_mut()?;
        ghost.inputs.clear();
        ghost.inputs.extend_from_slice(self.course.parameters());
        for column in &ghost.columns {
            ghost.inputs.push(self.data.measured.get(*column)?.at(time)?);
        }
        ghost.routine.prepare(&ghost.inputs, self.course.initial());
        ghost.routine.evaluate(time, self.course.state(), &mut ghost.values);
        Some(&ghost.values)
    }

    /// The ghost of what is measured now.
    pub(crate) fn make_ghost(&self) -> Option<Ghost> {
        let model = self.model();
        let scene = self.document.program.scene(&self.tag)?;
        let roots: Vec<_> = scene.values.iter().map(|value| value.node).collect();
        let (mut columns, mut inputs) = (Vec::new(), Vec::new());
        for (index, measured) in self.data.measured.iter().enumerate() {
            let node = measured.observed.node;
            if !measured.name.ends_with('\'') && inputs.iter().all(|(other, _)| *other != node) {
                inputs.push((node, Node::Parameter((model.parameters.len() + columns.len()) as u32)));
                columns.push(index);
            }
        }
        let mut graph = Graph::default();
        let roots = model.graph.rebuild_from_inputs(&mut graph, &roots, &inputs);
        let follows = |root| {
            let reached = graph.reachable(&[root]);
            let any = |test: &dyn Fn(Node) -> bool| reached.iter().any(|id| test(graph.node(*id)));
            if any(&|node| matches!(node, Node::State(_))) {
                Follows::Computed
            } else if any(&|node| inputs.iter().any(|(_, input)| *input == node)) {
                Follows::Measured
            } else {
                Follows::Nothing
            }
        };
        let follows: Vec<Follows> = roots.iter().map(|root| follows(*root)).collect();
        follows.contains(&Follows::Measured).then(|| Ghost {
            routine: Routine::from_graph(&graph, model.states.len(), &roots),
            columns,
            values: vec![0.0; follows.len()],
            follows,
            inputs: Vec::new(),
        })
    }
}
