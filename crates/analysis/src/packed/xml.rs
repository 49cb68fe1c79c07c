//! XML as a stream of tokens, with bounds on what a hostile file can make it hold.

use super::Defect;
use super::part::Part;
use quick_xml::escape::resolve_predefined_entity;
use quick_xml::events::{BytesEnd, BytesRef, BytesStart, Event};
use quick_xml::{Reader, XmlVersion};
use std::borrow::Cow;

/// No spreadsheet and no project nests deeper.
const DEEPEST: usize = 200;

/// A stream of tokens.
pub(crate) struct Xml {
    reader: Reader<Part>,
    buffer: Vec<u8>,
    depth: usize,
}

impl std::fmt::Debug for Xml {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("Xml").field("part", self.reader.get_ref()).finish_non_exhaustive()
    }
}

/// A token. Names are without their prefix.
#[derive(Debug)]
pub(crate) enum Token<'a> {
    Open(Tag<'a>),
    Close(BytesEnd<'a>),
    Text(Cow<'a, str>),
    /// An entity that is none of those every XML has.
    UnknownEntity,
    /// A document type, and whether it declares something of its own.
    DocumentType {
        declares: bool,
    },
    /// A comment or a declaration.
    Other,
    End,
}

impl Token<'_> {
    /// Whether it begins the element of this name.
    pub fn opens(&self, name: &str) -> bool {
        matches!(self, Token::Open(tag) if tag.name() == name)
    }

    /// Whether it ends the element of this name.
    pub fn closes(&self, name: &str) -> bool {
        matches!(self, Token::Close(tag) if tag.local_name().into_inner() == name)
    }
}

/// The tag that begins an element.
#[derive(Debug)]
pub(crate) struct Tag<'a>(BytesStart<'a>);

impl Tag<'_> {
    /// The name of the element.
    pub fn name(&self) -> &str {
        self.0.local_name().into_inner()
    }

    /// An attribute by its name. LibreOffice repeats some of OpenDocument with a prefix of its own; those are passed over.
    pub fn attribute(&self, name: &str) -> Option<String> {
        let mut attributes = self.0.attributes();
        // Comparing every name with all others takes too long where a hostile tag has thousands.
        let mut attributes = attributes.with_checks(false).flatten();
        let own = attributes.find(|attribute| {
            attribute.key.local_name().into_inner() == name
                && attribute.key.prefix().is_none_or(|prefix| prefix.into_inner() != "calcext")
        });
        own?.normalized_value(XmlVersion::Explicit1_0).ok().map(Cow::into_owned)
    }

    /// An attribute that is a number; `None` where it is absent or none.
    pub fn number(&self, name: &str) -> Option<u32> {
        self.attribute(name)?.trim().parse().ok()
    }
}

impl Xml {
    pub fn new(part: Part) -> Self {
        let mut reader = Reader::from_reader(part);
        let config = reader.config_mut();
        config.expand_empty_elements = true;
        config.allow_dangling_amp = true;
        config.check_end_names = false;
        Self { reader, buffer: Vec::new(), depth: 0 }
    }

    /// Which part of the stream has been read, from 0 to 1.
    pub fn progress(&self) -> f64 {
        self.reader.get_ref().progress()
    }

    /// How many bytes of XML have been read.
    pub fn position(&self) -> u64 {
        self.reader.buffer_position()
    }

    /// The next token.
    ///
    /// # Errors
    /// What is damaged, too long or nested too deeply.
    pub fn next(&mut self) -> Result<Token<'_>, Defect> {
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

/// What an entity stands for: one of the five of XML, or a character by its number.
fn entity(name: &BytesRef<'_>) -> Option<Cow<'static, str>> {
    match name.resolve_char_ref() {
        Ok(Some(character)) => Some(Cow::Owned(character.to_string())),
        _ => resolve_predefined_entity(name).map(Cow::Borrowed),
    }
}
