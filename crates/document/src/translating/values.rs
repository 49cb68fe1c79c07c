//! Texts of a file by their keys, and their places.

use super::key::TextKey;
use super::translation::entry;
use crate::blocks::questions;
use crate::scene::normalised;
use crate::{BlockKind, Outline};
use model::{Span, inside};

/// Keys of the front matter that are translated.
const FRONT: [&str; 4] = ["title", "summary", "topics", "keywords"];

/// All texts of a file, except those of its model and its drawing.
pub fn values(outline: &Outline) -> Vec<(TextKey, String)> {
    let source = outline.source();
    let front = FRONT
        .into_iter()
        .filter_map(|key| outline.front_matter().get(key).map(|value| (TextKey::Front(key), value.text.clone())));
    let mut found: Vec<(TextKey, String)> = front.collect();
    let (mut questions, mut pieces) = (0, 0);
    for block in outline.blocks() {
        match block.kind {
            BlockKind::Prose if !source[block.content.range()].trim().is_empty() => {
                let text = source[block.content.range()].trim();
                found.push((TextKey::Prose(questions, pieces), text.to_owned()));
                pieces += 1;
            }
            BlockKind::Translations => {
                let entries = block.sentences.iter().filter_map(|sentence| entry(source, sentence));
                found.extend(
                    entries.map(|(original, text)| {
                        (TextKey::Short(normalised(original)), inside(source, text).to_owned())
                    }),
                );
            }
            BlockKind::Question => {
                for (key, part) in [
                    (TextKey::Prompt(questions), None),
                    (TextKey::Hint(questions), Some("hint")),
                    (TextKey::Explanation(questions), Some("explanation")),
                ] {
                    let place = questions::part(source, block.content.range(), part);
                    let text = place.map(|place| source[place].to_owned()).unwrap_or_default();
                    if !text.is_empty() {
                        found.push((key, text));
                    }
                }
                (questions, pieces) = (questions + 1, 0);
            }
            _ => {}
        }
    }
    found
}

/// Places of a translation: its text without quotation marks, and its whole entry.
pub fn entry_in(outline: &Outline, key: &str) -> Option<(Span, Span)> {
    let mut sentences = outline.blocks_of(BlockKind::Translations).flat_map(|block| &block.sentences);
    sentences.find_map(|sentence| {
        let (original, text) = entry(outline.source(), sentence)?;
        (normalised(original) == key).then(|| (Span::new(text.start + 1, text.end - 1), sentence.span))
    })
}

/// Index of the block of a piece of prose. The error is the index of the block after which it belongs; `None` for the
/// beginning.
pub fn prose_at(outline: &Outline, segment: usize, piece: usize) -> Result<usize, Option<usize>> {
    let (mut questions, mut pieces) = (0, 0);
    let mut after = None;
    for (number, block) in outline.blocks().iter().enumerate() {
        match block.kind {
            BlockKind::Prose if !outline.source()[block.content.range()].trim().is_empty() => {
                if (questions, pieces) == (segment, piece) {
                    return Ok(number);
                }
                pieces += 1;
            }
            BlockKind::Question => (questions, pieces) = (questions + 1, 0),
            _ => {}
        }
        if questions <= segment {
            after = Some(number);
        }
    }
    Err(after)
}

/// Index of the block of a question.
pub fn question_at(outline: &Outline, number: usize) -> Option<usize> {
    let blocks = outline.blocks().iter().enumerate();
    blocks.filter(|(_, block)| block.kind == BlockKind::Question).map(|(place, _)| place).nth(number)
}
