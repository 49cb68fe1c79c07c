//! State of the browser's storage as known to this page.

use desk::Visit;

/// Contents of the storage as known to this page.
#[derive(Default)]
pub struct Saved {
    /// Items that this page has read or written.
    pub visit: Visit,
    /// True if a delayed save is pending.
    pub is_due: bool,
    /// True if a refusal by the browser has been reported.
    pub refused: bool,
    /// True if the limit of stored documents has been reported.
    pub is_full: bool,
}

/// A stored document as this page saved it last.
#[derive(Clone)]
pub struct Kept {
    /// Name in the storage.
    pub name: String,
    /// Text in the format of `visited::describe`.
    pub text: String,
}

/// Times of the last version and of the last change of the text, in milliseconds.
#[derive(Clone, Copy, Default)]
pub struct VersionTimes {
    /// Time of the last version, in milliseconds.
    pub version: f64,
    /// Time of the last change, in milliseconds.
    pub change: f64,
}
