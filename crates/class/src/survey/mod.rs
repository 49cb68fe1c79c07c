//! The answers of a class to a survey.
//!
//! Nothing is shown of an item with fewer than [`LEAST`] answers, and no result depends on the order of the sheets.
//!
//! `page.rs` makes the sections of page and dashboard.

mod marks;
pub mod page;
mod stop_words;
mod words;

pub use marks::{Comment, Mark, MarkedComments};
pub use words::{Word, frequent_words};

use crate::share::Share;
use saved::survey::{ItemKind, Sheet, SurveyAnswer, SurveyItem};
use std::collections::BTreeMap;
use units::order::{sort, sort_by_key};

/// Number of answers from which an item is shown.
pub const LEAST: usize = 5;

/// Results of the survey of one document.
#[derive(Clone, Debug, PartialEq)]
pub struct Results {
    /// Title of the document.
    pub document: String,
    /// Number of sheets.
    pub sheets: usize,
    /// Items with at least [`LEAST`] answers, in the order of the document.
    pub tallies: Vec<Tally>,
    /// Number of items with fewer answers, but at least one.
    pub held_back: usize,
}

/// Answers to one item.
#[derive(Clone, Debug, PartialEq)]
pub struct Tally {
    /// The item.
    pub item: SurveyItem,
    /// Number of persons who have answered it.
    pub count: usize,
    /// Share of each alternative or step; empty for free text.
    pub shares: Vec<Share>,
    /// Free texts in alphabetical order.
    pub comments: Vec<String>,
    /// Frequent words of the free texts.
    pub words: Vec<Word>,
}

impl Tally {
    /// The alternatives, or the numbers of the steps.
    pub fn answers(&self) -> Vec<String> {
        match self.item.kind {
            ItemKind::Scale => (1..=self.item.answers).map(|step| step.to_string()).collect(),
            ItemKind::Role | ItemKind::Choice => self.item.words.clone(),
            ItemKind::Text => Vec::new(),
        }
    }
}

/// Answers to an item: its first place in a sheet, the number of each answer, and the free texts.
#[derive(Default)]
struct Gathered<'a> {
    place: usize,
    chosen: Vec<usize>,
    typed: Vec<&'a str>,
}

/// Results of each document, by its title. Items of different texts are different items.
pub fn results(sheets: &[Sheet]) -> Vec<Results> {
    let mut documents: BTreeMap<&str, Vec<&Sheet>> = BTreeMap::new();
    for sheet in sheets {
        documents.entry(&sheet.document).or_default().push(sheet);
    }
    documents.into_iter().map(|(document, sheets)| results_of(document, &sheets)).collect()
}

fn results_of(document: &str, sheets: &[&Sheet]) -> Results {
    let mut gathered: BTreeMap<&SurveyItem, Gathered<'_>> = BTreeMap::new();
    for sheet in sheets {
        for (place, (item, answer)) in sheet.items.iter().enumerate() {
            let of_item = gathered.entry(item).or_insert_with(|| Gathered {
                place,
                chosen: vec![0; item.answers],
                typed: Vec::new(),
            });
            of_item.place = of_item.place.min(place);
            match answer {
                Some(SurveyAnswer::Chosen(index)) => {
                    if let Some(count) = of_item.chosen.get_mut(*index) {
                        *count += 1;
                    }
                }
                Some(SurveyAnswer::Typed(text)) => of_item.typed.push(text),
                None => {}
            }
        }
    }
    let mut tallies = Vec::new();
    let mut held_back = 0;
    for (item, mut of_item) in gathered {
        let count = of_item.chosen.iter().sum::<usize>() + of_item.typed.len();
        held_back += usize::from((1..LEAST).contains(&count));
        if count < LEAST {
            continue;
        }
        sort(&mut of_item.typed);
        let shares = of_item.chosen.iter().map(|&chosen| Share { count: chosen, of: count }).collect();
        let comments: Vec<String> = of_item.typed.iter().map(|&text| text.to_owned()).collect();
        let words = frequent_words(&comments);
        tallies.push((of_item.place, Tally { item: item.clone(), count, shares, comments, words }));
    }
    // Stable: items at the same place stay in the order of their names.
    sort_by_key(&mut tallies, |(place, _)| *place);
    let tallies = tallies.into_iter().map(|(_, tally)| tally).collect();
    Results { document: document.to_owned(), sheets: sheets.len(), tallies, held_back }
}
