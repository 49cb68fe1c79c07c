//! Edits of single texts of a translation.

use super::blocks::{insert_block, replace_block};
use super::layout::{begin_line, line_end, result, with_line_ends_of};
use super::obstacle::Obstacle;
use super::question::write_part;
use super::settings::set_front_matter;
use super::{Edit, EditError};
use crate::BlockKind;
use crate::text::outline::{Outline, read};
use crate::translating::{TextKey, entry_in, prose_at, question_at, values};
use model::Span;

/// Sets the translation of a text in the file of the translation; an empty text removes it. Missing parts are added: a
/// label at the end of the last block `translations`, prose and questions in their order.
///
/// # Errors
///
/// [`EditError::NotOneCell`] if the text would not be parsed as this translation alone, [`EditError::EarlierQuestion`] if
/// questions before this one are missing, [`EditError::Value`] for front matter, and the errors of edits of blocks.
pub fn set_translation(outline: &Outline, key: &TextKey, text: &str) -> Result<Vec<Edit>, EditError> {
    let text = with_line_ends_of(outline.source(), text.trim());
    let before = values(outline);
    if before.iter().any(|(known, present)| known == key && *present == text)
        || text.is_empty() && !before.iter().any(|(known, _)| known == key)
    {
        return Ok(Vec::new());
    }
    let edits = match key {
        TextKey::Front(key) => set_front_matter(outline, key, Some(text.as_str()).filter(|text| !text.is_empty()))?,
        TextKey::Short(original) => vec![short(outline, original, &text)?],
        TextKey::Prose(segment, piece) => vec![prose(outline, *segment, *piece, &text)?],
        TextKey::Prompt(number) => vec![question(outline, *number, None, &text)?],
        TextKey::Hint(number) => vec![question(outline, *number, Some("hint"), &text)?],
        TextKey::Explanation(number) => vec![question(outline, *number, Some("explanation"), &text)?],
    };
    let after = values(&read(&result(outline, &edits)?));
    // The pieces of prose after a removed one are renumbered.
    let shifts = |other: &TextKey| text.is_empty() && matches!(other, TextKey::Prose(..));
    let others = |texts: &[(TextKey, String)]| -> Vec<(TextKey, String)> {
        texts.iter().filter(|(other, _)| other != key && !shifts(other)).cloned().collect()
    };
    let stands = text.is_empty() || after.iter().any(|(other, written)| other == key && *written == text);
    if stands && others(&before) == others(&after) {
        return Ok(edits);
    }
    Err(EditError::NotOneCell(match key {
        TextKey::Front(_) | TextKey::Short(_) => Obstacle::of(&text, &["\n"]),
        TextKey::Prose(..) => Obstacle::in_prose(&text),
        TextKey::Prompt(_) | TextKey::Hint(_) | TextKey::Explanation(_) => Obstacle::in_question(&text),
    }))
}

/// Edit of an entry `"original" = "text"`.
fn short(outline: &Outline, original: &str, text: &str) -> Result<Edit, EditError> {
    let source = outline.source();
    if text.contains(['"', '\n', '\r']) {
        return Err(EditError::NotOneCell(Obstacle::of(text, &["\n", "\""])));
    }
    if let Some((place, line)) = entry_in(outline, original) {
        let end = source[line.end..].find('\n').map_or(source.len(), |at| line.end + at + 1);
        let span = if text.is_empty() { Span::new(line.start, end) } else { place };
        return Ok(Edit { span, text: text.to_owned() });
    }
    let entry = format!("\"{original}\" = \"{text}\"");
    let blocks = outline.blocks();
    if let Some(last) = blocks.iter().rfind(|block| block.kind == BlockKind::Translations) {
        let at = last.content.end;
        let text = format!("{}{entry}{}", begin_line(source, at), line_end(source));
        return Ok(Edit { span: Span::new(at, at), text });
    }
    let first_prose = blocks.iter().position(|block| block.kind == BlockKind::Prose);
    insert_block(outline, first_prose, BlockKind::Translations, &entry)
}

fn prose(outline: &Outline, segment: usize, piece: usize, text: &str) -> Result<Edit, EditError> {
    match prose_at(outline, segment, piece) {
        Ok(number) => {
            let block = outline.blocks().get(number).ok_or(EditError::UnknownBlock(number))?;
            let old = &outline.source()[block.content.range()];
            let begin = &old[..old.len() - old.trim_start().len()];
            let end = &old[old.trim_end().len()..];
            let text =
                if text.is_empty() { line_end(outline.source()).to_owned() } else { format!("{begin}{text}{end}") };
            replace_block(outline, number, &text)
        }
        Err(after) => {
            let end = line_end(outline.source());
            insert_block(outline, after, BlockKind::Prose, &format!("{end}{text}{end}{end}"))
        }
    }
}

fn question(outline: &Outline, number: usize, word: Option<&str>, text: &str) -> Result<Edit, EditError> {
    let source = outline.source();
    let Some(block) = question_at(outline, number) else {
        let count = outline.blocks_of(BlockKind::Question).count();
        if count < number {
            return Err(EditError::EarlierQuestion(number));
        }
        let last = outline.blocks().len().checked_sub(1);
        let content = word.map_or_else(|| text.to_owned(), |word| format!("{word}: {text}"));
        return insert_block(outline, last, BlockKind::Question, &content);
    };
    let content = outline.blocks().get(block).ok_or(EditError::UnknownBlock(block))?.content;
    Ok(write_part(source, content, word, text))
}
