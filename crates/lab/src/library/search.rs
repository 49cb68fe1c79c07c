//! Search in the library by typed words and by topic.

use crate::library::Entry;
use document::{Card, Searchable};
use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::rc::Rc;
use units::alphabet::plain;
use units::order::sort_by_key;
use view::views::*;

/// For each card, true if it matches.
pub type Found = Vec<bool>;

/// Search terms and searchable documents.
pub struct Search {
    /// Typed text.
    pub typed: Signal<String>,
    /// Selected topic.
    pub topic: Signal<Option<String>>,
    /// All topics, the most frequent first.
    pub topics: Vec<String>,
    documents: Rc<Documents>,
}

/// Documents in the order of their cards.
struct Documents {
    entries: Vec<Entry>,
    /// Topics in plain letters.
    topics: Vec<Vec<String>>,
    /// Words, collected for the first search.
    words: OnceCell<Vec<Searchable>>,
}

impl Search {
    /// Creates a search over documents with their cards, initially without terms.
    pub fn over<'a>(documents: impl Iterator<Item = (&'a Entry, &'a Card)>) -> Self {
        let mut counts: BTreeMap<String, (usize, String)> = BTreeMap::new();
        let (mut entries, mut plain_topics) = (Vec::new(), Vec::new());
        for (entry, card) in documents {
            let topics: Vec<String> = card.topics.iter().map(|topic| plain(topic)).collect();
            for (key, topic) in topics.iter().zip(&card.topics) {
                counts.entry(key.clone()).or_insert_with(|| (0, topic.clone())).0 += 1;
            }
            entries.push(entry.clone());
            plain_topics.push(topics);
        }
        let mut topics: Vec<(usize, String)> = counts.into_values().collect();
        sort_by_key(&mut topics, |(count, _)| std::cmp::Reverse(*count));
        Self {
            typed: create_signal(String::new()),
            topic: create_signal(None),
            topics: topics.into_iter().map(|(_, topic)| topic).collect(),
            documents: Rc::new(Documents { entries, topics: plain_topics, words: OnceCell::new() }),
        }
    }

    /// Matching documents: each typed word begins a word of one of their files, and they have the selected topic.
    pub fn found(&self) -> ReadSignal<Found> {
        let (typed, topic, documents) = (self.typed, self.topic, self.documents.clone());
        memo(move || {
            let (typed, topic) = (typed.get_clone(), topic.get_clone().map(|topic| plain(&topic)));
            let has_topic = |topics: &Vec<String>| topic.as_ref().is_none_or(|topic| topics.contains(topic));
            let mut found: Found = documents.topics.iter().map(has_topic).collect();
            if !typed.trim().is_empty() {
                for (found, words) in found.iter_mut().zip(documents.words()) {
                    *found &= words.has(&typed);
                }
            }
            found
        })
    }
}

impl Documents {
    fn words(&self) -> &[Searchable] {
        let searchable = |entry: &Entry| Searchable::of(entry.files.iter().map(|file| &*file.text));
        self.words.get_or_init(|| self.entries.iter().map(searchable).collect())
    }
}
