//! Sender of the work in the page.

use crate::app::App;
use desk::saved::hand_in::Sender;

/// Sender with the seat and the assignment of the simulation. `name`: empty for a report.
pub fn sender(app: App, name: String) -> Sender {
    let seat = app.read_desk(|desk| desk.play().basis().seat());
    let (seat, assignment) = seat.map_or((None, String::new()), |own| (own.number, own.assignment));
    Sender { name, seat, assignment }
}
