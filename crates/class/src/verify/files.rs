//! Work on files of data without a page: what the command line has fitted, as a project.

use super::recomputation::document_has_errors;
use desk::{Desk, FilmIdentity, LONGEST_SAVED};
use document::page::Source;
use saved::Item;
use saved::format::{self, Content};
use saved::project::Project;
use units::{Words, words};

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
/// each fit is about record number `i`; the names of their records are set here. `documents`: the first one is opened.
///
/// # Errors
/// The reason, without a capital and a period: the document has errors, a file cannot be read as a record, gives several
/// records, or is too long to be part of a project.
pub fn project_of_files(
    documents: Vec<Source>,
    state: String,
    files: Vec<DataFile>,
    films: Vec<format::Film>,
    fits: Vec<format::Fit>,
) -> Result<Project, Words> {
    let (first, translations) = documents.split_first().ok_or_else(document_has_errors)?;
    let translations: Vec<&str> = translations.iter().map(|file| file.text.as_str()).collect();
    let document = document::open(&first.text, &translations).sound().ok_or_else(document_has_errors)?;
    let mut desk = Desk::open(document);
    for file in &files {
        let before = desk.records().list().len();
        desk.add_record(&file.name, &file.bytes).map_err(|why| Words::same(why.text(desk.play())))?;
        if desk.records().list().len() != before + 1 {
            let name = &file.name;
            return Err(words!("{name} holds several records, and one is needed"));
        }
    }
    let mut items = desk::project_items(&desk, 0);
    if items.len() != files.len() {
        let long = desk.records().list().into_iter().find(|record| !record.lasting);
        return Err(too_long(&long.map(|record| record.name).unwrap_or_default()));
    }
    let mut records = Vec::new();
    for ((name, text), file) in items.iter_mut().zip(&files) {
        let Some((_, Item(Content::Record(mut record)))) = Item::read(text) else { return Err(too_long(&file.name)) };
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
    Ok(Project { documents, state, items })
}

fn too_long(name: &str) -> Words {
    let most = LONGEST_SAVED >> 10;
    words!("the table {name} is too long: the tables of a hand-in have at most {most} KiB together")
}
