//! A program with the values of a seat.

use crate::assigned::Draws;
use crate::assigned::seat::BLOCK;
use crate::{Program, Seat};

impl Program {
    /// True if values are assigned to seats: parameters have such values, and the assignment has a name.
    pub fn has_seats(&self) -> bool {
        self.assignment.is_some() && self.model.assigned_parameters().next().is_some()
    }

    /// Gives the assigned parameters the values of a seat, or without a seat the stated ones. Nothing happens, and the result
    /// is false, if the document assigns no values.
    pub fn set_seat(&mut self, seat: Option<Seat>) -> bool {
        let Some(assignment) = self.assignment.as_deref().filter(|_| self.has_seats()) else { return false };
        let drawn = seat.map(|seat| Draws::new(assignment, self.model.assigned()).seat(seat));
        let mut drawn = drawn.into_iter().flatten();
        for parameter in &mut self.model.parameters {
            if let Some(assigned) = &parameter.assigned {
                let value = drawn.next().map(|index| parameter.unit.to_si(assigned.grid.value(index)));
                parameter.value = value.unwrap_or(assigned.stated);
            }
        }
        self.seat = seat;
        true
    }

    /// Values of the first `seats` seats, SI units: for each seat one per assigned parameter. Empty if the document assigns no
    /// values.
    pub fn assigned_values(&self, seats: u32) -> Vec<Vec<f64>> {
        let Some(assignment) = self.assignment.as_deref().filter(|_| self.has_seats()) else { return Vec::new() };
        let mut drawn = Draws::new(assignment, self.model.assigned()).seats(seats.div_ceil(BLOCK));
        drawn.truncate(seats as usize);
        let assigned = |indices: Vec<u32>| {
            let own = self.model.parameters.iter().filter_map(|one| Some((&one.unit, &one.assigned.as_ref()?.grid)));
            own.zip(indices).map(|((unit, grid), index)| unit.to_si(grid.value(index))).collect()
        };
        drawn.into_iter().map(assigned).collect()
    }
}
