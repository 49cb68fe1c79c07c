//! Preparation of runs side by side.

use super::Compiled;
use super::adaptive_lanes::AdaptiveLanes;
use super::fixed_lanes::FixedLanes;
use super::lanes::{LanesLayout, LanesListing};
use super::listing::Listing;
use super::side_by_side::SideBySide;
use crate::{Routine, Setup, Stepper};
use program::{Model, NodeId};
use std::rc::Rc;

/// Prepares runs of `model` with this setup but other parameters and without presses; `nodes` are read at each row. `compile` makes
/// their code, and `compile_alone` that of a run that continues alone where something happens; it is interpreted if there is none.
/// `None` if the runs must be made one by one: by Rosenbrock's method, by a fixed-step method whose steps can end early, with changes
/// in time that compiled code cannot check, and with what `compile` has no code for.
pub fn side_by_side(
    model: &Model,
    setup: &Setup,
    nodes: &[NodeId],
    compile: impl FnOnce(&LanesListing) -> Option<Rc<dyn Compiled>>,
    compile_alone: impl FnOnce(Listing) -> Option<Rc<dyn Compiled>>,
) -> Option<Box<dyn SideBySide>> {
    if !setup.presses.is_empty() {
        return None;
    }
    let drawn = model.with_drawings(&setup.drawings);
    let model = drawn.as_ref().unwrap_or(model);
    let mut stepper = Stepper::new(model, setup).ok()?;
    let mut steps = stepper.listing().ok().filter(|_| stepper.can_be_beside())?;
    if let Some(window) = &mut steps.window {
        (window.layout.steps, window.layout.rows) = (0, 0);
    }
    let readings = Routine::compile(model, nodes);
    let formulas = readings.formulas(&mut steps.interpolations)?;
    let layout = LanesLayout::new(&steps, &formulas);
    let listing = LanesListing { checked: !stepper.is_smooth(), steps, readings: formulas, layout };
    let code = compile(&listing)?;
    if listing.checked
        && let Some(alone) = stepper.listing().ok().and_then(compile_alone)
    {
        stepper.use_compiled(alone);
    }
    Some(match listing.steps.window {
        Some(window) => Box::new(AdaptiveLanes::new(stepper, readings, code, (layout, window.layout), setup.step)),
        None => Box::new(FixedLanes::new(stepper, readings, code, layout, setup.step)),
    })
}
