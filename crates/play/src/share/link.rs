//! Document part of a link. In the fragment it precedes the state of [`Play::share`] and follows the version:
//! `1&d=theories/linear.md&p=gamma:0.4&t=10`.
//!
//! | key | value |
//! |---|---|
//! | `d` | name of a document contained in the page |
//! | `s` | the document itself with its translations, deflated by the browser, in base64url |
//! | `f` | name of the file to be opened first, if the document is too long for a link |
//!
//! Without any of these, the link refers to the document of an exported page. In the laboratory it refers to `utube.md`, with which
//! the laboratory opened when such links were written.
//!
//! [`Play::share`]: crate::Play::share

use crate::Refusal;
use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use units::percent_encoded;

/// Maximum length of a document in a link, in characters of the link. Mail and chat programs break much longer links.
pub const LONGEST_PACKED: usize = 8 << 10;

/// Maximum length of an unpacked document, in bytes. A link of [`LONGEST_PACKED`] could give 25 times as much.
pub const LONGEST_UNPACKED: usize = 256 << 10;

/// Maximum length of the name of a document in a link, in bytes.
const LONGEST_NAME: usize = 200;

/// First field of the fragment: the version of the format.
pub(crate) const VERSION: &str = "1";

/// Document that a link refers to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Subject {
    /// The document that the page opens with.
    Home,
    /// A document contained in the page, by its name.
    Library(String),
    /// The document itself: a list of its files, deflated.
    Packed(Vec<u8>),
    /// A document that the link does not contain, by its file name.
    File(String),
}

/// Document and state of a link.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Link {
    /// The document.
    pub subject: Subject,
    /// State of the document, for [`Play::restore`](crate::Play::restore); empty if the link has none.
    pub state: String,
}

impl Link {
    /// The fragment, without `#`; empty for the page's own document in its original state.
    pub fn write(&self) -> String {
        let subject = match &self.subject {
            Subject::Home => return self.state.clone(),
            Subject::Library(name) => format!("d={}", encode(name)),
            Subject::Packed(bytes) => format!("s={}", URL_SAFE_NO_PAD.encode(bytes)),
            Subject::File(name) => format!("f={}", encode(name)),
        };
        let state = self.state.strip_prefix(VERSION).unwrap_or_default();
        format!("{VERSION}&{subject}{state}")
    }

    /// Parses a fragment. If it names no document, it is taken as a state of the page's own one and checked by
    /// [`Play::restore`](crate::Play::restore).
    ///
    /// # Errors
    ///
    /// A document or a name that is too long or damaged.
    pub fn read(fragment: &str) -> Result<Self, Refusal> {
        let fragment = fragment.trim_start_matches('#');
        let mut fields = fragment.splitn(3, '&');
        let (version, subject, rest) = (fields.next(), fields.next().unwrap_or_default(), fields.next());
        let read = match subject.split_once('=') {
            Some(("d", name)) => decode(name).map(Subject::Library),
            Some(("s", packed)) if packed.len() > LONGEST_PACKED => return Err(Refusal::DocumentTooLong),
            Some(("s", packed)) => URL_SAFE_NO_PAD.decode(packed).ok().map(Subject::Packed),
            Some(("f", name)) => decode(name).map(Subject::File),
            _ => return Ok(Self { subject: Subject::Home, state: fragment.to_owned() }),
        };
        let subject = read.filter(|_| version == Some(VERSION)).ok_or(Refusal::UnreadableState)?;
        let state = rest.map_or_else(String::new, |rest| format!("{VERSION}&{rest}"));
        Ok(Self { subject, state })
    }
}

/// Number of link characters for a number of bytes.
pub fn packed_length(bytes: usize) -> usize {
    bytes.saturating_mul(4).div_ceil(3)
}

/// Percent-encodes a name for a fragment; only the first [`LONGEST_NAME`] bytes of a longer one.
pub(crate) fn encode(name: &str) -> String {
    percent_encoded(&name.as_bytes()[..name.len().min(LONGEST_NAME)])
}

/// Decodes the output of [`encode`]; `None` for an invalid name.
pub(crate) fn decode(text: &str) -> Option<String> {
    let mut bytes = Vec::new();
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        let digit = |byte: Option<u8>| char::from(byte?).to_digit(16);
        let byte = if byte == b'%' { (16 * digit(rest.next())? + digit(rest.next())?) as u8 } else { byte };
        if byte.is_ascii_control() || bytes.len() >= LONGEST_NAME {
            return None;
        }
        bytes.push(byte);
    }
    String::from_utf8(bytes).ok().filter(|name| !name.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_reads_back() {
        for subject in [
            Subject::Home,
            Subject::Library("theories/linear.md".into()),
            Subject::Packed(Vec::new()),
            Subject::Packed((0..=255).collect()),
            Subject::File("my péndulo & 50 % #1.md".into()),
        ] {
            for state in ["", "1&p=b:200&t=10&k&t=3"] {
                let link = Link { subject: subject.clone(), state: state.to_owned() };
                let fragment = link.write();
                assert!(
                    fragment.chars().all(|one| one.is_ascii_alphanumeric() || "-._~!$&'()*+,;=:@/?%".contains(one))
                );
                assert_eq!(Link::read(&fragment), Ok(link.clone()), "{fragment}");
                assert_eq!(Link::read(&format!("#{fragment}")), Ok(link), "{fragment}");
            }
        }
    }

    #[test]
    fn links_of_earlier_versions_are_about_the_pages_own_document() {
        for fragment in ["", "1&p=b:200&t=10", "1&k", "activities", "2&p=b:1"] {
            assert_eq!(Link::read(fragment), Ok(Link { subject: Subject::Home, state: fragment.to_owned() }));
        }
    }

    #[test]
    fn hostile_subjects_are_refused() {
        let long = format!("1&d={}", "a".repeat(LONGEST_NAME + 1));
        for fragment in
            ["1&d=", "1&d=%", "1&d=%G0", "1&d=a%00b", "1&d=%ff", "1&s=@", "1&s=A", "2&d=a.md", "1&f=", &long]
        {
            assert_eq!(Link::read(fragment), Err(Refusal::UnreadableState), "{fragment}");
        }
        let bomb = format!("1&s={}", "A".repeat(LONGEST_PACKED + 1));
        assert_eq!(Link::read(&bomb), Err(Refusal::DocumentTooLong));
        assert_eq!(packed_length(3), 4);
        assert_eq!(packed_length(4), 6);
    }
}
