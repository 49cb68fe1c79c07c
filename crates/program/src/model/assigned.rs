//! Parameters that readers see, and those with values for the seats of a class.

use super::{Model, Parameter};
use crate::{Grid, NodeId};

impl Parameter {
    /// True if readers see the parameter: in controls, values, links, records, exports and as a name in what they type.
    pub fn is_shown(&self) -> bool {
        !self.hidden
    }
}

impl Model {
    /// Parameters that readers see, with their indices.
    pub fn shown_parameters(&self) -> impl Iterator<Item = (usize, &Parameter)> {
        self.parameters.iter().enumerate().filter(|(_, parameter)| parameter.is_shown())
    }

    /// True for a value that gives a hidden parameter away: it depends on one, and not on the run.
    pub fn is_secret(&self, node: NodeId) -> bool {
        let dependence = self.depends(node);
        let hidden = |index: &u32| self.parameters.get(*index as usize).is_some_and(|parameter| parameter.hidden);
        !dependence.varies() && dependence.parameters.iter().any(hidden)
    }

    /// Indices of the parameters with assigned values.
    pub fn assigned_parameters(&self) -> impl Iterator<Item = usize> {
        self.parameters.iter().enumerate().filter(|(_, one)| one.assigned.is_some()).map(|(index, _)| index)
    }

    /// Names and values of the parameters with assigned values.
    pub(crate) fn assigned(&self) -> impl Iterator<Item = (&str, &Grid)> {
        self.parameters.iter().filter_map(|one| Some((one.name.as_str(), &one.assigned.as_ref()?.grid)))
    }
}
