//! Search for documents by the words that a person types.

use crate::blocks::front_matter::read;
use crate::card;
use crate::text::block::BlockKind;
use crate::text::fences;
use crate::text::outline::LENGTH;
use units::alphabet::plain;

/// Words of a document and its translations.
pub struct Searchable {
    /// Each word after a blank, without accents, in lower case.
    words: String,
}

impl Searchable {
    /// Words of titles, summaries, topics, keywords, prose, questions and labels in all files of a document.
    pub fn of<'a>(files: impl Iterator<Item = &'a str>) -> Self {
        let mut words = String::new();
        for source in files.filter(|source| source.len() <= LENGTH) {
            add_file(&mut words, source);
        }
        Self { words }
    }

    /// True if each of the typed words begins a word of the document.
    pub fn has(&self, typed: &str) -> bool {
        let mut wanted = String::new();
        add(&mut wanted, typed);
        wanted.split_whitespace().all(|word| self.words.contains(&format!(" {word}")))
    }
}

fn add_file(words: &mut String, source: &str) {
    let matter = read(source, &mut Vec::new());
    for key in ["title", "summary", "topics"] {
        add(words, matter.get(key).map_or("", |value| &value.text));
    }
    for keyword in card::keywords(&matter) {
        add(words, &keyword);
    }
    for block in fences::split(source, matter.span.end..source.len(), &mut Vec::new()) {
        let text = source.get(block.content.range()).unwrap_or_default();
        match block.kind {
            BlockKind::Prose | BlockKind::Question => add(words, text),
            BlockKind::Scene | BlockKind::Table => {}
            // Labels, which stand in quotation marks.
            _ => text.lines().flat_map(|line| line.split('"').skip(1).step_by(2)).for_each(|label| add(words, label)),
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
