//! Number of elements and copies of a scene, against its limits.

/// Maximum number of elements and pieces of values in parts, copies and computed lines of a scene.
const DRAWN: usize = 60_000;
/// Maximum number of copies in a scene.
pub const COPIES: usize = 2_000;

/// How much a scene holds so far.
#[derive(Default)]
pub struct Quantity {
    /// Number of elements and pieces of values in parts, copies and computed lines.
    drawn: usize,
    /// Number of copies of repeated elements.
    copied: usize,
    /// Number of repeated elements around the current one.
    repeating: usize,
}

/// Result of an addition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Addition {
    /// All fits.
    Fits,
    /// The limit was passed just now.
    Passes,
    /// The limit was passed before.
    TooMuch,
}

impl Quantity {
    /// Counts `more` elements and pieces of values.
    pub fn draw(&mut self, more: usize) -> Addition {
        let before = self.drawn;
        self.drawn += more;
        match (self.drawn > DRAWN, before > DRAWN) {
            (false, _) => Addition::Fits,
            (true, false) => Addition::Passes,
            (true, true) => Addition::TooMuch,
        }
    }

    /// Counts the copies of a repeated element. Returns false above the limit.
    pub fn copy(&mut self, count: usize) -> bool {
        self.copied = self.copied.saturating_add(count);
        self.copied <= COPIES
    }

    /// Begins a repeated element.
    pub fn begin_repeating(&mut self) {
        self.repeating += 1;
    }

    /// Ends a repeated element.
    pub fn end_repeating(&mut self) {
        self.repeating -= 1;
    }

    /// True inside a repeated element.
    pub fn is_repeating(&self) -> bool {
        self.repeating > 0
    }
}
