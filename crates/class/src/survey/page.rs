//! The results of a survey as a page. Its sections are also those of the dashboard in the laboratory.

use super::{Results, Tally, Word};
use figure::{Palette, ScaleRow, scale_bars, word_cloud};
use report::{Page, escaped};
use saved::survey::ItemKind;
use units::{Language, words};

/// Width of the figures and height of a cloud, pixels.
const WIDTH: f64 = 752.0;
const CLOUD_HEIGHT: f64 = 420.0;
/// Maximum number of words in a cloud and in its list.
const WORDS: usize = 120;

/// Look of the figures.
#[derive(Clone, Copy, Debug)]
pub struct SurveyLook<'a> {
    /// Colours.
    pub palette: &'a Palette,
    /// Language of the texts around the answers.
    pub language: Language,
}

/// The surveys as one self-contained HTML page with the comments that they contain. `released`: false if comments are left
/// out; the page then says so. Texts of persons and documents are escaped.
pub fn html(surveys: &[Results], released: bool, language: Language) -> String {
    let look = SurveyLook { palette: &Palette::LIGHT, language };
    let mut page = Page::default();
    page.raw("<header>\n");
    page.element("p class=\"kicker\"", language.say("Answers without names"));
    let title = language.say("Survey");
    page.element("h1", title);
    page.raw("</header>\n");
    for survey in surveys {
        page.element("h2 dir=\"auto\"", &survey.document);
        page.raw(&figures(survey, look));
        for tally in survey.tallies.iter().filter(|tally| tally.item.kind == ItemKind::Text) {
            page.raw(&frequent_words(tally, look));
            if released {
                comments(&mut page, &tally.comments);
            } else {
                let hidden = language.say("The comments are not released.");
                page.element("p class=\"note\"", hidden);
            }
        }
    }
    report::footer(&mut page, language, program::VERSION_AND_BITS, "");
    report::page_of(title, language.tag(), program::VERSION_AND_BITS, &page.out)
}

/// Number of persons, what is not shown, the bars of all scales, and a table for each item with alternatives, as markup.
pub fn figures(survey: &Results, look: SurveyLook<'_>) -> String {
    let mut page = Page::default();
    page.element("p class=\"meta\"", &format!("n = {}", survey.sheets));
    if let Some(sentence) = held_back(survey, look.language) {
        page.element("p class=\"note\"", &sentence);
    }
    let of_kind = |is_scale: bool| {
        let tallies = survey.tallies.iter().filter(|tally| tally.item.kind != ItemKind::Text);
        tallies.filter(move |tally| (tally.item.kind == ItemKind::Scale) == is_scale)
    };
    bars(&mut page, &of_kind(true).collect::<Vec<_>>(), look);
    for tally in of_kind(true).chain(of_kind(false)) {
        asked(&mut page, tally);
        shares(&mut page, tally, look.language);
    }
    page.out
}

/// Sentence about items that are not shown.
pub fn held_back(survey: &Results, language: Language) -> Option<String> {
    let (count, least) = (survey.held_back, super::LEAST);
    let sentence = words!("{count} items have fewer than {least} answers and are not shown.");
    (count > 0).then(|| sentence.text(language).into_owned())
}

/// The question of free texts, a cloud of their frequent words, and the list of frequencies, as markup.
pub fn frequent_words(tally: &Tally, look: SurveyLook<'_>) -> String {
    let language = look.language;
    let mut page = Page::default();
    asked(&mut page, tally);
    let words: Vec<(&str, usize)> =
        tally.words.iter().take(WORDS).map(|Word { text, persons }| (text.as_str(), *persons)).collect();
    if words.is_empty() {
        let none = language.say("No word was used by two persons.");
        page.element("p class=\"note\"", none);
        return page.out;
    }
    page.raw("<figure>\n");
    let name = language.say("Word cloud");
    let described = language.say("The words with their numbers stand in the list below.");
    page.raw(&word_cloud(&words, WIDTH, CLOUD_HEIGHT).svg(name, described, look.palette));
    page.element(
        "figcaption",
        language.say("Words of at least two persons. The area of a word grows with the number of persons."),
    );
    page.raw("</figure>\n");
    page.table("words", &[language.say("Word"), language.say("#Persons")]);
    for (word, persons) in words {
        page.row(&[&isolated(word), &format!("#{persons}")]);
    }
    page.end_table();
    page.out
}

fn asked(page: &mut Page, tally: &Tally) {
    let asked = [escaped(&tally.item.asked), format!(" <small>n = {}</small>", tally.count)].concat();
    page.wrapped("h3 dir=\"auto\"", &asked);
}

/// Bars of all scales.
fn bars(page: &mut Page, tallies: &[&Tally], look: SurveyLook<'_>) {
    let language = look.language;
    let counts: Vec<Vec<usize>> =
        tallies.iter().map(|tally| tally.shares.iter().map(|share| share.count).collect()).collect();
    let mut rows = Vec::new();
    for (tally, counts) in tallies.iter().zip(&counts) {
        rows.push(ScaleRow { asked: &tally.item.asked, low: end(tally, 0), high: end(tally, 1), counts });
    }
    if rows.is_empty() {
        return;
    }
    page.raw("<figure>\n");
    let name = language.say("Answers on scales");
    let described = language.say("The numbers stand in the tables below.");
    page.raw(&scale_bars(&rows, WIDTH, name, described, look.palette));
    page.element(
        "figcaption",
        language.say(
            "One bar for each statement, from the lowest step on the left to the highest on the right. The line divides \
             the lower steps from the upper ones and halves the middle step.",
        ),
    );
    page.raw("</figure>\n");
}

/// Words at the lower (0) or the upper (1) end of a scale.
fn end(tally: &Tally, place: usize) -> &str {
    tally.item.words.get(place).map_or("", String::as_str)
}

/// Table of the shares of an item.
fn shares(page: &mut Page, tally: &Tally, language: Language) {
    let headings = [language.say("Answer"), language.say("#Persons"), language.say("#Share (95 % interval)")];
    page.table("wide", &headings);
    let last = tally.item.answers.saturating_sub(1);
    for (index, (answer, share)) in tally.answers().into_iter().zip(&tally.shares).enumerate() {
        let at_end = match (tally.item.kind, index) {
            (ItemKind::Scale, 0) => end(tally, 0),
            (ItemKind::Scale, _) if index == last => end(tally, 1),
            _ => "",
        };
        let answer = isolated([&answer, " ", at_end].concat().trim_end());
        page.row(&[&answer, &format!("#{}", share.count), &["#", &share.text(language)].concat()]);
    }
    page.end_table();
}

/// Markup of a text of unknown direction.
fn isolated(text: &str) -> String {
    ["<bdi>", &escaped(text), "</bdi>"].concat()
}

fn comments(page: &mut Page, comments: &[String]) {
    page.raw("<ul class=\"comments\">\n");
    for comment in comments {
        page.element("li dir=\"auto\"", comment);
    }
    page.raw("</ul>\n");
}
