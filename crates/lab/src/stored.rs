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
    /// Whether it has been said that there is no room for one more document.
    pub is_full: bool,
}

/// A document in the storage, as this page has left it there.
#[derive(Clone)]
pub struct Kept {
    /// Its name.
    pub name: String,
    /// Its text, as `visited::describe` gives it.
    pub text: String,
}

/// When a version of the text was made and when the text was changed last, in milliseconds.
#[derive(Clone, Copy, Default)]
pub struct VersionTimes {
    /// The version.
    pub version: f64,
    /// The change.
    pub change: f64,
}
