//! Items of a project file besides its document.

use super::answers::{answer_of_item, restore_answer, saved_answers};
use super::films::MOST_WORKS;
use crate::fits::fit::Fitted;
use crate::{Desk, MOST_FITS, MOST_RECORDS};
use saved::Item;
use saved::format::{Content, Part};
use std::collections::HashSet;
use units::{Words, words};

/// Maximum number of items that are tried, because a file of unknown origin may have thousands.
const MOST_TRIED: usize = MOST_RECORDS + MOST_WORKS + MOST_FITS;

/// Records, works on films, fits and answers: names and texts to store. `now` in milliseconds.
pub fn project_items(desk: &Desk, now: u64) -> Vec<(String, String)> {
    let groups = [desk.records().saved(), desk.films().saved(), desk.fits().saved(), saved_answers(desk.play())];
    written(groups.into_iter().flatten(), now)
}

/// The items that a fit follows from, in the form of [`project_items`]: its records, the works on their films, and the
/// fit, or with `all` every fit of the same values. `now` in milliseconds.
pub fn items_of_fit(desk: &Desk, id: u32, all: bool, now: u64) -> Vec<(String, String)> {
    let fits = desk.fits();
    let Some(fit) = fits.finished().iter().find(|fit| fit.id == id) else { return Vec::new() };
    let belongs = |other: &&Fitted| other.id == id || all && other.same_values(fit);
    let saved_fits = fits.to_save(fits.finished().iter().filter(belongs));
    let taking_part = |record: u32| fit.definition.parts.iter().any(|part| part.record == record);
    let records = desk.records().records().names().into_iter().filter(|(id, _)| taking_part(*id));
    let records: HashSet<String> = records.map(|(_, name)| name).collect();
    let of_record = |film: &Item| match &film.0 {
        Content::Film(film) => film.record.as_ref().is_some_and(|record| records.contains(record)),
        _ => false,
    };
    let groups = [
        desk.records().saved().into_iter().filter(|(name, _)| records.contains(name)).collect(),
        desk.films().saved().into_iter().filter(|(_, film)| of_record(film)).collect(),
        saved_fits,
    ];
    written(groups.into_iter().flatten(), now)
}

/// Restores the items of a project in the order in which they were written, because fits need their records.
/// Existing items stay unchanged. Returns a sentence for each item that could not be restored, with the reason.
pub fn take_project_items(desk: &mut Desk, items: &[(String, String)]) -> Vec<Words> {
    let records = desk.records().records().names().into_iter().map(|(_, name)| name);
    let others = [desk.fits().saved(), desk.films().saved()].into_iter().flatten().map(|(name, _)| name);
    let mut here: HashSet<String> = records.chain(others).collect();
    let (mut refused, mut tried) = (Vec::new(), 0);
    for (name, text) in items {
        let Some((_, item)) = Item::read(text) else {
            refused.push(words!("{name}: it is damaged, or was saved by a later version"));
            continue;
        };
        if here.contains(name) {
            continue;
        }
        if restore_answer(desk.play_mut(), name, &item) {
            continue;
        }
        tried += 1;
        let taken = if tried > MOST_TRIED { None } else { desk.restore_item(&item) };
        if taken.is_none() {
            refused.push(if tried > MOST_TRIED { too_many() } else { why_refused(desk, &item) });
        }
        here.extend(taken);
    }
    refused
}

/// Adds the items that another device of the same person has stored. Answers get the attempts of both; other items are added if they are
/// missing here. Returns a sentence for each item that could not be restored, with the reason.
pub fn merge_project_items(desk: &mut Desk, items: &[(String, String)]) -> Vec<Words> {
    let answer = |text: &str| Item::read(text).and_then(|(_, item)| answer_of_item(&item));
    let (answers, others): (Vec<_>, Vec<_>) = items.iter().cloned().partition(|(_, text)| answer(text).is_some());
    for (name, answer) in answers.iter().filter_map(|(name, text)| Some((name, answer(text)?))) {
        desk.play_mut().change_answers(|answers, run| answers.merge(run, name, &answer));
    }
    take_project_items(desk, &others)
}

/// Reason why an item could not be restored.
fn why_refused(desk: &Desk, item: &Item) -> Words {
    match &item.0 {
        Content::Record(record) => {
            let name = &record.name;
            words!("record {name}: its data cannot be read, or it exceeds the number or length of records")
        }
        Content::Film(film) => {
            let name = &film.name;
            words!("work on the film {name}: it is damaged, or the file has it twice")
        }
        Content::Fit(fit) => {
            let (file, names) = (&fit.task.file, desk.records().records().names());
            let is_missing = |part: &&Part| names.iter().all(|(_, name)| *name != part.record);
            match fit.task.records.iter().find(is_missing) {
                Some(Part { name, .. }) => words!("fit of {file}: its record {name} is missing"),
                None => words!("fit of {file}: its columns do not fit the record"),
            }
        }
        Content::Answer(answer) => {
            let typed = &answer.typed;
            words!("answer \"{typed}\": the document does not have its question")
        }
    }
}

fn too_many() -> Words {
    words!("a project has at most {MOST_TRIED} records, works on films and fits")
}

/// Names and texts of items in their order. `now` in milliseconds.
fn written(items: impl Iterator<Item = (String, Item)>, now: u64) -> Vec<(String, String)> {
    items.map(|(name, item)| (name, item.write(now))).collect()
}
