//! XML as a stream of tokens, with bounds on the memory that a hostile file can use.

use crate::Defect;
use crate::part::Part;
use quick_xml::escape::resolve_predefined_entity;
use quick_xml::events::{BytesEnd, BytesRef, BytesStart, Event};
use quick_xml::{Reader, XmlVersion};
use std::borrow::Cow;

/// Greatest depth of nesting; no spreadsheet and no project is deeper.
const DEEPEST: usize = 200;

/// Stream of tokens.
pub struct Xml {
    reader: Reader<Part>,
    buffer: Vec<u8>,
    depth: usize,
}

impl std::fmt::Debug for Xml {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("Xml").field("part", self.reader.get_ref()).finish_non_exhaustive()
    }
}

/// Token. Names are without their prefix.
#[derive(Debug)]
pub enum Token<'a> {
    /// Start of an element.
    Open(Tag<'a>),
    /// End of an element.
    Close(BytesEnd<'a>),
    /// Text with its entities resolved.
    Text(Cow<'a, str>),
    /// Entity other than the five predefined ones of XML and characters by number.
    UnknownEntity,
    /// Document type.
    DocumentType {
        /// True if it declares something of its own.
        declares: bool,
    },
    /// Comment or declaration.
    Other,
    /// End of the text.
    End,
}

impl Token<'_> {
    /// True if it begins the element of this name.
    pub fn opens(&self, name: &str) -> bool {
        matches!(self, Token::Open(tag) if tag.name() == name)
    }

    /// True if it ends the element of this name.
    pub fn closes(&self, name: &str) -> bool {
        matches!(self, Token::Close(tag) if tag.local_name().into_inner() == name)
    }
}

/// Tag that begins an element.
#[derive(Debug)]
pub struct Tag<'a>(BytesStart<'a>);

impl Tag<'_> {
    /// Name of the element.
    pub fn name(&self) -> &str {
        self.0.local_name().into_inner()
    }

    /// Value of an attribute. LibreOffice repeats some attributes of OpenDocument with its own prefix; these are ignored.
    pub fn attribute(&self, name: &str) -> Option<String> {
        let mut attributes = self.0.attributes();
        // Without checks for duplicates, which are slow if a hostile tag has thousands of attributes.
        let mut attributes = attributes.with_checks(false).flatten();
        let own = attributes.find(|attribute| {
            attribute.key.local_name().into_inner() == name
                && attribute.key.prefix().is_none_or(|prefix| prefix.into_inner() != "calcext")
        });
        own?.normalized_value(XmlVersion::Explicit1_0).ok().map(Cow::into_owned)
    }

    /// Value of a numeric attribute; `None` if it is absent or not a number.
    pub fn number(&self, name: &str) -> Option<u32> {
        self.attribute(name)?.trim().parse().ok()
    }
}

impl Xml {
    /// Stream of the tokens of a part.
    pub fn new(part: Part) -> Self {
        let mut reader = Reader::from_reader(part);
        let config = reader.config_mut();
        config.expand_empty_elements = true;
        config.allow_dangling_amp = true;
        config.check_end_names = false;
        Self { reader, buffer: Vec::new(), depth: 0 }
    }

    /// Progress, from 0 to 1.
    pub fn progress(&self) -> f64 {
        self.reader.get_ref().progress()
    }

    /// Number of bytes of XML read.
    pub fn position(&self) -> u64 {
        self.reader.buffer_position()
    }

    /// Next token.
    ///
    /// # Errors
    /// The stream is damaged, a token too long, or the nesting too deep.
    pub fn next_token(&mut self) -> Result<Token<'_>, Defect> {
        self.buffer.clear();
        self.reader.get_mut().begin_token();
        Ok(match self.reader.read_event_into(&mut self.buffer) {
            Ok(Event::Start(_)) if self.depth >= DEEPEST => return Err(Defect::Damaged),
            Ok(Event::Start(tag)) => {
                self.depth += 1;
                Token::Open(Tag(tag))
            }
            Ok(Event::End(tag)) => {
                self.depth = self.depth.saturating_sub(1);
                Token::Close(tag)
            }
            Ok(Event::Text(text)) => Token::Text(text.into_inner()),
            Ok(Event::CData(text)) => Token::Text(text.into_inner()),
            Ok(Event::GeneralRef(name)) => entity(&name).map_or(Token::UnknownEntity, Token::Text),
            Ok(Event::DocType(text)) => Token::DocumentType { declares: text.contains('[') },
            Ok(Event::Eof) => Token::End,
            Ok(_) => Token::Other,
            Err(_) => return Err(self.reader.get_mut().refusal().unwrap_or(Defect::Damaged)),
        })
    }
}

/// Character of an entity: one of the five predefined ones of XML, or a character by number.
fn entity(name: &BytesRef<'_>) -> Option<Cow<'static, str>> {
    match name.resolve_char_ref() {
        Ok(Some(character)) => Some(Cow::Owned(character.to_string())),
        _ => resolve_predefined_entity(name).map(Cow::Borrowed),
    }
}
