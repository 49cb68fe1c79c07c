//! Reading of documents: a base document with its translations, or the sources inside an exported page or a project.

use crate::quoted::quoted;
use crate::refusal::Refusal;
use document::page::{Source, read};
use document::{Document, Opened};
use model::Severity;
use saved::project::{PROJECT_ENDING, Project};
use std::io;
use std::path::{Path, PathBuf};
use units::words;

/// Access to files, which the caller gives.
pub trait Files {
    /// Bytes of a file.
    ///
    /// # Errors
    /// The file cannot be read.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>>;

    /// True for a folder.
    fn is_folder(&self, path: &Path) -> bool;

    /// Names of the files in a folder, in any order; empty if it cannot be read.
    fn names(&self, folder: &Path) -> Vec<String>;
}

/// Texts of a document: the base first, then its translations.
#[derive(Clone, Debug)]
pub struct Sources {
    files: Vec<File>,
}

#[derive(Clone, Debug)]
struct File {
    /// Name for messages.
    path: PathBuf,
    /// Name in an exported page.
    name: String,
    text: String,
}

impl Sources {
    /// A text without a file. `name`: name for messages.
    pub fn of_text(name: &str, text: &str) -> Self {
        Self { files: vec![File { path: name.into(), name: name.to_owned(), text: text.to_owned() }] }
    }

    /// Texts with their names, the base first.
    pub fn of_texts(texts: Vec<(String, String)>) -> Self {
        let file = |(name, text): (String, String)| File { path: name.clone().into(), name, text };
        Self { files: texts.into_iter().map(file).collect() }
    }

    /// The text of the standard input.
    pub fn of_input(text: &str) -> Self {
        Self { files: vec![File { path: "<stdin>".into(), name: "document.md".to_owned(), text: text.to_owned() }] }
    }

    /// Path of the base document, for messages.
    pub fn path(&self) -> &Path {
        self.file_path(0)
    }

    /// Path of the file with the index that a finding states.
    pub fn file_path(&self, index: usize) -> &Path {
        self.files.get(index).map_or(Path::new(""), |file| &file.path)
    }

    /// Paths and texts, base first.
    pub fn texts(&self) -> impl Iterator<Item = (&Path, &str)> {
        self.files.iter().map(|file| (file.path.as_path(), file.text.as_str()))
    }

    /// Files in the form in which an exported page contains them.
    pub fn embedded(&self) -> Vec<Source> {
        self.files.iter().map(|file| Source { name: file.name.clone(), text: file.text.clone() }).collect()
    }

    /// The base without its translations.
    pub fn without_translations(mut self) -> Self {
        self.files.truncate(1);
        self
    }
}

/// Sources and the document parsed from them.
#[derive(Debug)]
pub struct Loaded {
    /// The texts.
    pub sources: Sources,
    /// The document and its findings.
    pub opened: Opened,
}

impl Loaded {
    /// Opens the sources as a document.
    pub fn open(sources: Sources) -> Self {
        let mut texts = sources.files.iter().map(|file| file.text.as_str());
        let base = texts.next().unwrap_or_default();
        let opened = document::open(base, &texts.collect::<Vec<_>>());
        Self { sources, opened }
    }

    /// Sources and document if there are no errors.
    pub fn sound(self) -> Option<(Sources, Document)> {
        let Self { sources, opened } = self;
        opened.sound().map(|document| (sources, document))
    }

    /// Number of errors.
    pub fn errors(&self) -> usize {
        self.opened.diagnostics.iter().filter(|(_, diagnostic)| diagnostic.severity == Severity::Error).count()
    }
}

/// Text of one file.
///
/// # Errors
/// The file cannot be read, is no text, or has a document inside.
pub fn text_of(files: &dyn Files, path: &Path) -> Result<String, Refusal> {
    if is_page(path) || is_project(path) {
        return Err(Refusal::with_hint(
            format!("{} holds a document and is none itself", path.display()),
            "open it in the laboratory and save its document",
        ));
    }
    read_text(files, path)
}

/// Reads the files of the document at `path`. A page or a project gives the sources inside it. For a translation, its base is
/// read; for a base, its translations.
///
/// # Errors
/// A file cannot be read, is no text, or has no document inside.
pub fn sources(files: &dyn Files, path: &Path) -> Result<Sources, Refusal> {
    let text = read_text(files, path)?;
    if is_page(path) {
        return inside_page(path, &text);
    }
    if is_project(path) {
        return inside_project(path, &text);
    }
    let Some(name) = document::translates(&text) else {
        return with_translations(files, path, text, None);
    };
    let base = path.with_file_name(&name);
    let text = read_text(files, &base).map_err(|failure| match failure {
        Refusal::Request { message, .. } => Refusal::with_hint(
            message.english(),
            format!("{} is a translation and says `translates: {name}`", path.display()),
        ),
        other => other,
    })?;
    with_translations(files, &base, text, Some(path))
}

