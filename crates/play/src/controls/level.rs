//! The scene as a scale: where a quantity that can be dragged up and down is 0, and how far a unit of it is.

use super::Grips;
use super::drag::collect_drags;
use crate::PlotId;
use program::{Dragged, Drawing, Node};

/// Scale of the scene for a quantity, in units of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneLevel {
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
    /// Scale of the scene for the quantity of a plot, in the unit of its vertical axis, at the moment shown. `None` unless the first
    /// curve of the plot is a state against the independent variable, and the scene has a handle that moves this state up and down
    /// alone.
    pub fn level_of(&mut self, id: PlotId) -> Option<SceneLevel> {
        let (model, plot) = (self.basis.model(), self.basis.program().plots.get(id.place())?);
        let is_over_time = plot.abscissas().all(|x| model.is_independent(x.value.node));
        let curve = plot.curves.first().filter(|_| is_over_time && matches!(plot.drawing, Drawing::Run))?;
        let Node::State(state) = model.graph.node(curve.value.node) else { return None };
        let unit = &curve.value.unit;
        self.level_in(state as usize, unit.to_si(1.0) - unit.to_si(0.0))
    }

    /// Scale of the scene for the quantity of the first plot that has one.
    pub fn level(&mut self) -> Option<SceneLevel> {
        (0..self.basis.program().plots.len()).find_map(|place| self.level_of(PlotId::at(place)))
    }

    /// `si`: size of the unit of the level in SI units.
    fn level_in(&mut self, state: usize, si: f64) -> Option<SceneLevel> {
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
        let unit = si / up;
        let level = SceneLevel { handle, zero, present, unit };
        ([zero, present, unit].iter().all(|value| value.is_finite()) && unit != 0.0).then_some(level)
    }
}
