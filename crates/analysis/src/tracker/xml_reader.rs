//! Reading of the XML of a project as a stream of nested objects (with a class) and properties (with a name).

use super::builder::Builder;
use super::project::Project;
use super::refusal::TrackerError;
use packed::{Part, Tag, Token, Xml};

/// Greatest length of a text, in bytes; no number, name or array of a project is longer.
const LONGEST_TEXT: usize = 32 << 20;

/// Project being read.
#[derive(Debug)]
pub(super) struct XmlReader {
    xml: Xml,
    /// Names of the open properties and last parts of the classes of the open objects, from the root inwards.
    path: Vec<String>,
    /// Text of the innermost property.
    text: String,
    builder: Builder,
}

impl XmlReader {
    pub fn new(text: Vec<u8>) -> Self {
        let xml = Xml::new(Part::of_text(text));
        Self { xml, path: Vec::new(), text: String::new(), builder: Builder::default() }
    }

    pub fn progress(&self) -> f64 {
        self.xml.progress()
    }

    /// Reads about `budget` more bytes. Returns true if the project is complete.
    pub fn advance(&mut self, budget: usize) -> Result<bool, TrackerError> {
        let end = self.xml.position().saturating_add(budget as u64);
        while self.xml.position() < end {
            match self.xml.next_token()? {
                Token::Open(tag) => {
                    self.path.push(level(&tag)?);
                    self.text.clear();
                    self.builder.open(&names(&self.path))?;
                }
                Token::Close(_) => {
                    self.builder.close(&names(&self.path), self.text.trim())?;
                    self.path.pop();
                    self.text.clear();
                }
                Token::Text(text) if self.text.len() + text.len() > LONGEST_TEXT => return Err(TrackerError::Damaged),
                Token::Text(text) => self.text.push_str(&text),
                Token::UnknownEntity | Token::DocumentType { declares: true } => return Err(TrackerError::Entities),
                Token::DocumentType { declares: false } | Token::Other => {}
                Token::End if self.path.is_empty() => return Ok(true),
                Token::End => return Err(TrackerError::Damaged),
            }
        }
        Ok(false)
    }

    pub fn finish(self) -> Result<Project, TrackerError> {
        self.builder.finish()
    }
}

fn names(path: &[String]) -> Vec<&str> {
    path.iter().map(String::as_str).collect()
}

/// Name of an element in the path. Tracker writes no elements other than properties and objects.
fn level(tag: &Tag<'_>) -> Result<String, TrackerError> {
    match tag.name() {
        "property" => tag.attribute("name").ok_or(TrackerError::Damaged),
        "object" => {
            let class = tag.attribute("class").ok_or(TrackerError::Damaged)?;
            // For example, `org.opensourcephysics.cabrillo.tracker.PointMass$FrameData` becomes `PointMass$FrameData`.
            Ok(class.rsplit('.').next().unwrap_or_default().chars().take(80).collect())
        }
        _ => Err(TrackerError::Damaged),
    }
}
