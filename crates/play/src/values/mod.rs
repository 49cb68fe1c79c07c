//! Formatted numbers: readouts, values of the scene, table of rows.

mod lines;
mod members;
mod outline;
mod readout;
mod rounding;
mod scene;
mod state;
pub(crate) mod symbol;
mod table;
mod trails;

pub use members::{Index, Members, ReadoutKind};
pub use outline::{Follows, Outline};
pub use readout::Readout;
pub use scene::ShownScene;
pub use state::StateView;
pub use symbol::symbol;

use crate::{Answers, Basis, Changes, TimeLine};
use engine::Readings;
use members::Lines;
use program::{Model, NodeId};
use trails::Trails;

/// Values at the moment shown, of quantities and of the scene, with the magnitudes that decide their digits.
#[derive(Debug)]
pub struct Values {
    lines: Lines,
    quantities: Readings,
    /// Greatest magnitude of each quantity in this run, SI.
    quantity_scales: Vec<f64>,
    scene: Readings,
    /// Values of the scene, SI; computed once per frame.
    scene_values: Vec<f64>,
    /// Greatest magnitude of each value of the scene in this run, SI.
    scene_scales: Vec<f64>,
    /// True if the values of the scene are those of the moment shown.
    scene_is_current: bool,
    trails: Trails,
    /// Outline drawn over the scene.
    outline: Option<Outline>,
}

/// The values as they are shown: of the run, in the chosen language, unless a question hides them.
#[derive(Clone, Copy, Debug)]
pub struct Shown<'a> {
    basis: &'a Basis,
    line: &'a TimeLine,
    answers: &'a Answers,
    values: &'a Values,
}

impl Values {
    /// Values of the program.
    pub(crate) fn new(basis: &Basis) -> Self {
        let model = basis.model();
        Self {
            lines: Lines::of(model),
            quantities: quantities(model),
            quantity_scales: vec![0.0; model.quantities.len()],
            scene: scene(basis),
            scene_values: Vec::new(),
            scene_scales: Vec::new(),
            scene_is_current: false,
            trails: Trails::new(model, basis.scene()),
            outline: None,
        }
    }

    /// The values as they are shown.
    pub(crate) fn shown<'a>(&'a self, basis: &'a Basis, line: &'a TimeLine, answers: &'a Answers) -> Shown<'a> {
        Shown { basis, line, answers, values: self }
    }

    /// Must be called when the language or the model has changed.
    pub(crate) fn basis_changed(&mut self, basis: &Basis) {
        self.quantities = quantities(basis.model());
        self.scene = scene(basis);
        self.trails = Trails::new(basis.model(), basis.scene());
        self.scene_scales.clear();
        self.scene_is_current = false;
    }

    /// Must be called after each change, so that the values of the scene are computed again.
    pub(crate) fn follow(&mut self, changes: &Changes) {
        self.scene_is_current &= !changes.touch(&(Changes::FRAME | Changes::PARAMETERS));
    }

    /// Forgets the magnitudes in the run, because another one replaces it.
    pub(crate) fn forget_run(&mut self) {
        self.quantity_scales.fill(0.0);
        self.scene_scales.clear();
    }

    /// Greatest magnitudes in the run of the quantities and of the values of the scene, SI.
    pub(crate) fn scales(&self) -> [Vec<f64>; 2] {
        [self.quantity_scales.clone(), self.scene_scales.clone()]
    }

    /// Sets the greatest magnitudes to those of the same run in another program.
    pub(crate) fn set_scales(&mut self, [quantities, scene]: [Vec<f64>; 2]) {
        if quantities.len() == self.quantity_scales.len() {
            self.quantity_scales = quantities;
        }
        // Empty until the scene is drawn; its length is then that of the values.
        self.scene_scales = scene;
    }

    /// Takes over the selected members of families from another program.
    pub(crate) fn adopt(&mut self, before: &mut Self) {
        self.lines.choose_as(std::mem::take(&mut before.lines));
    }

    /// Displays another member of a family: sets the index at position `place` to `value`. If that member does not
    /// exist, the next one in the direction of the change.
    pub fn choose_member(&mut self, family: &str, place: usize, value: i64) -> Changes {
        Changes::FRAME.only_if(self.lines.choose(family, place, value))
    }

    /// Sets or removes the outline drawn over the scene.
    pub fn set_outline(&mut self, outline: Option<Outline>) -> Changes {
        self.outline = outline;
        Changes::NONE
    }

    /// Sets the values of the outline for the time shown.
    pub fn set_outline_values(&mut self, values: Option<&[f64]>) -> Changes {
        if let Some(outline) = &mut self.outline {
            match (values, &mut outline.values) {
                (Some(values), Some(old)) => {
                    old.clear();
                    old.extend_from_slice(values);
                }
                (values, old) => *old = values.map(<[f64]>::to_vec),
            }
        }
        Changes::NONE
    }
}

impl<'a> Shown<'a> {
    /// Outline drawn over the scene.
    pub fn outline(self) -> Option<&'a Outline> {
        self.values.outline.as_ref()
    }
}

fn quantities(model: &Model) -> Readings {
    let nodes: Vec<NodeId> = model.quantities.iter().map(|quantity| quantity.value.node).collect();
    Readings::new(model, &nodes)
}

fn scene(basis: &Basis) -> Readings {
    let values = basis.scene().map_or(&[][..], |scene| &scene.values);
    let nodes: Vec<NodeId> = values.iter().map(|value| value.node).collect();
    Readings::new(basis.model(), &nodes)
}
