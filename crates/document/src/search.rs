//! Search for documents by the words that a person types.

use crate::blocks::front_matter::read;
use crate::card;
use crate::text::block::BlockKind;
use crate::text::fences;
use crate::text::outline::LENGTH;
use units::alphabet::plain;

/// Words of a document and its translations.
pub struct Searchable {
    /// Of titles, summaries, topics and keywords: each word after a blank, without accents, in lower case.
    names: String,
    /// Of prose, questions and labels, likewise.
    texts: String,
}

/// Words of at most so many letters are not looked for in texts if no longer one is typed: *MAS* is an abbreviation, and *más* is
/// in every text.
const SHORT: usize = 3;

impl Searchable {
    /// Words of titles, summaries, topics, keywords, prose, questions and labels in all files of a document.
    pub fn of<'a>(files: impl Iterator<Item = &'a str>) -> Self {
        let mut words = Self { names: String::new(), texts: String::new() };
        for source in files.filter(|source| source.len() <= LENGTH) {
            words.add_file(source);
        }
        words
    }

    /// True if each of the typed words begins a word of the document.
    pub fn has(&self, typed: &str) -> bool {
        let mut wanted = String::new();
        add(&mut wanted, typed);
        let is_short = wanted.split_whitespace().all(|word| word.chars().count() <= SHORT);
        wanted.split_whitespace().all(|word| {
            let begun = format!(" {word}");
            self.names.contains(&begun) || !is_short && self.texts.contains(&begun)
        })
    }

    fn add_file(&mut self, source: &str) {
        let matter = read(source, &mut Vec::new());
        for key in ["title", "summary", "topics"] {
            add(&mut self.names, matter.get(key).map_or("", |value| &value.text));
        }
        for keyword in card::keywords(&matter) {
            add(&mut self.names, &keyword);
        }
        for block in fences::split(source, matter.span.end..source.len(), &mut Vec::new()) {
            let text = source.get(block.content.range()).unwrap_or_default();
            match block.kind {
                BlockKind::Prose | BlockKind::Question => add(&mut self.texts, text),
                BlockKind::Scene | BlockKind::Table => {}
                // Labels, which stand in quotation marks.
                _ => text
                    .lines()
                    .flat_map(|line| line.split('"').skip(1).step_by(2))
                    .for_each(|label| add(&mut self.texts, label)),
            }
        }
    }
}

/// Adds the words of a text.
fn add(words: &mut String, text: &str) {
    for word in plain(text).split(|letter: char| !letter.is_alphanumeric()).filter(|word| !word.is_empty()) {
        words.push(' ');
        words.push_str(word);
    }
}
