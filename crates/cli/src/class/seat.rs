//! `--seat`: a run with the values of a seat.

use crate::failure::Failure;
use program::{Program, Seat};
use units::words;

/// Gives the program the values of a seat.
///
/// # Errors
/// A document that assigns no values.
pub fn take_seat(program: &mut Program, seat: Option<Seat>) -> Result<(), Failure> {
    if seat.is_none() || program.set_seat(seat) {
        return Ok(());
    }
    Err(no_seats())
}

/// Failure for a document that assigns no values.
pub fn no_seats() -> Failure {
    Failure::in_words(
        words("the document assigns no values to seats"),
        words(
            "give a parameter values, `parameter b = 0.02 in 0..1 assigned 0.01..0.05 step 0.002`, and the front matter a line \
             `assignment: NAME`",
        ),
    )
}