/// The base and every `NAME.LANGUAGE.md` beside its `NAME.md`, in the order of their names, and `asked`, under any
/// name.
fn with_translations(files: &dyn Files, base: &Path, text: String, asked: Option<&Path>) -> Result<Sources, Refusal> {
    let mut paths = siblings(files, base);
    if let Some(asked) = asked.filter(|asked| !paths.iter().any(|path| path.as_path() == *asked)) {
        paths.push(asked.to_owned());
    }
    let mut read = vec![file(base, text)];
    for path in paths {
        let text = read_text(files, &path)?;
        read.push(file(&path, text));
    }
    Ok(Sources { files: read })
}

fn file(path: &Path, text: String) -> File {
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    File { path: path.to_owned(), name, text }
}

fn siblings(files: &dyn Files, base: &Path) -> Vec<PathBuf> {
    let Some(stem) = base.file_stem().and_then(|stem| stem.to_str()) else {
        return Vec::new();
    };
    let directory = base.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut names = files.names(directory);
    names.retain(|name| language_of(name, stem).is_some());
    names.sort();
    names.into_iter().map(|name| base.with_file_name(name)).collect()
}

/// Language in a file name: `es` of `utube.es.md` for the stem `utube`.
fn language_of<'a>(name: &'a str, stem: &str) -> Option<&'a str> {
    let language = name.strip_prefix(stem)?.strip_prefix('.')?.strip_suffix(".md")?;
    let primary = language.split('-').next()?;
    let letters = |text: &str| text.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '-');
    ((2..=3).contains(&primary.len()) && primary.chars().all(|letter| letter.is_ascii_lowercase()) && letters(language))
        .then_some(language)
}

fn is_project(path: &Path) -> bool {
    path.to_string_lossy().to_lowercase().ends_with(PROJECT_ENDING)
}

fn is_page(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("html") || ending.eq_ignore_ascii_case("htm"))
}

fn inside_page(path: &Path, page: &str) -> Result<Sources, Refusal> {
    let sources = read(page).filter(|sources| !sources.is_empty());
    let sources =
        sources.ok_or_else(|| Refusal::request(format!("{} is a page without a document inside", path.display())))?;
    Ok(inside(path, sources))
}

fn inside_project(path: &Path, text: &str) -> Result<Sources, Refusal> {
    let project = Project::read(text).map_err(|error| Refusal::about(path, &error.words()))?;
    Ok(inside(path, project.documents))
}

/// Sources inside another file.
fn inside(path: &Path, sources: Vec<Source>) -> Sources {
    let files = sources.into_iter().map(|source| File {
        path: format!("{}:{}", path.display(), source.name).into(),
        name: source.name,
        text: source.text,
    });
    Sources { files: files.collect() }
}

fn read_text(files: &dyn Files, path: &Path) -> Result<String, Refusal> {
    if files.is_folder(path) {
        return Err(folder(files, path));
    }
    let bytes = files.read(path).map_err(|error| Refusal::file("read", path, &error))?;
    decoded(bytes, &path.display().to_string())
}

/// Error for a folder in place of a document. The hint names a document in it.
fn folder(files: &dyn Files, path: &Path) -> Refusal {
    let names = files.names(path).into_iter();
    // Names of translations contain a dot before their language.
    let document = names.filter(|name| name.strip_suffix(".md").is_some_and(|stem| !stem.contains('.'))).min();
    let (name, shown) = (path.display(), quoted(path));
    let hint = match document {
        Some(document) => {
            let document = quoted(path.join(document));
            words!("name a document in it, such as {document}; `meniscus check {shown}/*.md` checks all of them")
        }
        None => words!("it has no documents, `*.md`; `meniscus new {shown}` begins one"),
    };
    Refusal::in_words(words!("{name} is a folder, not a document"), hint)
}

/// Decodes UTF-8 and removes the byte-order mark that some editors write. `name`: that of the file, for messages.
///
/// # Errors
/// Another encoding.
pub fn decoded(bytes: Vec<u8>, name: &str) -> Result<String, Refusal> {
    let text = String::from_utf8(bytes).map_err(|error| {
        let line =
            1 + error.as_bytes()[..error.utf8_error().valid_up_to()].iter().filter(|&&byte| byte == b'\n').count();
        Refusal::with_hint(format!("{name} is not text in UTF-8 (line {line})"), "save it as UTF-8")
    })?;
    Ok(text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn translations_are_known_by_their_names() {
        assert_eq!(language_of("utube.es.md", "utube"), Some("es"));
        assert_eq!(language_of("utube.pt-BR.md", "utube"), Some("pt-BR"));
        for other in ["utube.md", "utube2.es.md", "utube.notes.md", "utube.es.md~", "utube.es.txt", "utube.old.copy.md"]
        {
            assert_eq!(language_of(other, "utube"), None, "{other}");
        }
    }

    #[test]
    fn a_byte_order_mark_is_no_text() {
        assert_eq!(decoded(b"\xef\xbb\xbf# A".to_vec(), "a.md").ok(), Some("# A".to_owned()));
    }

    #[test]
    fn other_encodings_are_named_with_their_line() {
        let Err(Refusal::Request { message, .. }) = decoded(b"one\nse\xf1or".to_vec(), "a.md") else {
            panic!("it was read")
        };
        assert_eq!(message.english(), "a.md is not text in UTF-8 (line 2)");
    }
}
