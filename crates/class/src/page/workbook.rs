//! Report of a class as a workbook.

use super::figures::scale;
use super::hand_ins::{copied_text, state_text};
use super::quantities::far_text;
use crate::collection::Collection;
use analysis::spreadsheet::{Cell, Sheet, Workbook};
use units::Language;

/// XLSX with the results, the answers and the hand-ins. Texts are never formulas.
pub fn workbook(collection: &Collection, language: Language) -> Vec<u8> {
    let sheets = vec![results(collection, language), answers(collection, language), hand_ins(collection, language)];
    Workbook { sheets }.xlsx()
}

fn head<const N: usize>(names: [&str; N]) -> Vec<Cell> {
    names.map(Cell::from).to_vec()
}

fn results(collection: &Collection, language: Language) -> Sheet {
    let mut rows = vec![head(language.say_all([
        "Theory",
        "Quantity",
        "Unit",
        "Group",
        "Value",
        "Standard error",
        "Far from the others",
    ]))];
    for quantity in collection.quantities() {
        let scale = scale(&quantity);
        for (place, (index, measured)) in quantity.results.iter().enumerate() {
            let far = far_text(&quantity, place, language);
            rows.push(vec![
                quantity.theory.as_str().into(),
                quantity.name.as_str().into(),
                quantity.unit.as_str().into(),
                collection.sender(*index).into(),
                (measured.value / scale).into(),
                (measured.error / scale).into(),
                far.into(),
            ]);
        }
        let pooled = |title: &str, pooled: &crate::pooling::Pooled| {
            vec![
                quantity.theory.as_str().into(),
                quantity.name.as_str().into(),
                quantity.unit.as_str().into(),
                title.into(),
                (pooled.value / scale).into(),
                (pooled.error / scale).into(),
            ]
        };
        if let Ok(pool) = &quantity.pool {
            rows.push(pooled(language.say("pooled"), &pool.all));
            let title = language.say("pooled without those far");
            rows.extend(pool.without.as_ref().map(|without| pooled(title, without)));
        }
    }
    Sheet { name: language.say("Results").to_owned(), rows, header: true }
}

fn answers(collection: &Collection, language: Language) -> Sheet {
    let mut rows = vec![head(language.say_all([
        "Group",
        "Document",
        "Question",
        "Attempt",
        "Typed",
        "Grade",
        "Stated grade",
        "Right answer",
    ]))];
    for (index, work) in collection.works() {
        for answer in &work.answers {
            for (attempt, number) in answer.attempts.iter().zip(1..) {
                rows.push(vec![
                    collection.sender(index).into(),
                    answer.document.as_str().into(),
                    (answer.question as f64 + 1.0).into(),
                    f64::from(number).into(),
                    attempt.typed.as_str().into(),
                    attempt.grade().code().as_ref().into(),
                    attempt.stated.code().as_ref().into(),
                    attempt.right.as_str().into(),
                ]);
            }
        }
    }
    Sheet { name: language.say("Answers").to_owned(), rows, header: true }
}

fn hand_ins(collection: &Collection, language: Language) -> Sheet {
    let mut rows = vec![head(language.say_all(["Group", "Seat", "File", "Verification"]))];
    for entry in collection.entries() {
        let seat = entry.hand_in().and_then(|hand_in| hand_in.sender.seat);
        let mut row = vec![
            entry.sender().into(),
            seat.map_or(Cell::Empty, |seat| Cell::Number(f64::from(seat))),
            entry.file().into(),
        ];
        row.extend(state_text(entry, collection, language).into_iter().map(Cell::from));
        rows.push(row);
    }
    let shared = collection.copies().iter().map(|copied| vec![copied_text(copied, collection, language).into()]);
    rows.extend(shared);
    Sheet { name: language.say("Hand-ins").to_owned(), rows, header: true }
}
