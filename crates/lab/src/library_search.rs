//! Search in the library by typed words and by topic.

use document::Card;
use std::collections::BTreeMap;
use std::rc::Rc;
use units::order::sort_by_key;
use view::views::*;

/// For each card, true if it matches.
pub type Found = Vec<bool>;

/// Search terms and searchable cards.
pub struct Search {
    /// Typed text.
    pub typed: Signal<String>,
    /// Selected topic.
    pub topic: Signal<Option<String>>,
    /// All topics, the most frequent first.
    pub topics: Vec<String>,
    cards: Rc<Vec<Searched>>,
}

/// Searchable form of a card.
struct Searched {
    text: String,
    topics: Vec<String>,
}

impl Search {
    /// Creates a search over cards, initially without terms.
    pub fn over<'a>(cards: impl Iterator<Item = &'a Card>) -> Self {
        let mut counts: BTreeMap<String, (usize, String)> = BTreeMap::new();
        let mut searched = Vec::new();
        for card in cards {
            let topics: Vec<String> = card.topics.iter().map(|topic| folded(topic)).collect();
            for (key, topic) in topics.iter().zip(&card.topics) {
                counts.entry(key.clone()).or_insert_with(|| (0, topic.clone())).0 += 1;
            }
            let text = [&card.title, &without_tags(&card.summary), &card.topics.join(" ")].map(|text| folded(text));
            searched.push(Searched { text: text.join(" "), topics });
        }
        let mut topics: Vec<(usize, String)> = counts.into_values().collect();
        sort_by_key(&mut topics, |(count, _)| std::cmp::Reverse(*count));
        Self {
            typed: create_signal(String::new()),
            topic: create_signal(None),
            topics: topics.into_iter().map(|(_, topic)| topic).collect(),
            cards: Rc::new(searched),
        }
    }

    /// Matching cards. Every typed word must occur, possibly inside a word.
    pub fn found(&self) -> ReadSignal<Found> {
        let (typed, topic, cards) = (self.typed, self.topic, self.cards.clone());
        memo(move || {
            let (typed, topic) = (folded(&typed.get_clone()), topic.get_clone().map(|topic| folded(&topic)));
            let words: Vec<&str> = typed.split_whitespace().collect();
            let fits = |card: &Searched| {
                let has_topic = topic.as_ref().is_none_or(|topic| card.topics.contains(topic));
                has_topic && words.iter().all(|word| card.text.contains(word))
            };
            cards.iter().map(fits).collect()
        })
    }
}

/// Text for comparison: lower case without accents.
fn folded(text: &str) -> String {
    let decomposed = String::from(js_sys::JsString::from(text.to_lowercase()).normalize("NFD"));
    decomposed.chars().filter(|letter| !('\u{300}'..='\u{36f}').contains(letter)).collect()
}

/// Text of an HTML fragment without its tags.
fn without_tags(html: &str) -> String {
    let parts = html.split('<').map(|part| part.split_once('>').map_or(part, |(_, text)| text));
    parts.collect::<Vec<_>>().join(" ")
}
