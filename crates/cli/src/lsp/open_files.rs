//! The files that an editor has open.

use document::Opened;
use lsp_types::Uri;
use program::Program;
use std::collections::HashMap;
use units::Language;

/// A file that is open.
#[derive(Debug)]
pub struct OpenFile {
    /// Its text in the editor.
    pub text: String,
    /// What it says.
    pub opened: Opened,
    /// The last program that could be made of it.
    pub program: Option<Program>,
}

/// The files that an editor has open, by their addresses.
#[derive(Debug)]
pub struct OpenFiles {
    language: Language,
    // By text: an address has a part that it computes when it is first asked for.
    files: HashMap<String, OpenFile>,
}

impl OpenFiles {
    /// None is open yet.
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

    /// Opens a file, or gives it another text. Translations are checked with their document and not alone, and Markdown
    /// that is no document of Meniscus has no errors.
    pub fn set(&mut self, uri: Uri, text: String) {
        let outline = document::read(&text);
        let is_other = outline.blocks_of(document::BlockKind::Model).next().is_none();
        let opened = if is_other || document::translates(&text).is_some() {
            Opened { document: None, diagnostics: Vec::new() }
        } else {
            document::open(&text, &[])
        };
        let before = self.files.remove(uri.as_str()).and_then(|file| file.program);
        let program = opened.document.as_ref().map(|document| document.program.clone()).or(before);
        self.files.insert(uri.as_str().to_owned(), OpenFile { text, opened, program });
    }

    /// Forgets a file.
    pub fn close(&mut self, uri: &Uri) {
        self.files.remove(uri.as_str());
    }
}
