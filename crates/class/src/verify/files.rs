//! Work on files of data without a page: what the command line has fitted, as a project.

use desk::{Desk, FilmIdentity};
use document::page::Source;
use saved::Item;
use saved::format::{self, Content};
use saved::project::Project;

/// Number of bytes at the beginning of a film of which [`film_hash`] is made.
pub const FILM_START: u64 = FilmIdentity::START as u64;

/// Hash by which a laboratory recognises a film. `start`: the first [`FILM_START`] bytes of the file.
pub fn film_hash(start: &[u8]) -> String {
    FilmIdentity::new("", 0, start).hash
}

/// A file of measured data.
#[derive(Clone, Debug)]
pub struct DataFile {
    /// Name of the file.
    pub name: String,
    /// Content of the file.
    pub bytes: Vec<u8>,
    /// Columns chosen as independent variables; empty if none were chosen.
    pub against: Vec<usize>,
}

/// A project with these records, works on films and fits. Film number `i` has given record number `i`, and part number `i` of
/// each fit is about record number `i`; the names of their records are set here. `documents`: the first one is opened. `None` if a file cannot be read as a record, or is too long to be part of a
/// project.
pub fn project_of_files(
    documents: Vec<Source>,
    state: String,
    files: Vec<DataFile>,
    films: Vec<format::Film>,
    fits: Vec<format::Fit>,
) -> Option<Project> {
    let (first, translations) = documents.split_first()?;
    let translations: Vec<&str> = translations.iter().map(|file| file.text.as_str()).collect();
    let mut desk = Desk::open(document::open(&first.text, &translations).sound()?);
    for file in &files {
        desk.add_record(&file.name, &file.bytes).ok()?;
    }
    let mut items = desk::project_items(&desk, 0);
    if items.len() != files.len() {
        return None;
    }
    let mut records = Vec::new();
    for ((name, text), file) in items.iter_mut().zip(&files) {
        let Content::Record(mut record) = Item::read(text)?.1.0 else { return None };
        record.against.clone_from(&file.against);
        records.push((name.clone(), record.name.clone()));
        *text = Item(Content::Record(record)).write(0);
    }
    for (place, (mut film, (record, _))) in films.into_iter().zip(&records).enumerate() {
        film.record = Some(record.clone());
        items.push((format!("film {place}"), Item(Content::Film(Box::new(film))).write(0)));
    }
    for (place, mut fit) in fits.into_iter().enumerate() {
        for (part, (record, name)) in fit.task.records.iter_mut().zip(&records) {
            (part.record, part.name) = (record.clone(), name.clone());
        }
        items.push((format!("fit {place}"), Item(Content::Fit(fit)).write(0)));
    }
    Some(Project { documents, state, items })
}
