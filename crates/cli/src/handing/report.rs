//! Result of a verification, as text and as JSON.

use crate::terminal::visible::visible;
use class::collection::{Collection, Entry, State};
use class::page::state_lines;
use class::verify::documents::{ChangedLine, ComparedWith};
use class::verify::{Copied, DocumentDifference, GradeDifference, Relation, Verdict, meaning};
use saved::hand_in::FactValue;
use serde_json::{Value, json};
use units::Language;

/// True if all values follow from their data, all documents are among the given ones or those of the majority, and no measured data are shared.
pub fn holds(class: &Collection) -> bool {
    let holds = |entry: &Entry| match entry.state() {
        State::Done(work) => work.verdict.holds(),
        State::Repeated(_) => true,
        State::Unreadable(_) | State::Waiting(_) => false,
    };
    class.entries().iter().all(|entry| holds(entry) && entry.document().is_none())
        && class.copies().iter().all(|copied| copied.is_common_source)
}

fn file(class: &Collection, index: usize) -> &str {
    class.entries().get(index).map_or("", Entry::file)
}

/// Name of the sender; empty if there is none.
fn sender(entry: &Entry) -> &str {
    entry.hand_in().map_or("", |hand_in| &hand_in.sender.name)
}

/// Lines for people.
pub fn text(class: &Collection, language: Language) -> String {
    let mut text = String::new();
    for entry in class.entries() {
        let lines = state_lines(entry, class, language).join("\n  ");
        let (file, sender) = (entry.file(), sender(entry));
        text += &match entry.state() {
            State::Unreadable(_) => format!("{file} {lines}\n"),
            State::Repeated(_) => format!("{file} ({sender}) {lines}\n"),
            State::Done(_) | State::Waiting(_) if sender.is_empty() => format!("{file}: {lines}\n"),
            State::Done(_) | State::Waiting(_) => format!("{file} ({sender}): {lines}\n"),
        };
    }
    for copied in class.copies() {
        text += &copied.text(language, |index| file(class, index).to_owned());
        text.push('\n');
    }
    visible(&format!("{text}{}\n", meaning().text(language))).into_owned()
}

/// One JSON object.
pub fn json(class: &Collection, language: Language) -> String {
    let hand_in = |entry: &Entry| {
        let (name, sender) = (entry.file(), sender(entry));
        match entry.state() {
            State::Unreadable(why) => json!({"file": name, "unreadable": why.text(language)}),
            State::Repeated(counts) => json!({"file": name, "sender": sender, "repeated_by": file(class, *counts)}),
            State::Waiting(_) => json!({"file": name, "sender": sender}),
            State::Done(work) => json!({
                "file": name,
                "sender": sender,
                "holds": work.verdict.holds(),
                "equal": work.verdict.equal,
                "not_restored": work.verdict.refused,
                "other_bits": work.verdict.other_bits.as_ref().map(|other| json!({"version": other.version, "bits": other.bits})),
                "unknown": work.verdict.unknown,
                "beyond": work.verdict.beyond.iter().map(|one| json!({"question": one.question, "made": one.made, "allowed": one.allowed})).collect::<Vec<_>>(),
                "grades": work.verdict.grades.iter().map(|one| grade(one, language)).collect::<Vec<_>>(),
                "document": entry.document().map(|difference| document(difference, language)),
                "differences": differences(&work.verdict, language),
            }),
        }
    };
    let place = |(index, record, column): &(usize, String, String)| json!({"file": file(class, *index), "record": record, "column": column});
    let copied = |copied: &Copied| {
        let relation = match copied.relation {
            Relation::Equal => "equal",
            Relation::Scaled => "scaled",
            Relation::Part => "part",
            Relation::Resampled => "resampled",
        };
        json!({
            "relation": relation,
            "common_source": copied.is_common_source,
            "places": [place(&copied.one), place(&copied.other)],
        })
    };
    let whole = json!({
        "hand_ins": class.entries().iter().map(hand_in).collect::<Vec<_>>(),
        "shared": class.copies().iter().map(copied).collect::<Vec<_>>(),
        "meaning": meaning().text(language),
    });
    format!("{whole:#}\n")
}

fn document(difference: &DocumentDifference, language: Language) -> Value {
    let line = |line: &ChangedLine| json!({"file": line.file, "line": line.line, "own": line.own, "other": line.other});
    json!({
        "with": match difference.with {
            ComparedWith::Teacher => json!("given document"),
            ComparedWith::Groups(count) => json!({"hand_ins": count}),
        },
        "lines": difference.lines.iter().map(line).collect::<Vec<_>>(),
        "text": difference.lines(language).join("; "),
    })
}

fn grade(one: &GradeDifference, language: Language) -> Value {
    json!({
        "question": one.question,
        "attempt": one.attempt,
        "stated": one.stated.code(),
        "computed": one.computed.code(),
        "text": one.text(language),
    })
}

fn differences(verdict: &Verdict, language: Language) -> Vec<Value> {
    let value = |value: &Option<FactValue>| -> Value {
        value.as_ref().and_then(|value| serde_json::from_str(&value.json()).ok()).unwrap_or_default()
    };
    let difference = |one: &class::verify::Difference| {
        json!({
            "part": one.part.code(),
            "item": one.item,
            "quantity": one.quantity,
            "stated": value(&one.stated),
            "computed": value(&one.computed),
            "text": one.text(language),
        })
    };
    verdict.differences.iter().map(difference).collect()
}
