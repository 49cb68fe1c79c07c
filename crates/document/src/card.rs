//! Entry of a file in a list of documents: title, one sentence and topics. The model is not read, so that long lists are
//! fast.

use crate::blocks::front_matter::{FrontMatter, Value, read};
use crate::prose::Prose;
use crate::text::block::BlockKind;
use crate::text::fences;
use crate::text::outline::LENGTH;
use model::{Diagnostic, Span};
use program::Block;
use units::markup::escaped;
use units::{Words, words};

/// Maximum length of a summary, in characters.
const SUMMARY: usize = 200;
/// Maximum number of topics of a document.
const TOPICS: usize = 6;
/// Maximum number of keywords of a document.
const KEYWORDS: usize = 24;
/// Maximum length of a topic or keyword, in characters.
const TOPIC: usize = 40;

/// Entry of a document or of a translation in a list.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Card {
    /// Title; empty without one.
    pub title: String,
    /// Language tag; `en` by default.
    pub language: String,
    /// Name of the translated file, if this is a translation.
    pub translates: Option<String>,
    /// Summary as safe HTML: the `summary` of the front matter, or else the first sentence of the prose.
    pub summary: String,
    /// Topics as written.
    pub topics: Vec<String>,
}

/// Card of a document or of a translation. Always succeeds; errors are reported by [`crate::open()`]. Empty for a text of
/// more than 1 MB.
pub fn card(source: &str) -> Card {
    let source = if source.len() > LENGTH { "" } else { source };
    let matter = read(source, &mut Vec::new());
    let text = |key: &str| matter.get(key).map(|value| value.text.clone());
    let summary = matter.get("summary").filter(|summary| is_short(&summary.text, SUMMARY));
    Card {
        title: text("title").unwrap_or_default(),
        language: text("language").unwrap_or_else(|| "en".to_owned()),
        translates: text("translates"),
        summary: summary.map_or_else(|| first_sentence(source, &matter), |summary| escaped(&summary.text)),
        topics: matter.get("topics").map(|value| list(value, TOPICS)).unwrap_or_default(),
    }
}

fn is_short(text: &str, most: usize) -> bool {
    text.chars().nth(most).is_none()
}

/// Keywords of a file.
pub(crate) fn keywords(matter: &FrontMatter) -> Vec<String> {
    matter.get("keywords").map(|value| list(value, KEYWORDS)).unwrap_or_default()
}

/// Topics or keywords with their places.
fn placed(value: &Value) -> impl Iterator<Item = (&str, Span)> {
    let is_quoted = value.span.range().len() > value.text.len();
    let mut at = value.span.start + usize::from(is_quoted);
    value.text.split(',').map(move |part| {
        let start = at + (part.len() - part.trim_start().len());
        at += part.len() + 1;
        let topic = part.trim();
        (topic, Span::new(start, start + topic.len()))
    })
}

/// Valid topics or keywords, each once, at most `most`.
fn list(value: &Value, most: usize) -> Vec<String> {
    let mut topics: Vec<String> = Vec::new();
    for (topic, _) in placed(value) {
        if !topic.is_empty()
            && is_short(topic, TOPIC)
            && topics.len() < most
            && !topics.iter().any(|other| other == topic)
        {
            topics.push(topic.to_owned());
        }
    }
    topics
}

/// Reports errors in `summary`, `topics` and `keywords`.
pub(crate) fn check(matter: &FrontMatter, diagnostics: &mut Vec<Diagnostic>) {
    if let Some(summary) = matter.get("summary").filter(|summary| !is_short(&summary.text, SUMMARY)) {
        let message = words!("`summary` has more than {SUMMARY} characters");
        diagnostics.push(
            Diagnostic::error("setting", message, summary.span)
                .with_hint(words("it is one sentence for a list; the rest belongs to the prose")),
        );
    }
    for (key, most, of) in [("topics", TOPICS, TOPIC_WORDS), ("keywords", KEYWORDS, KEYWORD_WORDS)] {
        if let Some(value) = matter.get(key) {
            diagnostics.extend(check_list(value, most, &of));
        }
    }
}

/// Names of an element of a list: alone, with *the*, and several.
type Names = [Words; 3];

const TOPIC_WORDS: Names = [words("a topic"), words("the topic"), words("topics")];
const KEYWORD_WORDS: Names = [words("a keyword"), words("the keyword"), words("keywords")];

/// First error in a list of topics or keywords.
fn check_list(value: &Value, most: usize, names: &Names) -> Option<Diagnostic> {
    let [one, the, many] = names;
    let mut before: Vec<&str> = Vec::new();
    for (topic, span) in placed(value) {
        let message = if topic.is_empty() {
            words!("{one} is missing between two commas")
        } else if !is_short(topic, TOPIC) {
            words!("{one} has more than {TOPIC} characters")
        } else if before.contains(&topic) {
            words!("{the} `{topic}` is given twice")
        } else if before.len() == most {
            words!("a document has at most {most} {many}")
        } else {
            before.push(topic);
            continue;
        };
        return Some(
            Diagnostic::error("setting", message, span).with_hint(words("write a few words with commas between them")),
        );
    }
    None
}

/// Reports parts of the document's card that the translation lacks. `language` is the place of the translation's language.
pub(crate) fn check_translated(
    original: &str,
    translation: &FrontMatter,
    language: Span,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let original = read(original, &mut Vec::new());
    for key in ["summary", "topics", "keywords"] {
        if original.get(key).is_some() && translation.get(key).is_none() {
            let message = words!("`{key}` has no translation");
            diagnostics.push(
                Diagnostic::warning("untranslated", message, language)
                    .with_hint(words!("add a line `{key}` to the front matter")),
            );
        }
    }
}

