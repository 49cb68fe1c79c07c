//! Whether the zero of the scale is varied as long as a person has not chosen.

use crate::Desk;
use crate::records::recognise::observed;
use crate::records::record::Record;
use program::{Model, Node, NodeId, along};
use units::Dimension;

impl Desk {
    /// Whether the zeros of the clock and of the scale are varied: as chosen, otherwise the scale's where a record needs it.
    pub(super) fn varied_zeros(&self) -> [bool; 2] {
        let [clock, scale] = self.fits.setup.zeros;
        let needed = || self.taking_part().into_iter().filter_map(|id| self.record(id)).any(|one| self.needs_zero(one));
        [clock.unwrap_or(false), scale.unwrap_or_else(needed)]
    }

    /// Whether a record has lengths of a film, whose zero is a click or not known at all, and no varied parameter is that zero.
    fn needs_zero(&self, record: &Record) -> bool {
        let model = self.play.model();
        let Some(used) = record.uses.iter().find(|used| used.fitted) else { return false };
        let varied = self.fits.setup.varied.iter().enumerate().filter(|(_, varied)| **varied);
        self.films.of_record(record.id).is_some()
            && used.meaning.unit.dimension == Dimension::LENGTH
            && observed(model, &used.meaning.quantity).is_some_and(|quantity| {
                !varied.into_iter().any(|(index, _)| shifts(model, quantity.node, index as u32))
            })
    }
}

/// Whether a parameter shifts a quantity by the same amount at all times, so that the data could not tell it from a zero: when the
/// initial values change by constants, which leave all rates the same.
fn shifts(model: &Model, quantity: NodeId, parameter: u32) -> bool {
    let mut graph = model.graph.clone();
    let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
    let is_parameter = |node: Node| (node == Node::Parameter(parameter)).then_some(one);
    let (initial, rates): (Vec<NodeId>, Vec<NodeId>) =
        model.states.iter().map(|state| (state.initial, state.derivative)).unzip();
    let starts = along(&mut graph, &initial, is_parameter);
    let moved = |node: Node| match node {
        Node::State(state) | Node::Initial(state) => starts.get(state as usize).copied(),
        node => is_parameter(node),
    };
    let rates = along(&mut graph, &rates, moved);
    let quantity = along(&mut graph, &[quantity], moved);
    model.events.is_empty()
        && starts.iter().all(|start| graph.as_constant(*start).is_some())
        && rates.iter().all(|rate| *rate == zero)
        && quantity.iter().any(|change| *change != zero && graph.as_constant(*change).is_some())
}
