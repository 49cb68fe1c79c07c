//! Answers of a class by question, for students.

use crate::class::{Class, Settings};
use crate::fold::Folded;
use crate::pages::{Given, Pages};
use crate::store::{EventRow, Fault, Store};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::Mutex;

/// Time for which a tally is used again.
const FRESH: Duration = Duration::from_secs(2);
/// Maximum number of answers of others that a student sees of one question.
const MOST_SHOWN: usize = 60;
/// Number of events that are read at once.
const PORTION: u32 = 1000;

/// Answers by question and seat.
#[derive(Debug, Default)]
pub struct Tally(BTreeMap<String, BTreeMap<u32, Given>>);

/// Latest tallies by class.
#[derive(Debug, Default)]
pub struct Tallies(Mutex<BTreeMap<String, Counted>>);

#[derive(Debug)]
struct Counted {
    at: Instant,
    /// Events up to this one are folded.
    number: u64,
    folded: BTreeMap<u32, Folded>,
    tally: Arc<Tally>,
}

impl Tallies {
    /// The tally of a class, at most two seconds old. Answers are graded by the documents of the server: the grades that a browser
    /// sends are not counted.
    pub async fn of(&self, class: &Class, store: &Store, pages: &Pages) -> Result<Arc<Tally>, Fault> {
        let mut all = self.0.lock().await;
        let new = || Counted { at: Instant::now(), number: 0, folded: BTreeMap::new(), tally: Arc::default() };
        let counted = all.entry(class.id().to_owned()).or_insert_with(new);
        if counted.number > 0 && counted.at.elapsed() < FRESH {
            return Ok(counted.tally.clone());
        }
        loop {
            let events = store.events(class.id().to_owned(), counted.number, PORTION).await?;
            let Some(last) = events.last() else { break };
            counted.number = last.number;
            let answers = |event: &&EventRow| event.body.contains("\"part\":\"item:");
            events.iter().filter(answers).for_each(|event| counted.folded.entry(event.seat).or_default().add(event));
        }
        let mut tally = Tally::default();
        counted.folded.retain(|seat, _| class.seat(*seat).is_some());
        for (seat, folded) in &counted.folded {
            for document in pages.documents() {
                let items = folded.items(&document.name);
                let given = items.filter_map(|(name, item)| Some((name, document.grader.answer(*seat, name, &item)?)));
                for (question, given) in given {
                    tally.0.entry(question.to_owned()).or_default().insert(*seat, given);
                }
            }
        }
        (counted.at, counted.tally) = (Instant::now(), Arc::new(tally));
        Ok(counted.tally.clone())
    }
}

impl Tally {
    /// Answers that a student may see: numbers if the teacher shows results, and answers of others to questions that the student has
    /// answered.
    pub fn for_student(&self, seat: u32, settings: &Settings) -> Value {
        let own = self.0.iter().filter(|(_, answers)| answers.contains_key(&seat));
        let questions: Vec<Value> = own
            .map(|(question, answers)| {
                let right = answers.values().filter(|given| given.is_right).count();
                let results = settings.results.then(|| json!({ "answered": answers.len(), "right": right }));
                let others = answers.iter().filter(|(other, _)| **other != seat).map(|(_, given)| &given.typed);
                // In alphabetical order, which says nothing of the seats.
                let mut others: Vec<&String> = if settings.others { others.collect() } else { Vec::new() };
                others.sort();
                others.truncate(MOST_SHOWN);
                json!({ "question": question, "results": results, "others": others })
            })
            .collect();
        json!({ "questions": questions })
    }
}