/// First sentence of the prose, as HTML.
fn first_sentence(source: &str, matter: &FrontMatter) -> String {
    let blocks = fences::split(source, matter.span.end..source.len(), &mut Vec::new());
    let paragraph = |html: &str| {
        let (_, rest) = html.split_once("<p>")?;
        let (paragraph, _) = rest.split_once("</p>")?;
        Some(sentence(paragraph).to_owned())
    };
    let mut sentences = blocks.iter().filter(|block| block.kind == BlockKind::Prose).filter_map(|block| {
        let mut prose = Prose::new(source);
        prose.markdown(block.content.range());
        let (sections, _) = prose.finish();
        sections.iter().flat_map(|section| &section.blocks).find_map(|block| match block {
            Block::Html(html) => paragraph(html),
            Block::Question(_) => None,
        })
    });
    sentences.next().unwrap_or_default()
}

/// Text up to the first full stop that is outside all elements and not followed by a lower-case letter, as in *e.g.*
fn sentence(html: &str) -> &str {
    let (mut depth, mut in_tag) = (0_i32, false);
    for (at, letter) in html.char_indices() {
        let end = at + letter.len_utf8();
        let rest = html.get(end..).unwrap_or_default();
        match letter {
            '<' => {
                in_tag = true;
                let is_void = ["br", "img", "hr", "wbr"].iter().any(|name| rest.starts_with(name));
                depth += if rest.starts_with('/') { -1 } else { i32::from(!is_void) };
            }
            '>' => in_tag = false,
            '.' | '!' | '?' if depth == 0 && !in_tag => {
                let next = rest.trim_start();
                if rest.is_empty() || (next.len() < rest.len() && !next.starts_with(char::is_lowercase)) {
                    return html.get(..end).unwrap_or(html);
                }
            }
            _ => {}
        }
    }
    html
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentences_end_at_full_stops_outside_of_elements() {
        for (html, expected) in [
            ("A ball falls. It bounces.", "A ball falls."),
            ("One alone", "One alone"),
            ("Of 3.5 m, e.g. a rod. Then", "Of 3.5 m, e.g. a rod."),
            ("In <em>A. B.</em> it stands! Yes.", "In <em>A. B.</em> it stands!"),
            ("A line<br>and more. Then", "A line<br>and more."),
            ("With <math><mi>x</mi><mo>.</mo></math> in it.\nMore", "With <math><mi>x</mi><mo>.</mo></math> in it."),
        ] {
            assert_eq!(sentence(html), expected);
        }
    }

    #[test]
    fn a_card_shows_what_the_front_matter_says_or_the_first_sentence() {
        let stated = card(
            "---\ntitle: A ball\nlanguage: es\ntranslates: ball.md\nsummary: \"Bota & salta.\"\ntopics: choques , mecánica\n---\n\nOtra.",
        );
        assert_eq!(
            stated,
            Card {
                title: "A ball".to_owned(),
                language: "es".to_owned(),
                translates: Some("ball.md".to_owned()),
                summary: "Bota &amp; salta.".to_owned(),
                topics: vec!["choques".to_owned(), "mecánica".to_owned()],
            }
        );
        let bare = card("# A heading\n\n```model\nx = 1\n```\n\nA *ball* & $x$. It bounces.\n\nMore.");
        assert_eq!((bare.title.as_str(), bare.language.as_str(), bare.topics.len()), ("", "en", 0));
        assert!(bare.summary.starts_with("A <em>ball</em> &amp; <math"), "{}", bare.summary);
        assert!(bare.summary.ends_with("</math>."), "{}", bare.summary);
        let hostile = card("A <script>harm()</script> ball. Then").summary;
        assert_eq!(hostile, "A &lt;script&gt;harm()&lt;/script&gt; ball.");
        assert_eq!(card("").summary, "");
        assert_eq!(card(&"a".repeat(LENGTH + 1)), Card { language: "en".to_owned(), ..Card::default() });
    }

    #[test]
    fn what_a_card_cannot_show_is_left_out_and_reported_at_its_place() {
        let long = "x".repeat(TOPIC + 1);
        for (line, place, kept) in [
            ("topics: \"a, b,, c\"".to_owned(), "", "a b c"),
            (format!("topics: a, {long}, b"), long.as_str(), "a b"),
            ("topics:  a, b , a".to_owned(), "a", "a b"),
            ("topics: a,b,c,d,e,f,g".to_owned(), "g", "a b c d e f"),
        ] {
            let source = format!("---\n{line}\n---\n");
            let mut found = Vec::new();
            check(&read(&source, &mut Vec::new()), &mut found);
            let [diagnostic] = &found[..] else { panic!("{line}: {found:?}") };
            assert_eq!(&source[diagnostic.span().range()], place, "{line}");
            assert!(diagnostic.span().start > source.find('a').unwrap_or_default(), "{line}");
            assert_eq!(card(&source).topics.join(" "), kept);
        }
        let source = format!("---\nsummary: {}\n---\nA ball.", "x".repeat(SUMMARY + 1));
        let mut found = Vec::new();
        check(&read(&source, &mut Vec::new()), &mut found);
        assert_eq!(found.len(), 1);
        assert_eq!(card(&source).summary, "A ball.");
    }
}
