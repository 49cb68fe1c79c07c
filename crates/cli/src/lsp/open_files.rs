//! The files that are open in the editor.

use super::positions::offset;
use document::Opened;
use lsp_types::{TextDocumentContentChangeEvent, Uri};
use percent_encoding::percent_decode_str;
use program::Program;
use std::borrow::Cow;
use std::collections::HashMap;
use std::path::PathBuf;
use units::{Language, percent_encoded, words};

/// An open file.
#[derive(Debug)]
pub struct OpenFile {
    /// Text in the editor.
    pub text: String,
    /// Result of opening the text as a document.
    pub opened: Opened,
    /// Last program that could be compiled from it.
    pub program: Option<Program>,
}

/// The open files, by address.
#[derive(Debug)]
pub struct OpenFiles {
    language: Language,
    // Keys are texts because an address computes a part of itself on first access.
    files: HashMap<String, OpenFile>,
}

impl OpenFiles {
    /// No open files.
    pub fn new(language: Language) -> Self {
        Self { language, files: HashMap::new() }
    }

    /// The language of messages.
    pub fn language(&self) -> Language {
        self.language
    }

    /// An open file.
    pub fn get(&self, uri: &Uri) -> Option<&OpenFile> {
        self.files.get(uri.as_str())
    }

    /// Opens a file or replaces its text. Returns the files whose diagnostics may have changed: the file itself and,
    /// for a document, its open translations.
    pub fn set(&mut self, uri: Uri, text: String) -> Vec<Uri> {
        let before = self.files.remove(uri.as_str()).and_then(|file| file.program);
        let file = self.open(&uri, text, before);
        self.files.insert(uri.as_str().to_owned(), file);
        self.check_translations(uri)
    }

    /// Applies changes to a file, each to the result of the one before: of a range, or of the whole text if none is given. Returns
    /// the files whose diagnostics may have changed; `None` if the file is not open.
    pub fn change(&mut self, uri: Uri, changes: Vec<TextDocumentContentChangeEvent>) -> Option<Vec<Uri>> {
        let mut text = self.get(&uri)?.text.clone();
        for change in changes {
            match change.range {
                Some(range) => {
                    let start = offset(&text, range.start);
                    text.replace_range(start..offset(&text, range.end).max(start), &change.text);
                }
                None => text = change.text,
            }
        }
        Some(self.set(uri, text))
    }

    /// Closes a file. Returns the files whose diagnostics may have changed.
    pub fn close(&mut self, uri: Uri) -> Vec<Uri> {
        self.files.remove(uri.as_str());
        self.check_translations(uri)
    }

    /// Checks the open translations of a document against its present text. Returns the address of the document and
    /// those of the translations.
    fn check_translations(&mut self, uri: Uri) -> Vec<Uri> {
        let Some((folder, name)) = parts(&uri) else { return vec![uri] };
        let open = self.files.iter().filter(|(other, file)| {
            other.rsplit_once('/').is_some_and(|(other, _)| other == folder)
                && document::translates(&file.text).is_some_and(|base| base == name)
        });
        let translations: Vec<Uri> = open.filter_map(|(address, _)| address.parse().ok()).collect();
        for translation in &translations {
            if let Some(OpenFile { text, program, .. }) = self.files.remove(translation.as_str()) {
                let file = self.open(translation, text, program);
                self.files.insert(translation.as_str().to_owned(), file);
            }
        }
        std::iter::once(uri).chain(translations).collect()
    }

    /// Checks a text; a translation is checked with its document. Markdown without a model has no errors. `before`:
    /// last program of the file.
    fn open(&self, uri: &Uri, text: String, before: Option<Program>) -> OpenFile {
        let outline = document::read(&text);
        let is_other = outline.blocks_of(document::BlockKind::Model).next().is_none();
        let opened = match document::translates(&text) {
            Some(base) => self.translation(uri, &base, &text),
            None if is_other => Opened { document: None, diagnostics: Vec::new() },
            None => document::open(&text, &[]),
        };
        let program = opened.document.as_ref().map(|document| document.program.clone()).or(before);
        OpenFile { text, opened, program }
    }

