//! Result of a verification, as text and as JSON.

use super::read::Handed;
use crate::terminal::visible::visible;
use class::verify::{Copied, Relation, Verdict, meaning};
use saved::hand_in::FactValue;
use serde_json::{Value, json};
use units::{Language, Words};

/// Result for one hand-in.
pub enum State {
    /// It cannot be read, for this reason.
    Unreadable(Words),
    /// The hand-in of this index was made later by the same sender and counts.
    Repeated(usize),
    /// It was computed again.
    Verified(Verdict),
}

/// Results of all hand-ins.
pub struct Report<'a> {
    /// The hand-ins.
    pub handed: &'a [Handed],
    /// One result for each.
    pub states: Vec<State>,
    /// Data that two of them share.
    pub copies: Vec<Copied>,
}

impl Report<'_> {
    /// True if all values follow from their data, and no measured data are shared.
    pub fn holds(&self) -> bool {
        let holds = |state: &State| match state {
            State::Unreadable(_) => false,
            State::Repeated(_) => true,
            State::Verified(verdict) => verdict.holds(),
        };
        self.states.iter().all(holds) && self.copies.iter().all(|copied| copied.is_common_source)
    }

    fn name(&self, index: usize) -> String {
        self.handed.get(index).map_or_else(String::new, |handed| handed.path.display().to_string())
    }

    fn sender(&self, index: usize) -> &str {
        self.handed.get(index).map_or("", Handed::sender_name)
    }

    /// Lines for people.
    pub fn text(&self, language: Language) -> String {
        let mut text = String::new();
        for (index, state) in self.states.iter().enumerate() {
            let (file, sender) = (self.name(index), self.sender(index));
            text += &match state {
                State::Unreadable(why) => format!("{file} {}\n", why.text(language)),
                State::Repeated(counts) => {
                    let other = self.name(*counts);
                    let why = language.pick(
                        format!("was made before {other}, which counts"),
                        format!("se hizo antes que {other}, que es la que cuenta"),
                    );
                    format!("{file} ({sender}) {why}\n")
                }
                State::Verified(verdict) if sender.is_empty() => {
                    format!("{file}: {}\n", verdict.lines(language).join("\n  "))
                }
                State::Verified(verdict) => format!("{file} ({sender}): {}\n", verdict.lines(language).join("\n  ")),
            };
        }
        for copied in &self.copies {
            text += &copied.text(language, |index| self.name(index));
            text.push('\n');
        }
        visible(&format!("{text}{}\n", meaning().text(language))).into_owned()
    }

    /// One JSON object.
    pub fn json(&self, language: Language) -> String {
        let hand_in = |(index, state): (usize, &State)| {
            let (file, sender) = (self.name(index), self.sender(index));
            match state {
                State::Unreadable(why) => json!({"file": file, "unreadable": why.text(language)}),
                State::Repeated(counts) => json!({"file": file, "sender": sender, "repeated_by": self.name(*counts)}),
                State::Verified(verdict) => json!({
                    "file": file,
                    "sender": sender,
                    "holds": verdict.holds(),
                    "equal": verdict.equal,
                    "not_restored": verdict.refused,
                    "other_version": verdict.other_version,
                    "differences": differences(verdict, language),
                }),
            }
        };
        let place = |(index, record, column): &(usize, String, String)| json!({"file": self.name(*index), "record": record, "column": column});
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
            "hand_ins": self.states.iter().enumerate().map(hand_in).collect::<Vec<_>>(),
            "shared": self.copies.iter().map(copied).collect::<Vec<_>>(),
            "meaning": meaning().text(language),
        });
        format!("{whole:#}\n")
    }
}

fn differences(verdict: &Verdict, language: Language) -> Vec<Value> {
    let value = |value: &Option<FactValue>| serde_json::to_value(value).unwrap_or_default();
    let difference = |one: &class::verify::Difference| {
        json!({
            "part": one.part,
            "item": one.item,
            "quantity": one.quantity,
            "stated": value(&one.stated),
            "computed": value(&one.computed),
            "text": one.text(language),
        })
    };
    verdict.differences.iter().map(difference).collect()
}
