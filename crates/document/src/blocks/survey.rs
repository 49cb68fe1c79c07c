//! The survey: `scale "I saw why it decays": 5 steps from "no" to "yes"`.

use crate::text::block::BlockKind;
use crate::text::outline::Outline;
use crate::text::source::trim;
use model::{Diagnostic, Phrase, Sentence, Span};
use program::{SurveyItem, SurveyKind, SurveyText};
use units::alphabet::plain;
use units::{Words, nearest, words};

/// Other words for the kinds of items, in Spanish and English, without accents.
const OTHER_WORDS: [(&str, SurveyKind); 12] = [
    ("rol", SurveyKind::Role),
    ("papel", SurveyKind::Role),
    ("grupo", SurveyKind::Role),
    ("escala", SurveyKind::Scale),
    ("rating", SurveyKind::Scale),
    ("likert", SurveyKind::Scale),
    ("opcion", SurveyKind::Choice),
    ("opciones", SurveyKind::Choice),
    ("options", SurveyKind::Choice),
    ("texto", SurveyKind::Text),
    ("comment", SurveyKind::Text),
    ("comentario", SurveyKind::Text),
];

/// An item as written.
#[derive(Clone, Debug)]
pub struct RawItem {
    span: Span,
    item: SurveyItem,
    text: SurveyText,
}

/// Items of all survey blocks of a file, in text order; `None` for one that cannot be read.
pub fn read(outline: &Outline, diagnostics: &mut Vec<Diagnostic>) -> Vec<Option<RawItem>> {
    let source = outline.source();
    let mut items = Vec::new();
    for sentence in outline.blocks_of(BlockKind::Survey).flat_map(|block| &block.sentences) {
        if items.len() == SurveyItem::MOST {
            let most = SurveyItem::MOST;
            let message = words!("a survey cannot have more than {most} items");
            diagnostics.push(Diagnostic::error("too-large", message, sentence.span));
            break;
        }
        match item(source, sentence) {
            Ok(item) => items.push(Some(item)),
            Err(diagnostic) => {
                diagnostics.push(*diagnostic);
                items.push(None);
            }
        }
    }
    items
}

/// The items that can be asked, their texts, and the index of each item as written. The others are reported.
pub fn kept(
    written: Vec<Option<RawItem>>,
    diagnostics: &mut Vec<Diagnostic>,
) -> (Vec<SurveyItem>, Vec<SurveyText>, Vec<Option<usize>>) {
    let mut kept: Vec<RawItem> = Vec::new();
    let mut numbers = Vec::new();
    for raw in written {
        let clash = raw.as_ref().and_then(|raw| {
            let same = |other: &&RawItem| {
                other.item.kind == raw.item.kind
                    && (raw.item.kind == SurveyKind::Role || other.text.asked == raw.text.asked)
            };
            kept.iter().find(same).map(|first| clash(raw, first))
        });
        let good = raw.filter(|_| clash.is_none());
        diagnostics.extend(clash);
        numbers.push(good.is_some().then_some(kept.len()));
        kept.extend(good);
    }
    let (items, texts) = kept.into_iter().map(|raw| (raw.item, raw.text)).unzip();
    (items, texts, numbers)
}

fn clash(raw: &RawItem, first: &RawItem) -> Diagnostic {
    let (message, hint) = if raw.item.kind == SurveyKind::Role {
        (words("a survey asks for the role once"), words("make it a `choice`, or remove it"))
    } else {
        let asked = &raw.text.asked;
        (words!("the survey asks \"{asked}\" twice"), words("change the text, or remove it"))
    };
    Diagnostic::error("survey-syntax", message, raw.span).with_label(first.span, words("here first")).with_hint(hint)
}

