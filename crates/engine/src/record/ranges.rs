//! Check that the arguments of tables stay within the range of their points.

use crate::{Notice, NoticeKind, Readings};
use program::{Model, Node, NodeId};
use std::collections::HashMap;

/// The arguments of all table lookups of a model.
#[derive(Clone, Debug)]
pub(crate) struct Ranges {
    arguments: Readings,
    /// Index of the table and its first and last point, per argument.
    tables: Vec<(usize, [f64; 2])>,
    /// Time (SI units) and index of the first table whose argument left its range.
    left: Option<(f64, usize)>,
}

impl Ranges {
    pub fn new(model: &Model) -> Self {
        let graph = &model.graph;
        let numbers: HashMap<u32, usize> =
            model.tables.iter().enumerate().map(|(number, table)| (table.interpolation, number)).collect();
        let rates = model.states.iter().map(|state| state.derivative);
        let quantities = model.quantities.iter().map(|quantity| quantity.value.node);
        let events = model
            .events
            .iter()
            .flat_map(|event| std::iter::once(event.condition).chain(event.actions.iter().map(|(_, value)| *value)));
        let roots: Vec<NodeId> = rates.chain(quantities).chain(events).collect();
        let (mut arguments, mut tables) = (Vec::new(), Vec::new());
        let nodes = if numbers.is_empty() { Vec::new() } else { graph.reachable(&roots) };
        for node in nodes {
            if let Node::Piece(interpolation, argument) = graph.node(node)
                && let Some(&number) = numbers.get(&interpolation)
            {
                arguments.push(argument);
                tables.push((number, graph.interpolations()[interpolation as usize].range()));
            }
        }
        Self { arguments: Readings::new(model, &arguments), tables, left: None }
    }

    /// Checks the arguments at a state.
    pub fn look(&mut self, parameters: &[f64], initial: &[f64], time: f64, state: &[f64]) {
        if self.tables.is_empty() || self.left.is_some() {
            return;
        }
        let arguments = self.arguments.at(parameters, initial, time, state);
        let outside = arguments.iter().zip(&self.tables).find(|(x, (_, [first, last]))| *x < first || *x > last);
        self.left = outside.map(|(_, (table, _))| (time, *table));
    }

    /// Notice of the first table whose argument left its range, if any.
    pub fn notice(&self) -> Option<Notice> {
        self.left.map(|(time, table)| Notice { kind: NoticeKind::OutsideTable(table), time })
    }

    /// Drops a record after `time`.
    pub fn go_back_to(&mut self, time: f64) {
        self.left = self.left.filter(|(left, _)| *left <= time);
    }
}
