//! Parameters that readers see, and those with values for the seats of a class.

use super::{Model, Parameter};
use crate::Grid;

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

    /// Indices of the parameters with assigned values.
    pub fn assigned_parameters(&self) -> impl Iterator<Item = usize> {
        self.parameters.iter().enumerate().filter(|(_, one)| one.assigned.is_some()).map(|(index, _)| index)
    }

    /// Names and values of the parameters with assigned values.
    pub(crate) fn assigned(&self) -> impl Iterator<Item = (&str, &Grid)> {
        self.parameters.iter().filter_map(|one| Some((one.name.as_str(), &one.assigned.as_ref()?.grid)))
    }
}