/// Texts of the survey in a translation. `numbers`: index in the document of each item as written in the original.
/// Where a text is missing or does not fit, the original is used, and that is reported, at `place` for missing ones.
pub fn translated(
    written: Vec<Option<RawItem>>,
    numbers: &[Option<usize>],
    (items, originals): (&[SurveyItem], &[SurveyText]),
    place: Span,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<SurveyText> {
    let mut texts = originals.to_vec();
    let missing = numbers.iter().skip(written.len()).flatten().count();
    for (place, raw) in written.into_iter().enumerate() {
        let Some(raw) = raw else { continue };
        let Some(number) = numbers.get(place) else {
            let message = words!("the survey of the original has {} items only", numbers.len());
            diagnostics.push(
                Diagnostic::error("translation", message, raw.span)
                    .with_hint(words("remove it, or add it to the original")),
            );
            continue;
        };
        let Some(number) = *number else { continue };
        match (items.get(number), texts.get_mut(number)) {
            (Some(item), Some(text)) if *item == raw.item => *text = raw.text,
            (Some(item), _) => diagnostics.push(other_item(&raw, *item, place + 1)),
            _ => {}
        }
    }
    if missing > 0 {
        let message = match missing {
            1 => words("an item of the survey has no translation"),
            _ => words!("{missing} items of the survey have no translation"),
        };
        diagnostics.push(
            Diagnostic::warning("untranslated", message, place)
                .with_hint(words("add a block `survey` with the same items in the same order")),
        );
    }
    texts
}

/// Error for an item of a translation that is not that of the original.
fn other_item(raw: &RawItem, item: SurveyItem, number: usize) -> Diagnostic {
    let SurveyItem { kind, answers } = item;
    let kind_word = kind.word();
    let message = match kind {
        SurveyKind::Text => words!("item {number} of the original is a `{kind_word}`"),
        SurveyKind::Scale => words!("item {number} of the original is a `{kind_word}` of {answers} steps"),
        SurveyKind::Role | SurveyKind::Choice => {
            words!("item {number} of the original is a `{kind_word}` with {answers} alternatives")
        }
    };
    Diagnostic::error("translation", message, raw.span)
        .with_hint(words("the items stand in the order of the original and have its kinds and numbers"))
}

/// Reads one item.
fn item(source: &str, sentence: &Sentence) -> Result<RawItem, Box<Diagnostic>> {
    let span = sentence.span;
    let length = source[span.range()].find(|c: char| !c.is_alphanumeric()).unwrap_or(span.end - span.start);
    let place = Span::new(span.start, span.start + length);
    let word = &source[place.range()];
    let Some(kind) = SurveyKind::ALL.into_iter().find(|kind| kind.word() == word) else {
        return Err(Box::new(unknown(word, place, span)));
    };
    let asked = sentence.title_text(source).filter(|_| sentence.head.is_some());
    let asked = asked.ok_or_else(|| fault(words!("the `{word}` has no text"), span, kind))?.trim();
    let rest = sentence.rest();
    let text = |words: Vec<String>| SurveyText { asked: asked.to_owned(), words };
    let (answers, text) = match (kind, sentence.colon) {
        (SurveyKind::Text, _) if rest.start == rest.end => (0, text(Vec::new())),
        (SurveyKind::Text, _) => {
            let message = words("nothing stands behind the text of a `text`");
            return Err(fault(message, rest, kind));
        }
        (_, None) => {
            let message = match kind {
                SurveyKind::Scale => words("the scale has no steps"),
                _ => words!("the `{word}` has no alternatives"),
            };
            return Err(fault(message, span, kind));
        }
        (SurveyKind::Scale, Some(_)) => {
            let (steps, ends) = steps(source, sentence)?;
            (steps, text(ends))
        }
        (_, Some(_)) => {
            let words = alternatives(source, sentence, kind)?;
            (words.len(), text(words))
        }
    };
    let longest = SurveyItem::LONGEST;
    if std::iter::once(&text.asked).chain(&text.words).any(|text| text.chars().count() > longest) {
        let message = words!("a text of a survey has at most {longest} characters");
        return Err(Box::new(Diagnostic::error("too-large", message, span)));
    }
    Ok(RawItem { span, item: SurveyItem { kind, answers }, text })
}

/// The text that is the whole phrase and not blank.
fn quoted<'a>(source: &'a str, phrase: Phrase) -> Option<&'a str> {
    phrase.text(source).map(str::trim).filter(|text| !text.is_empty())
}