    /// Opens a translation with its document, which is open in the editor or in a file beside it. Contains only
    /// diagnostics of the translation.
    fn translation(&self, uri: &Uri, base: &str, text: &str) -> Opened {
        let Some((_, source)) = self.beside(uri, base) else {
            let message = words!("the document `{base}` of this translation is not beside it");
            let place = document::read(text).front_matter().get("translates").map(|value| value.span);
            let missing = model::Diagnostic::warning("unknown-base", message, place.unwrap_or_default());
            return Opened { document: None, diagnostics: vec![(0, missing)] };
        };
        let mut opened = document::open(&source, &[text]);
        opened.diagnostics.retain(|(number, _)| *number == 1);
        opened.diagnostics.iter_mut().for_each(|(number, _)| *number = 0);
        opened
    }

    /// Address and text of the document of a file: that which a translation names, or else the file itself.
    pub fn document_of(&self, uri: &Uri) -> Option<(Uri, String)> {
        let file = self.get(uri)?;
        match document::translates(&file.text) {
            Some(base) => self.beside(uri, &base),
            None => Some((uri.clone(), file.text.clone())),
        }
    }

    /// Address and text of the file with this name in the folder of another, from the editor or else from the disk.
    fn beside(&self, uri: &Uri, name: &str) -> Option<(Uri, String)> {
        let (folder, _) = parts(uri)?;
        let is_meant = |address: &str| {
            let parts = address.rsplit_once('/');
            parts.is_some_and(|(other, own)| other == folder && decoded(own).as_deref() == Some(name))
        };
        if let Some((address, file)) = self.files.iter().find(|(address, _)| is_meant(address)) {
            return Some((address.parse().ok()?, file.text.clone()));
        }
        // Accepts a plain file name only, so that no text can refer to files outside the folder.
        let is_name = !name.contains(['/', '\\']);
        let path = is_name.then(|| path_of(folder)).flatten()?.join(name);
        let address = format!("{folder}/{}", percent_encoded(name)).parse().ok()?;
        Some((address, std::fs::read_to_string(path).ok()?))
    }

    /// Translations of a document with their addresses: open files, and files beside the document.
    pub fn translations(&self, uri: &Uri) -> Vec<(Uri, String)> {
        let Some((folder, name)) = parts(uri) else { return Vec::new() };
        let is_of = |text: &str| document::translates(text).is_some_and(|base| base == name);
        let open = self.files.iter().filter(|(other, file)| {
            other.rsplit_once('/').is_some_and(|(other, _)| other == folder) && is_of(&file.text)
        });
        let mut found: Vec<(String, String)> = open.map(|(other, file)| (other.clone(), file.text.clone())).collect();
        let path = path_of(folder);
        let stem = name.strip_suffix("md").unwrap_or(&name);
        for entry in path.into_iter().filter_map(|path| std::fs::read_dir(path).ok()).flatten().flatten() {
            let Ok(own) = entry.file_name().into_string() else { continue };
            let address = format!("{folder}/{}", percent_encoded(&own));
            if own.starts_with(stem) && own.ends_with(".md") && own != name && !self.files.contains_key(&address) {
                let text = std::fs::read_to_string(entry.path()).ok().filter(|text| is_of(text));
                found.extend(text.map(|text| (address, text)));
            }
        }
        found.sort();
        found.into_iter().filter_map(|(address, text)| Some((address.parse().ok()?, text))).collect()
    }
}

/// Address of the folder of a file, and name of the file.
fn parts(uri: &Uri) -> Option<(&str, String)> {
    let (folder, name) = uri.as_str().rsplit_once('/')?;
    Some((folder, decoded(name)?))
}

/// Path of a folder from its `file://` address; `None` for other addresses.
fn path_of(folder: &str) -> Option<PathBuf> {
    folder.strip_prefix("file://").and_then(decoded).map(PathBuf::from)
}

/// Decodes percent escapes; `None` if the bytes are no UTF-8.
fn decoded(part: &str) -> Option<String> {
    percent_decode_str(part).decode_utf8().ok().map(Cow::into_owned)
}
