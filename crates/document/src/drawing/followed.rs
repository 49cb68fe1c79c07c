//! Quantities that elements of a drawing can follow, and colours.

use crate::scene::PALETTE;
use program::{Kind, Model, Role};
use units::{Dimension, Unit};

type Named<'a> = (String, Option<String>, &'a Unit);

fn states(model: &Model) -> impl Iterator<Item = Named<'_>> {
    let own = model.states.iter().filter(|state| matches!(state.role, Role::Own | Role::Hidden));
    own.map(|state| (state.name(), state.label.clone(), &state.unit))
}

fn parameters(model: &Model) -> impl Iterator<Item = Named<'_>> {
    let numbers = model.parameters.iter().filter(|parameter| parameter.is_number());
    numbers.map(|one| (one.name.clone(), one.label.clone(), &one.unit))
}

/// Names of states, quantities and parameters of this dimension, in this order, with their labels.
pub fn followed(model: &Model, dimension: Dimension) -> Vec<(String, Option<String>)> {
    let quantities =
        model.quantities.iter().filter(|quantity| !quantity.remembered && quantity.value.kind == Kind::Number);
    let quantities = quantities.map(|one| (one.name.clone(), one.label.clone(), &one.value.unit));
    let all = states(model).chain(quantities).chain(parameters(model));
    all.filter(|(_, _, unit)| unit.dimension == dimension).map(|(name, label, _)| (name, label)).collect()
}

/// Names of quantities that can be dragged, with their labels: states, then numeric parameters.
pub fn draggable(model: &Model) -> Vec<(String, Option<String>)> {
    states(model).chain(parameters(model)).map(|(name, label, _)| (name, label)).collect()
}

/// Names of the colours of the page's theme.
pub fn colours() -> impl Iterator<Item = &'static str> {
    PALETTE.into_iter().map(|(name, _)| name)
}