/// Reads `5 steps from "no" to "yes"`.
fn steps(source: &str, sentence: &Sentence) -> Result<(usize, Vec<String>), Box<Diagnostic>> {
    let unreadable = || {
        let message = words("a scale is a number of steps and the words at both ends");
        fault(message, sentence.body, SurveyKind::Scale)
    };
    let mut phrases = sentence.phrases();
    let phrase = phrases.next().filter(|_| phrases.next().is_none()).ok_or_else(unreadable)?;
    let from = phrase.split_first("from").ok_or_else(unreadable)?;
    let to = from.after.split_first("to").ok_or_else(unreadable)?;
    let counted = from.before.span();
    let digits = source[counted.range()].bytes().take_while(u8::is_ascii_digit).count();
    let number = Span::new(counted.start, counted.start + digits);
    let steps: Option<usize> = source[number.range()].parse().ok();
    let (low, high) = quoted(source, to.before).zip(quoted(source, to.after)).ok_or_else(unreadable)?;
    if &source[trim(source, number.end..counted.end)] != "steps" {
        return Err(unreadable());
    }
    let most = SurveyItem::MOST_STEPS;
    let Some(steps) = steps.filter(|steps| (2..=most).contains(steps)) else {
        let message = words!("a scale has 2 to {most} steps");
        return Err(fault(message, number, SurveyKind::Scale));
    };
    Ok((steps, vec![low.to_owned(), high.to_owned()]))
}

/// Reads `"student", "teacher"`.
fn alternatives(source: &str, sentence: &Sentence, kind: SurveyKind) -> Result<Vec<String>, Box<Diagnostic>> {
    let mut found: Vec<String> = Vec::new();
    for part in sentence.phrases() {
        let span = part.span();
        let Some(text) = quoted(source, part) else {
            let message = words("an alternative is a text in quotation marks");
            return Err(fault(message, span, kind));
        };
        if found.iter().any(|other| other == text) {
            let message = words!("the alternative \"{text}\" is written twice");
            return Err(Box::new(
                Diagnostic::error("survey-syntax", message, span).with_hint(words("remove one of the two")),
            ));
        }
        found.push(text.to_owned());
    }
    let most = SurveyItem::MOST_ALTERNATIVES;
    if !(2..=most).contains(&found.len()) {
        let message = words!("there must be 2 to {most} alternatives");
        return Err(fault(message, sentence.body, kind));
    }
    Ok(found)
}

/// An error with an example of such an item.
fn fault(message: Words, span: Span, kind: SurveyKind) -> Box<Diagnostic> {
    let hint = match kind {
        SurveyKind::Role => words("write `role \"You are a\": \"student\", \"teacher\"`"),
        SurveyKind::Scale => words("write `scale \"It was clear\": 5 steps from \"disagree\" to \"agree\"`"),
        SurveyKind::Choice => words("write `choice \"What helped most?\": \"drawing\", \"plots\"`"),
        SurveyKind::Text => words("write `text \"What would you change?\"`"),
    };
    Box::new(Diagnostic::error("survey-syntax", message, span).with_hint(hint))
}

/// Error for an item that begins with another word, with the word that is meant as a remedy.
fn unknown(word: &str, place: Span, line: Span) -> Diagnostic {
    let message = if word.is_empty() {
        words("an item of a survey begins with its kind")
    } else {
        words!("a survey has no `{word}`")
    };
    let at = if word.is_empty() { line } else { place };
    let diagnostic = Diagnostic::error("survey-syntax", message, at);
    let plain = plain(word);
    let other = OTHER_WORDS.iter().find(|(other, _)| *other == plain).map(|(_, kind)| kind.word());
    match other.or_else(|| nearest(word, SurveyKind::ALL.map(SurveyKind::word))) {
        Some(meant) => diagnostic.meaning(meant),
        None => diagnostic.with_hint(words("the kinds are `role`, `scale`, `choice` and `text`")),
    }
}
