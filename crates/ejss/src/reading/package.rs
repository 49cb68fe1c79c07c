//! A ZIP archive in which a simulation travels with its pictures.

use super::encoding::decoded;
use super::format::Format;
use super::limits::MOST_BYTES;
use crate::refusal::Refusal;
use base64::Engine as _;
use packed::{Archive, Defect};

/// Greatest size of a picture, in bytes.
const MOST_PICTURE: usize = 150 << 10;
/// Number of bytes expanded at once.
const PORTION: usize = 1 << 20;

/// Files beside a simulation; none if it came alone.
#[derive(Debug)]
pub(crate) struct Files {
    archive: Option<Archive>,
}

impl Files {
    /// The files of an archive; none for any other file.
    ///
    /// # Errors
    /// The archive is damaged, or one of its names leads out of its folder.
    pub fn open(bytes: &[u8]) -> Result<Self, Refusal> {
        if !packed::is_archive(bytes) {
            return Ok(Self { archive: None });
        }
        let archive = Archive::open(bytes.to_vec()).map_err(|_| Refusal::Damaged)?;
        if let Some(name) = archive.names().find(|name| leads_out(name)) {
            return Err(Refusal::Path(name.chars().filter(|letter| !letter.is_control()).take(60).collect()));
        }
        Ok(Self { archive: Some(archive) })
    }

    /// True if there is a source in the archive.
    pub fn has_source(&self) -> bool {
        self.archive.as_ref().is_some_and(|archive| newest(archive).is_some())
    }

    /// Text of the newest source in the archive with its format; `None` without an archive.
    ///
    /// # Errors
    /// There is no source, or it cannot be expanded.
    pub fn source(&self) -> Result<Option<(String, Format)>, Refusal> {
        let Some(archive) = &self.archive else { return Ok(None) };
        let (name, format) = newest(archive).ok_or(Refusal::NoSource)?;
        let bytes = expanded(archive, name, MOST_BYTES).map_err(|defect| match defect {
            Defect::Protected => Refusal::Protected,
            Defect::Expands { .. } => Refusal::TooLarge,
            Defect::Damaged => Refusal::Damaged,
        })?;
        Ok(Some((decoded(&bytes), format)))
    }

    /// A picture as the address of an image, `data:image/png;base64,..`. `path`: as an HTML page names it.
    pub fn picture(&self, path: &str) -> Option<String> {
        let archive = self.archive.as_ref()?;
        let path = path.trim_start_matches("./").trim_start_matches('/');
        let ends = |name: &&str| *name == path || name.ends_with(&format!("/{path}"));
        let bytes = expanded(archive, archive.names().find(ends)?, MOST_PICTURE).ok()?;
        let kind = match bytes.as_slice() {
            [0x89, b'P', b'N', b'G', ..] => "png",
            [0xff, 0xd8, 0xff, ..] => "jpeg",
            [b'G', b'I', b'F', b'8', ..] => "gif",
            [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => "webp",
            _ => return None,
        };
        Some(format!("data:image/{kind};base64,{}", base64::engine::general_purpose::STANDARD.encode(bytes)))
    }
}

/// The newest source in an archive. Copies that an operating system keeps beside the files are none.
fn newest(archive: &Archive) -> Option<(&str, Format)> {
    let is_hidden = |name: &str| name.split('/').any(|part| part == "__MACOSX" || part.starts_with("._"));
    let sources = archive.names().filter(|name| !is_hidden(name)).filter_map(|name| Some((name, Format::of(name)?)));
    sources.max_by_key(|(name, _)| archive.modified(name))
}

fn expanded(archive: &Archive, name: &str, most: usize) -> Result<Vec<u8>, Defect> {
    let mut part = archive.part(name, Some(most as u64))?;
    let mut bytes = Vec::new();
    while !part.expand(PORTION, &mut bytes)? {}
    Ok(bytes)
}

/// True for a name that would not stay in the folder into which an archive is unpacked.
fn leads_out(name: &str) -> bool {
    name.starts_with('/') || name.contains(':') || name.split('/').any(|part| part == "..")
}
