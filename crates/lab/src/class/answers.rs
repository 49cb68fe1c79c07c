//! The answers of all groups, question by question.

use super::curves::collecting_chip;
use super::empty::nothing;
use super::room::Part;
use super::words;
use crate::app::App;
use class::collection::{Collection, QuestionTally, Snapshot};
use class::page;
use view::views::*;

/// Maximum number of answers of a question offered for the wall.
const MOST_OFFERED: usize = 100;

/// An answer that can be collected.
struct Offered {
    sender: String,
    typed: String,
    snapshot: Snapshot,
}

/// The section: for each question its tallies, and the answers that can be collected.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let language = app.language.get_untracked();
    changing(move || {
        let asked = app.class.read(Part::Answers, |collection| {
            let of = |tally: QuestionTally| {
                (page::questions(std::slice::from_ref(&tally), language), offered(collection, &tally))
            };
            collection.questions().into_iter().map(of).collect::<Vec<_>>()
        });
        if asked.is_empty() {
            return nothing(app);
        }
        each(asked, |(html, offered)| {
            let chip = |Offered { sender, typed, snapshot }: Offered| {
                collecting_chip(app, format!("{}: {typed}", app.class.called(&sender)), snapshot)
            };
            let chips = div().class("chips").role("group").attr("aria-label", words.collect_answers);
            let fold = details().class("class-fold").child(summary().child(words.collect_answers));
            View::from((div().class("class-report").inner_html(html), fold.child(chips.each(offered, chip))))
        })
    })
}

/// The last attempts at a question, at most 100.
fn offered(collection: &Collection, tally: &QuestionTally) -> Vec<Offered> {
    let mut offered = Vec::new();
    for (hand_in, work) in collection.works() {
        for (answer, own) in work.answers.iter().enumerate() {
            let last = own.attempts.last().filter(|_| tally.is_of(own) && offered.len() < MOST_OFFERED);
            offered.extend(last.map(|last| Offered {
                sender: collection.sender(hand_in).to_owned(),
                typed: last.typed.clone(),
                snapshot: Snapshot::Answer { hand_in, answer },
            }));
        }
    }
    offered
}
