//! Finished prose: HTML and MathML that are safe to insert into a page.

use serde::{Deserialize, Serialize};

/// A heading and the content below it, up to the next heading.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Section {
    /// Identifier for links: `#doc-activities`. Unique in the document; the prefix separates it from those of the page.
    pub id: String,
    /// Heading as plain text; empty for the content before the first heading.
    pub title: String,
    /// Heading as HTML, without the `h` element.
    pub heading: String,
    /// Level of the heading, 1 to 6; 0 for the content before the first heading.
    pub level: u8,
    /// Content below the heading.
    pub blocks: Vec<Block>,
}

/// A part of a section.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Block {
    /// HTML that is safe to insert into a page.
    Html(String),
    /// Place of question `i` of [`crate::Program::questions`].
    Question(usize),
}
