//! The seat of a student, on which assigned values depend.

use crate::{Announcement, Play, Refusal};
use program::Seat;

/// Seat and assignment, for the field of the panel and for hand-ins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SeatView {
    /// Name of the assignment.
    pub assignment: String,
    /// Number of the seat; `None`: the stated values are in force.
    pub number: Option<u32>,
}

impl Play {
    /// Seat and assignment; `None` if the document assigns no values.
    pub fn seat(&self) -> Option<SeatView> {
        let program = self.program();
        let assignment = program.assignment.clone().filter(|_| program.has_seats())?;
        Some(SeatView { assignment, number: program.seat.map(Seat::number) })
    }

    /// Gives the assigned parameters the values of the seat that is typed, and without a text the stated ones. The runs are
    /// computed again with them.
    ///
    /// # Errors
    ///
    /// A text that is no seat, or a document that assigns no values.
    pub fn set_seat(&mut self, text: &str) -> Result<(), Refusal> {
        let text = text.trim();
        let seat = (!text.is_empty()).then(|| text.parse::<Seat>()).transpose();
        let seat = seat.map_err(|()| Refusal::NoSeat)?;
        let mut program = self.program().clone();
        if !program.set_seat(seat) {
            return Err(Refusal::NoSeat);
        }
        self.replace(program);
        self.announce(Announcement::Seated(seat.map(Seat::number)));
        Ok(())
    }
}
