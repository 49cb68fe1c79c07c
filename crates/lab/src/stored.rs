//! What this page knows of the browser's storage.

use desk::Shelf;

/// What this page knows of the storage.
#[derive(Default)]
pub struct Saved {
    /// The records.
    pub records: Shelf,
    /// What was said of films.
    pub films: Shelf,
    /// The fits.
    pub fits: Shelf,
    /// The answers to the questions of the document that is open.
    pub answers: Shelf,
    /// Whether something is about to be saved.
    pub is_due: bool,
    /// Whether it has been said that the browser refuses to store anything.
    pub refused: bool,
}
