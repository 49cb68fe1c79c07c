//! Table of the hand-ins with their verification.

use crate::collection::{Collection, Entry, State};
use crate::verify::{Copied, Relation};
use report::{Page, escaped};
use units::Language;

/// Maximum number of differences of a hand-in that are listed.
const MOST_DIFFERENCES: usize = 20;

/// Table of all files, then the data that two of them share.
pub fn hand_ins(collection: &Collection, language: Language) -> String {
    let mut page = Page::default();
    let headings = language.pick(
        ["#Group", "Name", "#Seat", "File", "Verification"],
        ["#Grupo", "Nombre", "#Puesto", "Archivo", "Comprobación"],
    );
    page.table("wide", &headings);
    for (index, entry) in collection.entries().iter().enumerate() {
        let seat = entry.hand_in().and_then(|hand_in| hand_in.sender.seat);
        let number = format!("#{}", index + 1);
        let seat = format!("#{}", seat.map_or_else(String::new, |seat| seat.to_string()));
        let lines: Vec<String> = state_text(entry, collection, language).iter().map(|line| escaped(line)).collect();
        page.row(&[&number, &escaped(entry.sender()), &seat, &escaped(entry.file()), &lines.join("<br>")]);
    }
    page.end_table();
    for copied in collection.copies() {
        let class = if copied.is_common_source { "p" } else { "p class=\"callout\"" };
        page.element(class, &copied_text(copied, collection, language));
    }
    page.out
}

/// Lines about the state of a file: one for its verification, and one for each value that does not follow, at most 20.
pub fn state_text(entry: &Entry, collection: &Collection, language: Language) -> Vec<String> {
    let verdict = match entry.state() {
        State::Waiting => return vec![language.pick("is being computed", "se está calculando").to_owned()],
        State::Unreadable(why) => return vec![why.text(language).to_owned()],
        State::Repeated(counts) => {
            let other = collection.entries().get(*counts).map_or("", Entry::file);
            return vec![language.pick(
                format!("was made before {other}, which counts"),
                format!("se hizo antes que {other}, que es la que cuenta"),
            )];
        }
        State::Done(work) => &work.verdict,
    };
    let (equal, all) = (verdict.equal, verdict.equal + verdict.differences.len());
    let mut lines = vec![if verdict.holds() {
        language.pick(format!("all {equal} values equal"), format!("los {equal} valores, iguales"))
    } else {
        language.pick(format!("{equal} of {all} values equal"), format!("{equal} de {all} valores iguales"))
    }];
    if let Some(version) = &verdict.other_version {
        lines.push(language.pick(
            format!("made by version {version}; numbers are compared to a relative deviation of 1e-6"),
            format!("hecha con la versión {version}; los números se comparan con una desviación relativa de 1e-6"),
        ));
    }
    if verdict.refused > 0 {
        let refused = verdict.refused;
        lines.push(language.pick(
            format!("parts of the work that could not be restored: {refused}"),
            format!("partes del trabajo que no se pudieron recuperar: {refused}"),
        ));
    }
    lines.extend(verdict.differences.iter().take(MOST_DIFFERENCES).map(|difference| difference.text(language)));
    let more = verdict.differences.len().saturating_sub(MOST_DIFFERENCES);
    if more > 0 {
        lines.push(language.pick(format!("and {more} further values"), format!("y {more} valores más")));
    }
    lines
}

/// Sentence about data that two hand-ins share.
pub fn copied_text(copied: &Copied, collection: &Collection, language: Language) -> String {
    let place = |(index, record, column): &(usize, String, String)| {
        let sender = collection.sender(*index);
        format!("{sender}, {record}, {column}")
    };
    let relation = match copied.relation {
        Relation::Equal => language.pick("Equal data", "Datos iguales"),
        Relation::Scaled => {
            language.pick("The same data, shifted or scaled", "Los mismos datos, desplazados o escalados")
        }
        Relation::Part => language.pick("A part of the same data", "Una parte de los mismos datos"),
        Relation::Resampled => language.pick("The same data, resampled", "Los mismos datos, remuestreados"),
    };
    let source = match copied.is_common_source {
        true => language.pick(" (a common source, no alarm)", " (una fuente común, sin alarma)"),
        false => "",
    };
    format!("{relation}{source}: {} = {}", place(&copied.one), place(&copied.other))
}
