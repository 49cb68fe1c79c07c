//! What the elements of a drawing can follow, and their colours.

use crate::scene::PALETTE;
use program::{Kind, Model, Role, State};
use units::Dimension;

/// The names of states, quantities and parameters of this dimension, in this order, each with its label.
pub fn followed(model: &Model, dimension: Dimension) -> Vec<(String, Option<String>)> {
    let states = model.states.iter().filter(|state| matches!(state.role, Role::Own | Role::Hidden));
    let states = states.map(|state: &State| (state.name(), state.label.clone(), &state.unit));
    let quantities =
        model.quantities.iter().filter(|quantity| !quantity.remembered && quantity.value.kind == Kind::Number);
    let quantities = quantities.map(|one| (one.name.clone(), one.label.clone(), &one.value.unit));
    let parameters = model.parameters.iter().filter(|parameter| parameter.is_number());
    let parameters = parameters.map(|one| (one.name.clone(), one.label.clone(), &one.unit));
    let all = states.chain(quantities).chain(parameters).filter(|(_, _, unit)| unit.dimension == dimension);
    all.map(|(name, label, _)| (name, label)).collect()
}

/// The names of what can follow the hand: states, then parameters that are numbers, each with its label.
pub fn draggable(model: &Model) -> Vec<(String, Option<String>)> {
    let states = model.states.iter().filter(|state| matches!(state.role, Role::Own | Role::Hidden));
    let states = states.map(|state| (state.name(), state.label.clone()));
    let parameters = model.parameters.iter().filter(|parameter| parameter.is_number());
    states.chain(parameters.map(|one| (one.name.clone(), one.label.clone()))).collect()
}

/// The names of the colours of the page's theme.
pub fn colours() -> impl Iterator<Item = &'static str> {
    PALETTE.into_iter().map(|(name, _)| name)
}
