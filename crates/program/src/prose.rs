//! Prose, finished: HTML and MathML that is safe to put into a page.

use serde::{Deserialize, Serialize};

/// A heading and what stands below it, up to the next heading.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Section {
    /// For links: `#doc-activities`. Unique in the document; its prefix keeps it apart from the page's own.
    pub id: String,
    /// The heading as plain text; empty for what stands before the first heading.
    pub title: String,
    /// The heading as HTML, without the `h` element.
    pub heading: String,
    /// 1 to 6; 0 for what stands before the first heading.
    pub level: u8,
    /// What stands below the heading.
    pub blocks: Vec<Block>,
}

/// A piece of a section.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Block {
    /// HTML that is safe to put into a page.
    Html(String),
    /// The place of question `i` of [`crate::Program::questions`].
    Question(usize),
}
