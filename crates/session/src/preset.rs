//! Presets: named sets of parameter values.

use crate::{Refusal, Session};

/// Presets that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct PresetGroup {
    /// The group's name in the session's language; empty for presets without a group.
    pub name: String,
    /// Its presets, in the order of the text.
    pub presets: Vec<PresetView>,
}

/// A preset as its button shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct PresetView {
    /// Which of [`document::Document::presets`].
    pub index: usize,
    /// Its name in the session's language.
    pub name: String,
    /// What it sets, for a tooltip: `rho = 13534 kg/m³`.
    pub description: String,
    /// Whether the parameters have its values.
    pub selected: bool,
}

impl Session {
    /// The presets by group, in the order of the text.
    pub fn presets(&self) -> Vec<PresetGroup> {
        Vec::new()
    }

    /// Sets the parameters of a preset, one after the other; all of them or, when one is refused, none.
    pub fn apply_preset(&mut self, index: usize) -> Result<(), Refusal> {
        let _ = index;
        Ok(())
    }
}
