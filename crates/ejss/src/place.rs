//! Places in a simulation, and reasons with their places.

use crate::refusal::Obstacle;
use units::{Words, words};

/// Part of a simulation, named as in the editor of EJS.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Section {
    /// Title, author, abstract.
    Information,
    /// Description.
    Description,
    /// Tables of variables.
    Variables,
    /// Initialization.
    Initialization,
    /// Evolution.
    Evolution,
    /// Fixed relations.
    FixedRelations,
    /// Custom functions.
    Custom,
    /// Elements of the model.
    Elements,
    /// View.
    View,
}

impl Section {
    /// Its name.
    pub fn words(self) -> Words {
        match self {
            Self::Information => words("Information"),
            Self::Description => words("Description"),
            Self::Variables => words("Variables"),
            Self::Initialization => words("Initialization"),
            Self::Evolution => words("Evolution"),
            Self::FixedRelations => words("Fixed relations"),
            Self::Custom => words("Custom"),
            Self::Elements => words("Elements"),
            Self::View => words("View"),
        }
    }

    /// Identifier in the report for programs.
    pub fn key(self) -> &'static str {
        match self {
            Self::Information => "information",
            Self::Description => "description",
            Self::Variables => "variables",
            Self::Initialization => "initialization",
            Self::Evolution => "evolution",
            Self::FixedRelations => "fixed-relations",
            Self::Custom => "custom",
            Self::Elements => "elements",
            Self::View => "view",
        }
    }
}

/// Line of a page.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Place {
    pub section: Section,
    /// Name of the page or of the element.
    pub page: String,
    /// Line of the page, from 1; `None` for the page as a whole.
    pub line: Option<usize>,
}

impl Place {
    pub fn new(section: Section, page: &str) -> Self {
        Self { section, page: page.to_owned(), line: None }
    }

    pub fn at(&self, line: usize) -> Self {
        Self { line: Some(line), ..self.clone() }
    }
}

/// Reason why something has no counterpart, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Reason {
    pub place: Place,
    pub obstacle: Obstacle,
}

impl Reason {
    /// The reason with its place, as part of a sentence.
    pub fn words(&self) -> Words {
        let (why, section) = (self.obstacle.words(), self.place.section.words());
        match self.place.line {
            Some(line) => words!("{why} ({section}, line {line})"),
            None => words!("{why} ({section})"),
        }
    }
}
