//! Default choice of whether the zero of the scale is varied.

use crate::fits::ShownFits;
use crate::fits::fit::Part;
use crate::records::recognise::observed;
use crate::records::record::Use;
use analysis::fit::{Target, Varied};
use program::{Model, Node, NodeId, along};
use units::Dimension;

impl ShownFits<'_> {
    /// Two values, for the zero of the clock and for that of the scale: true if it is varied, as chosen by the user. By
    /// default the clock's is not, and the scale's is if a record needs it.
    pub(super) fn varied_zeros(self) -> [bool; 2] {
        let [clock, scale] = self.fits.setup.zeros;
        let varied = self.fits.setup.varied.iter().enumerate().filter(|(_, varied)| **varied);
        let varied: Vec<usize> = varied.map(|(index, _)| index).collect();
        let needed = || {
            let records = self.taking_part().into_iter().filter_map(|id| self.records.get(id));
            records.into_iter().any(|one| self.needs_zero(self.play.model(), &varied, one.id(), one.uses()))
        };
        [clock.unwrap_or(false), scale.unwrap_or_else(needed)]
    }

    /// True if a fit of another model to these records varies the zero of the scale: if a record needs it and the user
    /// has not fixed it.
    pub(super) fn varied_zero_of(self, model: &Model, varied: &[Varied], parts: &[Part]) -> bool {
        let parameter = |varied: &Varied| match varied.target {
            Target::Parameter(index) => Some(index),
            _ => None,
        };
        let varied: Vec<usize> = varied.iter().filter_map(parameter).collect();
        self.fits.setup.zeros[1] != Some(false)
            && parts.iter().any(|part| self.needs_zero(model, &varied, part.record, &part.uses))
    }

    /// True if the fitted column of a record holds lengths from a film, or from the camera of a virtual measurement, and no varied
    /// parameter can absorb the unknown zero of the scale.
    fn needs_zero(self, model: &Model, varied: &[usize], record: u32, uses: &[Use]) -> bool {
        let Some(used) = uses.iter().find(|used| used.fitted) else { return false };
        let is_virtual = || self.records.get(record).is_some_and(|record| record.truth().is_some());
        (self.films.of_record(record).is_some() || is_virtual())
            && used.meaning.unit.dimension == Dimension::LENGTH
            && observed(model, &used.meaning.quantity)
                .is_some_and(|quantity| !varied.iter().any(|index| shifts(model, quantity.node, *index as u32)))
    }
}

/// True if a parameter shifts a quantity by a constant at all times, so that data cannot distinguish it from a zero of
/// the scale. This is the case if it changes initial values by constants that leave all rates unchanged.
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
