//! All curves of a model that the reader draws.

use crate::Model;

impl Model {
    /// Values of all curves that the reader draws, in the order of the tables; SI units.
    pub fn drawings(&self) -> Vec<Vec<f64>> {
        self.tables.iter().filter_map(|table| Some(table.drawn.as_ref()?.values.clone())).collect()
    }

    /// True if `drawings` has valid values (SI) for all curves that the reader draws: one list each.
    pub fn takes_drawings(&self, drawings: &[Vec<f64>]) -> bool {
        let mut drawn = self.tables.iter().filter_map(|table| table.drawn.as_ref());
        drawn.clone().count() == drawings.len()
            && drawings.iter().all(|values| drawn.next().is_some_and(|own| own.takes(values)))
    }

    /// The model with these curves (SI values, one list each) in place of the present ones; `None` if they are the present ones or are not valid.
    pub fn with_drawings(&self, drawings: &[Vec<f64>]) -> Option<Model> {
        if !self.takes_drawings(drawings) || self.drawings() == drawings {
            return None;
        }
        let mut model = self.clone();
        let drawn = model.tables.iter_mut().enumerate().filter(|(_, table)| table.drawn.is_some());
        for ((number, table), values) in drawn.zip(drawings) {
            let number = number as u32;
            if let Some(own) = &mut table.drawn
                && let Some(curve) = own.curve(values)
            {
                own.values.clone_from(values);
                model.graph.redraw(number, &curve.drawn(number));
            }
        }
        Some(model)
    }
}
