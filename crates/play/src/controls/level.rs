//! The scene as a scale: where a quantity that can be dragged up and down is 0, and how far a unit of it is.

use super::Grips;
use super::drag::collect_drags;
use program::Dragged;
use units::Unit;

/// Scale of the scene for a quantity, in units of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// Index of the handle of the quantity among those of the scene.
    pub handle: usize,
    /// Height of the value 0, downwards.
    pub zero: f64,
    /// Height of the present value, downwards.
    pub present: f64,
    /// Way upwards per unit of the quantity.
    pub unit: f64,
}

impl Grips<'_> {
    /// Scale of the scene for a state in this unit, at the moment shown; `None` without a handle that moves it up and down alone.
    pub(crate) fn level(&mut self, state: usize, unit: &Unit) -> Option<Level> {
        let scene = self.basis.scene()?;
        let mut drags = Vec::new();
        collect_drags(&scene.root, &mut drags);
        let is_scale =
            |(_, drag): &(usize, &program::Drag)| drag.target == Dragged::State(state) && drag.zero.is_some();
        let (handle, drag) = drags.into_iter().enumerate().find(is_scale)?;
        let (up, zero) = (drag.up?, drag.zero?);
        let values = self.values.scene_values(self.line.course());
        let (up, zero) = (*values.get(up)?, *values.get(zero)?);
        let present = zero - self.line.course().state().get(state)? / up;
        let unit = (unit.to_si(1.0) - unit.to_si(0.0)) / up;
        let level = Level { handle, zero, present, unit };
        ([zero, present, unit].iter().all(|value| value.is_finite()) && unit != 0.0).then_some(level)
    }
}
