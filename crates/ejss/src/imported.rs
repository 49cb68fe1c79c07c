//! Result of an import.

use crate::originals::Original;
use crate::report::Report;
use units::{Language, Words};

/// Document made of a simulation.
#[derive(Clone, Debug)]
pub struct Imported {
    /// Text of the document.
    pub document: String,
    /// Title of the simulation.
    pub title: String,
    /// Language of its description.
    pub language: Language,
    /// Report of the parts that are missing or differ.
    pub report: Report,
    /// Reason why the model is listed and not translated.
    pub listed_because: Option<Words>,
    /// Source of each quantity of a translated model.
    pub originals: Vec<Original>,
}
