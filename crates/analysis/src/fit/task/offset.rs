//! Decision whether a theory has a constant of its own, or needs an offset of the readings.

use program::{Binary, Compiled, Model, Node, NodeId, along};

/// Maximum number of parameters that are shifted together.
const MOST_TOGETHER: usize = 5;

/// True if an offset of the readings of `observed` is a number of its own: none of the `varied` parameters (indices in the
/// model) shifts the quantity by a constant at all times, and no several of them do by the same amount, such as the
/// temperatures of a body and of its surroundings.
pub fn lacks_constant(model: &Model, observed: &Compiled, varied: &[usize]) -> bool {
    let parameter = |index: usize| model.parameters.get(index);
    let alike = |index: &usize| parameter(*index).is_some_and(|own| own.unit.dimension == observed.dimension());
    let alike: Vec<usize> = varied.iter().copied().filter(alike).take(MOST_TOGETHER).collect();
    let together = (1..1_usize << alike.len()).filter(|set| !set.is_power_of_two());
    let chosen =
        |set: usize| (0..alike.len()).filter(|place| set >> place & 1 == 1).map(|place| alike[place]).collect();
    let mut sets = varied.iter().map(|index| vec![*index]).chain(together.map(chosen));
    !sets.any(|set: Vec<usize>| shifts(model, observed.node, &set))
}

/// True if parameters that grow together shift a quantity by a constant at all times. This is the case if they change
/// initial values by constants that leave all rates unchanged.
fn shifts(model: &Model, quantity: NodeId, parameters: &[usize]) -> bool {
    let mut graph = model.graph.clone();
    let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
    let grows = |node: Node| matches!(node, Node::Parameter(index) if parameters.contains(&(index as usize)));
    let own = |node: Node| grows(node).then_some(one);
    let (initial, rates): (Vec<NodeId>, Vec<NodeId>) =
        model.states.iter().map(|state| (state.initial, state.derivative)).unzip();
    let starts = along(&mut graph, &initial, own);
    let moved = |node: Node| match node {
        Node::State(state) | Node::Initial(state) => starts.get(state as usize).copied(),
        node => own(node),
    };
    let rates = along(&mut graph, &rates, moved);
    // A term times 0 adds nothing, although the graph keeps it for values that are not finite.
    let vanishing = |node: Node| matches!(node, Node::Binary(Binary::Multiply, a, b) if [a, b].contains(&zero));
    let quantity = graph.substitute(&[quantity], |_, node| vanishing(node).then_some(zero));
    let quantity = along(&mut graph, &quantity, moved);
    model.events.is_empty()
        && starts.iter().all(|start| graph.as_constant(*start).is_some())
        && rates.iter().all(|rate| *rate == zero)
        && quantity.iter().any(|change| *change != zero && graph.as_constant(*change).is_some())
}
