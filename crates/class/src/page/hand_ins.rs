//! Table of the hand-ins with their verification.

use crate::collection::{Collection, Entry, State};
use crate::verify::Copied;
use report::{Page, escaped};
use units::{Language, say};

/// Maximum number of lines about a hand-in.
const MOST_LINES: usize = 20;

/// Table of all files, then the data that two of them share.
pub fn hand_ins(collection: &Collection, language: Language) -> String {
    let mut page = Page::default();
    let headings = language.say_all(["#Group", "Name", "#Seat", "File", "Verification"]);
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

/// Lines about the state of a file: one for its verification, one for each value that does not follow, and those about its document.
pub fn state_lines(entry: &Entry, collection: &Collection, language: Language) -> Vec<String> {
    let mut lines = match entry.state() {
        State::Waiting(_) => vec![language.say("is being computed").to_owned()],
        State::Unreadable(why) => vec![why.text(language).into_owned()],
        State::Repeated(counts) => {
            let other = collection.entries().get(*counts).map_or("", Entry::file);
            vec![say!(language, "was made before {other}, which counts")]
        }
        State::Done(work) => work.verdict.lines(language),
    };
    lines.extend(entry.document().into_iter().flat_map(|difference| difference.lines(language)));
    lines
}

/// The first 20 lines about the state of a file.
pub fn state_text(entry: &Entry, collection: &Collection, language: Language) -> Vec<String> {
    let mut lines = state_lines(entry, collection, language);
    let more = lines.len().saturating_sub(MOST_LINES);
    if more > 0 {
        lines.truncate(MOST_LINES);
        lines.push(say!(language, "and {more} further lines"));
    }
    lines
}

/// Sentence about data that two hand-ins share, with their senders.
pub fn copied_text(copied: &Copied, collection: &Collection, language: Language) -> String {
    copied.text(language, |index| collection.sender(index).to_owned())
}
