//! A second drawing of the scene, with values that others give: the level that was measured beside the one computed.

use crate::Play;

/// What a value of the scene follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Follows {
    /// Nothing that moves by itself: parameters, the time.
    Nothing,
    /// What is measured.
    Measured,
    /// What is only computed, perhaps beside what is measured.
    Computed,
}

/// The scene with other values.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outline {
    /// What each value of the scene follows.
    pub follows: Vec<Follows>,
    /// Where the values come from, for the legend.
    pub sources: Vec<String>,
    /// The values at the time shown; none where there are none at this time.
    pub values: Option<Vec<f64>>,
}

impl Play {
    /// The outline that is drawn over the scene.
    pub fn outline(&self) -> Option<&Outline> {
        self.outline.as_ref()
    }

    /// Draws another outline, or none.
    pub fn set_outline(&mut self, outline: Option<Outline>) {
        self.outline = outline;
    }

    /// Gives the outline the values that hold at the time shown.
    pub fn set_outline_values(&mut self, values: Option<&[f64]>) {
        let Some(outline) = &mut self.outline else { return };
        match (values, &mut outline.values) {
            (Some(values), Some(old)) => {
                old.clear();
                old.extend_from_slice(values);
            }
            (values, old) => *old = values.map(<[f64]>::to_vec),
        }
    }
}
