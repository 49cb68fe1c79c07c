//! The seat of a student, on which assigned values depend.

use crate::Basis;
use program::Seat;

/// Seat and assignment, for the field of the panel and for hand-ins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SeatView {
    /// Name of the assignment.
    pub assignment: String,
    /// Number of the seat; `None`: the stated values are in force.
    pub number: Option<u32>,
}

impl Basis {
    /// Seat and assignment; `None` if the document assigns no values.
    pub fn seat(&self) -> Option<SeatView> {
        let program = self.program();
        let assignment = program.assignment.clone().filter(|_| program.has_seats())?;
        Some(SeatView { assignment, number: program.seat.map(Seat::number) })
    }
}
