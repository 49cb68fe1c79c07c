//! Library: documents contained in the page besides the one it opens with, namely other simulations and theories of a
//! damped liquid column.
//!
//! `courses.rs` divides the simulations into courses. `list.rs` shows the documents as cards, behind those that were written in this browser (`own.rs`), and `search.rs`
//! searches them. `pictures.rs` opens the documents whose cards are in sight, one in a frame, and lets a picture move while
//! its card is attended to; only so many exist at once, and none once the library is closed.

mod courses;
pub mod list;
mod own;
mod pictures;
mod search;

use document::page::{self, Source};
use document::{Card, Document};
use play::Subject;
use std::cell::{OnceCell, RefCell};

/// Folder of the theories.
const THEORIES: &str = "theories/";

/// A document with its translations.
#[derive(Clone)]
pub struct Entry {
    /// Files, the document first.
    pub files: Vec<Source>,
}

impl Entry {
    /// File name of the document.
    pub fn file(&self) -> &str {
        self.files.first().map_or("", |file| &file.name)
    }

    /// True for a theory, which is no simulation of its own.
    pub fn is_theory(&self) -> bool {
        self.file().starts_with(THEORIES)
    }

    /// Card for lists, in a language: from the translation, completed by the document.
    pub fn card(&self, language: &str) -> Card {
        let mut cards = self.files.iter().map(|file| document::card(&file.text));
        let base = cards.next().unwrap_or_default();
        if base.language == language {
            return base;
        }
        let Some(own) = cards.find(|card| card.language == language) else { return base };
        let title = if own.title.is_empty() { base.title } else { own.title };
        let summary = if own.summary.is_empty() { base.summary } else { own.summary };
        let topics = if own.topics.is_empty() { base.topics } else { own.topics };
        Card { title, summary, topics, ..own }
    }

    /// Title in a language.
    pub fn title(&self, language: &str) -> String {
        self.card(language).title
    }

    /// Opens the document; `None` if it has errors.
    pub fn open(&self) -> Option<Document> {
        let texts: Vec<&str> = self.files.iter().map(|file| file.text.as_str()).collect();
        let (source, translations) = texts.split_first()?;
        document::open(source, translations).sound()
    }
}

/// The published simulation. Links without the name of a document, in a page that was not exported, refer to it: the laboratory
/// opened with it when such links were written.
pub const PUBLISHED: &str = "utube.md";

/// Documents contained in the page. Kept in memory because every change of a text reads them.
struct Carried {
    home: RefCell<Vec<Source>>,
    /// True if the page was exported or is served with a document of its own.
    is_exported: bool,
    entries: Vec<Entry>,
}

/// Documents contained in the page, read on first use.
fn carried() -> &'static Carried {
    thread_local! {
        static CARRIED: OnceCell<&'static Carried> = const { OnceCell::new() };
    }
    let read = || {
        let entries = read_entries();
        let element = view::views::document().get_element_by_id("documents");
        let exported = element.and_then(|element| page::read(&element.outer_html()));
        let is_exported = exported.is_some();
        let first = || entries.first().map_or_else(Vec::new, |entry| entry.files.clone());
        let home = RefCell::new(exported.unwrap_or_else(first));
        let carried: &'static Carried = Box::leak(Box::new(Carried { home, is_exported, entries }));
        carried
    };
    CARRIED.with(|cell| *cell.get_or_init(read))
}

/// All entries, in the order of the page.
pub fn entries() -> Vec<Entry> {
    carried().entries.clone()
}

fn read_entries() -> Vec<Entry> {
    let text = document_text("library");
    let mut entries: Vec<Entry> = Vec::new();
    let (bases, translations): (Vec<Source>, Vec<Source>) = page::read_list(&text)
        .unwrap_or_default()
        .into_iter()
        .partition(|source| document::translates(&source.text).is_none());
    for base in bases {
        let (directory, file) = base.name.rsplit_once('/').unwrap_or(("", &base.name));
        let own = |other: &&Source| {
            other.name.rsplit_once('/').map_or("", |(directory, _)| directory) == directory
                && document::translates(&other.text).as_deref() == Some(file)
        };
        let translations: Vec<Source> = translations.iter().filter(own).cloned().collect();
        entries.push(Entry { files: std::iter::once(base).chain(translations).collect() });
    }
    entries
}

/// The theories.
pub fn theories() -> Vec<Entry> {
    entries().into_iter().filter(Entry::is_theory).collect()
}

/// Files that the page opens with: the document it was exported with, otherwise the first of the library.
pub fn home() -> Vec<Source> {
    carried().home.borrow().clone()
}

/// Files of the document that a link with this state and without the name of a document refers to.
pub fn unnamed(state: &str) -> Vec<Source> {
    let before = (!carried().is_exported && !state.is_empty()).then(|| find(PUBLISHED)).flatten();
    before.unwrap_or_else(home)
}

/// Replaces the files that the page opens with, because the served files have changed.
pub fn change_home(files: Vec<Source>) {
    carried().home.replace(files);
}

/// Files of the entry with this name.
pub fn find(name: &str) -> Option<Vec<Source>> {
    carried().entries.iter().find(|entry| entry.file() == name).map(|entry| entry.files.clone())
}

/// Subject of a link to a document: the page's own, one of the library, or one that only the user has.
pub fn subject(files: &[Source]) -> Subject {
    if *carried().home.borrow() == files {
        return Subject::Home;
    }
    let entry = carried().entries.iter().find(|entry| entry.files == files);
    let name = files.first().map_or("", |file| &file.name).to_owned();
    if entry.is_some() { Subject::Library(name) } else { Subject::File(name) }
}

/// Subject of a link to a state of a document. Only an exported page leaves the name of its own document out.
pub fn subject_of_state(files: &[Source]) -> Subject {
    let name = files.first().map_or("", |file| &file.name);
    match subject(files) {
        Subject::Home if !carried().is_exported => Subject::Library(name.to_owned()),
        subject => subject,
    }
}

fn document_text(id: &str) -> String {
    view::views::document().get_element_by_id(id).and_then(|element| element.text_content()).unwrap_or_default()
}
