//! Presets: named sets of parameter values.

use super::Controls;
use crate::basis::assigning::assign;
use crate::values::symbol::symbol;
use crate::{Basis, Course};

/// A group of presets.
#[derive(Clone, Debug, PartialEq)]
pub struct PresetGroup {
    /// Name of the group in the chosen language; empty for presets without a group.
    pub name: String,
    /// Presets in the order of the text.
    pub presets: Vec<PresetView>,
}

/// A preset, for its button.
#[derive(Clone, Debug, PartialEq)]
pub struct PresetView {
    /// Index into [`program::Program::presets`].
    pub index: usize,
    /// Name in the chosen language.
    pub name: String,
    /// Assignments of the preset, for a tooltip: `ρ = 13534 kg/m³`.
    pub description: String,
    /// True if the parameters already have the preset's values.
    pub selected: bool,
}

/// Relative tolerance for equal values: values of expressions are rounded.
const SAME: f64 = 1e-9;

impl Controls {
    /// Presets by group, in the order of the text.
    pub fn presets(&self, basis: &Basis, at: &Course) -> Vec<PresetGroup> {
        let mut groups: Vec<(Option<String>, PresetGroup)> = Vec::new();
        for index in 0..basis.program().presets.len() {
            let now = at.parameters().to_vec();
            let then = self.preset_parameters(basis, at, index);
            let Some(preset) = basis.program().presets.get(index) else {
                continue;
            };
            let near = |(now, then): (&f64, &f64)| (now - then).abs() <= SAME * now.abs().max(then.abs());
            let assigned = basis.assigned(&preset.values, &then);
            let assigned: Vec<String> =
                assigned.iter().map(|(name, value)| format!("{} = {value}", symbol(name))).collect();
            let view = PresetView {
                index,
                name: basis.text(&preset.name).to_owned(),
                description: assigned.join(", "),
                selected: now.iter().zip(&then).all(near),
            };
            match groups.last_mut() {
                Some((group, last)) if *group == preset.group => last.presets.push(view),
                _ => {
                    let name = preset.group.as_deref().map_or("", |group| basis.text(group)).to_owned();
                    groups.push((preset.group.clone(), PresetGroup { name, presets: vec![view] }));
                }
            }
        }
        groups.into_iter().map(|(_, group)| group).collect()
    }

    /// Present parameters (SI), with those of a preset.
    pub(crate) fn preset_parameters(&self, basis: &Basis, at: &Course, index: usize) -> Vec<f64> {
        let presets = &basis.program().presets;
        let first = presets.iter().take(index).map(|preset| preset.values.len()).sum();
        let values = presets.get(index).map_or(&[][..], |preset| &preset.values);
        let (mut initial, nothing) = (self.initial.clone(), vec![0.0; basis.model().states.len()]);
        let mut start = |parameters: &[f64]| initial.at(parameters, &nothing, 0.0, &nothing).to_vec();
        assign(&mut self.presets.clone(), first, values, at.parameters(), &mut start)
    }
}
