//! The folder of the server, below which all files lie, and the documents in it.

use super::answer::Refused;
use crate::failure::Failure;
use crate::terminal::findings::findings;
use crate::terminal::output;
use runner::fitting::Theory;
use runner::records::{MOST_BYTES, Measured, Stated, measured, too_large};
use runner::{Files, Loaded, Refusal, Sources};
use std::io;
use std::path::{Component, Path, PathBuf};
use std::time::{Duration, Instant};
use units::Language;

/// Largest size of a file that is read as a document, in bytes: exported pages and projects are larger than documents.
const LARGEST: u64 = 64 << 20;

/// The folder, the limit of a call, and the language of findings.
#[derive(Debug)]
pub struct Workplace {
    /// Path without symbolic links.
    folder: PathBuf,
    /// Longest time of a call, in seconds.
    pub seconds: u32,
    language: Language,
}

/// The folder during a call.
#[derive(Clone, Copy, Debug)]
pub struct Call<'a> {
    /// The folder.
    pub workplace: &'a Workplace,
    /// The language of findings.
    pub language: Language,
    end: Instant,
}

impl Workplace {
    /// Opens the folder.
    ///
    /// # Errors
    /// It is none, or cannot be read.
    pub fn open(folder: &Path, seconds: u32, language: Language) -> Result<Self, Failure> {
        let whole = folder.canonicalize().map_err(|error| Failure::file("read", folder, &error))?;
        if whole.is_dir() {
            Ok(Self { folder: whole, seconds, language })
        } else {
            Err(Failure::request(format!("cannot read {}: it is no folder", folder.display())))
        }
    }

    /// A call that begins now.
    pub fn now(&self) -> Call<'_> {
        Call {
            workplace: self,
            language: self.language,
            end: Instant::now() + Duration::from_secs(self.seconds.into()),
        }
    }

    /// The path of an existing file below the folder, without symbolic links.
    fn inside(&self, path: &Path) -> io::Result<PathBuf> {
        let whole = self.folder.join(path).canonicalize()?;
        if whole.starts_with(&self.folder) { Ok(whole) } else { Err(outside()) }
    }

    /// The path of a file that may be written. Its folder must exist, and the file must not be a symbolic link.
    fn for_writing(&self, path: &Path) -> io::Result<PathBuf> {
        let whole = self.folder.join(path);
        let name = match whole.components().next_back() {
            Some(Component::Normal(name)) => name.to_owned(),
            _ => return Err(io::Error::other("it is no name of a file")),
        };
        let target = self.inside(whole.parent().unwrap_or(&self.folder))?.join(name);
        match target.symlink_metadata() {
            Ok(found) if !found.is_file() => Err(io::Error::other("it is no file")),
            _ => Ok(target),
        }
    }
}

fn outside() -> io::Error {
    io::Error::new(io::ErrorKind::PermissionDenied, "it lies outside of the folder of the server")
}

impl Files for Call<'_> {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let path = self.workplace.inside(path)?;
        let found = path.metadata()?;
        // A pipe or a device could be read without end.
        if !found.is_file() || found.len() > LARGEST {
            return Err(io::Error::other("it is no file, or too large"));
        }
        std::fs::read(path)
    }

    fn is_folder(&self, path: &Path) -> bool {
        self.workplace.inside(path).is_ok_and(|path| path.is_dir())
    }

    fn names(&self, folder: &Path) -> Vec<String> {
        let inside = self.workplace.inside(folder);
        let entries = inside.into_iter().filter_map(|folder| std::fs::read_dir(folder).ok()).flatten();
        let names = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
        names.filter(|name| self.workplace.inside(&folder.join(name)).is_ok()).collect()
    }
}

impl Call<'_> {
    /// True until the time of the call is over.
    pub fn goes_on(&self) -> bool {
        Instant::now() < self.end
    }

    /// The texts of a document: of a file with its translations, or one that is given.
    ///
    /// # Errors
    /// Neither or both are given, or the file cannot be read.
    pub fn sources(&self, document: Option<&String>, text: Option<&String>) -> Result<Sources, Refused> {
        match (document, text) {
            (Some(path), None) => Ok(runner::sources(self, Path::new(path))?),
            (None, Some(text)) => Ok(Sources::of_text("document.md", text)),
            _ => Err(Refused::because("give either `document`, a path, or `text`, the document itself")),
        }
    }

    /// A document without errors, opened.
    ///
    /// # Errors
    /// As [`Call::sources`], and the findings of a document with errors.
    pub fn loaded(&self, document: Option<&String>, text: Option<&String>) -> Result<Loaded, Refused> {
        let loaded = Loaded::open(self.sources(document, text)?);
        if loaded.opened.has_errors() || loaded.opened.document.is_none() {
            let found: Vec<_> = findings(&loaded, self.language).collect();
            return Err(Refused::with_findings("the document has errors", found));
        }
        Ok(loaded)
    }

    /// A document without errors, as a theory that is run or fitted.
    ///
    /// # Errors
    /// As [`Call::loaded`].
    pub fn theory(&self, document: Option<&String>, text: Option<&String>) -> Result<Theory, Refused> {
        let loaded = self.loaded(document, text)?;
        let (sources, document) = loaded.sound().ok_or_else(|| Refused::because("the document has errors"))?;
        Ok(Theory { sources, document })
    }

    /// A file of measured data.
    ///
    /// # Errors
    /// It cannot be read, or is no table.
    pub fn record(&self, path: &str, stated: Stated) -> Result<Measured, Refusal> {
        let bytes = self.read(Path::new(path)).map_err(|error| Refusal::file("read", Path::new(path), &error))?;
        if bytes.len() as u64 > MOST_BYTES {
            Err(too_large(Path::new(path)))
        } else {
            measured(path.to_owned(), bytes, stated)
        }
    }

    /// Writes a file that a call names, whole or not at all.
    ///
    /// # Errors
    /// A path outside of the folder, a link, or a file that cannot be written.
    pub fn write(&self, path: &str, bytes: &[u8]) -> Result<(), Refused> {
        let failed = |error: io::Error| Refused::from(Refusal::file("write", Path::new(path), &error));
        let target = self.workplace.for_writing(Path::new(path)).map_err(failed)?;
        output::file(&target, &[], bytes).map_err(|_| Refused::because(format!("cannot write {path}")))
    }
}
