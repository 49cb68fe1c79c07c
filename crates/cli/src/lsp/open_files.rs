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

    /// The translations of a document with their addresses: those that are open, and those in files beside it.
    pub fn translations(&self, uri: &Uri) -> Vec<(Uri, String)> {
        let Some((folder, name)) = uri.as_str().rsplit_once('/') else { return Vec::new() };
        let Some(name) = decoded(name) else { return Vec::new() };
        let is_of = |text: &str| document::translates(text).is_some_and(|base| base == name);
        let open = self.files.iter().filter(|(other, file)| {
            other.rsplit_once('/').is_some_and(|(other, _)| other == folder) && is_of(&file.text)
        });
        let mut found: Vec<(String, String)> = open.map(|(other, file)| (other.clone(), file.text.clone())).collect();
        let path = folder.strip_prefix("file://").and_then(decoded);
        let stem = name.strip_suffix("md").unwrap_or(&name);
        for entry in path.into_iter().filter_map(|path| std::fs::read_dir(path).ok()).flatten().flatten() {
            let Ok(own) = entry.file_name().into_string() else { continue };
            let address = format!("{folder}/{}", encoded(&own));
            if own.starts_with(stem) && own.ends_with(".md") && own != name && !self.files.contains_key(&address) {
                let text = std::fs::read_to_string(entry.path()).ok().filter(|text| is_of(text));
                found.extend(text.map(|text| (address, text)));
            }
        }
        found.sort();
        found.into_iter().filter_map(|(address, text)| Some((address.parse().ok()?, text))).collect()
    }

    /// Forgets a file.
    pub fn close(&mut self, uri: &Uri) {
        self.files.remove(uri.as_str());
    }
}

/// A part of an address without its percent signs.
fn decoded(part: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(part.len());
    let mut rest = part.as_bytes();
    while let Some((&first, after)) = rest.split_first() {
        rest = after;
        if first != b'%' {
            bytes.push(first);
            continue;
        }
        let (digits, after) = after.split_at_checked(2)?;
        bytes.push(u8::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok()?);
        rest = after;
    }
    String::from_utf8(bytes).ok()
}

/// The name of a file as a part of an address (RFC 3986, section 2.3).
fn encoded(name: &str) -> String {
    let one = |byte: u8| match byte {
        b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' => char::from(byte).to_string(),
        _ => format!("%{byte:02X}"),
    };
    name.bytes().map(one).collect()
}
