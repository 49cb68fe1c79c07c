//! Reasons why a file cannot be opened, and why a part of it is not carried over.

use units::{Words, words};

/// Reason why a file gives no document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// It is longer than the limit, in bytes.
    TooLarge,
    /// It has more elements of the view, or is nested deeper, than the limits.
    TooComplex,
    /// It is no simulation of EJS or WebEJS.
    Unknown,
    /// It is an exported page: it has no source.
    ExportedPage,
    /// An archive without a source.
    NoSource,
    /// Its source is protected by a password.
    Protected,
    /// The archive has a file whose name leads out of its folder.
    Path(String),
    /// The archive cannot be read.
    Damaged,
    /// The source ends early, or is no JSON where it should be.
    Broken,
}

impl Refusal {
    /// The reason, and what to do.
    pub fn words(&self) -> Words {
        match self {
            Self::TooLarge => words!("The file is longer than 20 MB. No simulation of this size can be opened."),
            Self::TooComplex => {
                words!(
                    "The simulation has more than 2000 elements, or they are nested more than 64 deep. It cannot be opened."
                )
            }
            Self::Unknown => words!(
                "This is no simulation of Easy JavaScript Simulations. What can be opened: .ejss, _source.json, and a ZIP archive with one of these."
            ),
            Self::ExportedPage => words!(
                "This is an exported page. Its source is the file .ejss of the same name: in the folder `source` of Easy JavaScript Simulations, or in the ZIP archive that the library offers for download."
            ),
            Self::NoSource => words!(
                "The archive has no source. What can be opened has a file .ejss or _source.json in it; a Java archive has its source in the file .ejs of the author."
            ),
            Self::Protected => words!("The source is protected by a password. Ask its author for a copy without one."),
            Self::Path(name) => {
                words!("The archive is refused: the name `{name}` leads out of its folder. Pack the simulation again.")
            }
            Self::Damaged => words!("The archive is damaged. Download or pack it once more."),
            Self::Broken => words!("The file is incomplete or damaged. Save the simulation once more in its editor."),
        }
    }
}

/// Code that cannot be read, with its line from 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Unreadable {
    pub line: usize,
    pub obstacle: Obstacle,
}

impl Unreadable {
    pub fn new(line: usize, obstacle: Obstacle) -> Self {
        Self { line, obstacle }
    }
}

/// Reason why a piece of code has no counterpart.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Obstacle {
    /// A sign or word that is not understood.
    Sign(String),
    /// The code ends in the middle.
    End,
    /// Nested too deeply or too long.
    TooLong,
    /// It reads or changes the view or the page.
    View(String),
    /// A loop.
    Loop,
    /// An array.
    Array(String),
    /// `^`, `&`, `|` and shifts, which work on the bits of integers.
    Bits,
    /// `Math.random`.
    Random,
    /// A name that is declared nowhere.
    Name(String),
    /// A function that is not known or not readable.
    Call(String),
    /// A function calls itself.
    Recursion(String),
    /// A variable has no value there.
    NoValue(String),
    /// A variable needs its own value of the step before.
    Past(String),
    /// A variable is computed in two places in different ways.
    TwoWays(String),
    /// A text is put together where a number or a constant text is needed.
    Text,
    /// Numbers, texts and truth values are mixed.
    Kinds,
    /// Code writes a state, the time or the step.
    WritesState(String),
    /// Statement without a counterpart, such as `try`.
    Statement(String),
}

impl Obstacle {
    /// The reason as part of a sentence.
    pub fn words(&self) -> Words {
        match self {
            Self::Sign(sign) => words!("`{sign}` is not understood there"),
            Self::End => words!("the code ends in the middle"),
            Self::TooLong => words!("it is too long or too deeply nested"),
            Self::View(name) => words!("it uses the page or the view (`{name}`)"),
            Self::Loop => words!("it has a loop"),
            Self::Array(name) => words!("`{name}` is an array"),
            Self::Bits => {
                words!("`^`, `&`, `|` and shifts work on the bits of whole numbers; `^` is no power in JavaScript")
            }
            Self::Random => words!("it draws a random number"),
            Self::Name(name) => words!("`{name}` is declared nowhere"),
            Self::Call(name) => words!("the function `{name}` cannot be translated"),
            Self::Recursion(name) => words!("the function `{name}` calls itself"),
            Self::NoValue(name) => words!("`{name}` has no value there"),
            Self::Past(name) => words!("`{name}` needs its own value of the step before"),
            Self::TwoWays(name) => words!("`{name}` is computed in two places in different ways"),
            Self::Text => words!("it puts a text together"),
            Self::Kinds => words!("it mixes numbers, texts and truth values"),
            Self::WritesState(name) => words!("it sets `{name}`, which the equations of motion determine"),
            Self::Statement(word) => words!("`{word}` has no counterpart"),
        }
    }
}
