//! Hand-ins carried by reports: a link whose target is the deflated hand-in. The page has no script; the link saves the data.

use crate::fact::{Fact, FactValue, Part};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use std::collections::BTreeMap;
use units::{Language, name_of};

/// Beginning and end of the section that carries the hand-in. Texts of a page are escaped and cannot contain them.
const BEGIN: &str = "<section id=\"hand-in\">";
const END: &str = "</section>\n";
/// Beginning of the target of the link.
const TARGET: &str = "href=\"data:application/octet-stream;base64,";
/// Element before which the section is inserted.
const BEFORE: &str = "<footer>";

/// Maximum number of sections; the last one has the rest of the page.
const MOST_SECTIONS: usize = 10_000;

/// A page with a hand-in. `packed`: the text of the hand-in, which may be deflated with a zlib header. Its facts include
/// [`sections`] of the page.
pub fn carry(page: &str, packed: &[u8], language: Language) -> String {
    let title = language.say("To verify this");
    let how = language.say(
        "This page carries the data and the stated values. <code>meniscus verify</code> with the name of this file computes \
         every value again from the data and compares it; so does the laboratory of Meniscus when this file is dropped on it. \
         Equal values follow from the data. This does not show who took the data or did the work.",
    );
    let save = language.say("Save the data of this page");
    let data = STANDARD.encode(packed);
    insert(
        page,
        &[
            "<h2>",
            title,
            "</h2>\n<p>",
            how,
            "</p>\n<p><a download=\"report.hand-in\" ",
            TARGET,
            &data,
            "\">",
            save,
            "</a></p>\n",
        ],
    )
}

/// A page that states why it carries no hand-in. `why`: a sentence.
pub fn carry_nothing(page: &str, why: &str, language: Language) -> String {
    let title = language.say("To verify this");
    insert(page, &["<h2>", title, "</h2>\n<p>", &units::markup::escaped(why), "</p>\n"])
}

fn insert(page: &str, content: &[&str]) -> String {
    let place = page.rfind(BEFORE).unwrap_or(page.len());
    [&page[..place], BEGIN, &content.concat(), END, &page[place..]].concat()
}

/// The packed hand-in in a page, and the facts about the rest of the page; `None` if it carries no hand-in.
pub(crate) fn carried(page: &str) -> Option<(Vec<u8>, Vec<Fact>)> {
    let begin = page.rfind(BEGIN)?;
    let inside = page.get(begin..)?;
    let end = inside.find(END)? + END.len();
    let data = inside[..end].split_once(TARGET)?.1.split_once('"')?.0;
    let data = STANDARD.decode(data).ok()?;
    let rest = [&page[..begin], &inside[end..]].concat();
    Some((data, sections(&rest)))
}

/// One fact for each section of a page: its heading, and the hash of its text with its markup. The head of the page, with style
/// sheets and fonts, is left out.
pub fn sections(page: &str) -> Vec<Fact> {
    let body = page.split_once("<body>").map_or(page, |(_, body)| body);
    let headings = body.match_indices("<h").filter(|(at, _)| is_heading(&body[*at..])).map(|(at, _)| at);
    let starts: Vec<usize> = std::iter::once(0).chain(headings).take(MOST_SECTIONS).collect();
    let ends = starts.iter().skip(1).copied().chain([body.len()]);
    let mut named: BTreeMap<String, usize> = BTreeMap::new();
    let fact = |(start, end): (&usize, usize)| {
        let section = &body[*start..end];
        let name = heading(section);
        let count = named.entry(name.clone()).or_default();
        *count += 1;
        let item = if *count == 1 { name } else { format!("{name} ({count})") };
        let value = FactValue::Text(name_of(&[section]));
        Fact { part: Part::Report, item, quantity: "text".to_owned(), value }
    };
    starts.iter().zip(ends).map(fact).collect()
}

/// True if a text begins with the tag of a heading of the levels 1 to 3.
fn is_heading(text: &str) -> bool {
    ["<h1", "<h2", "<h3"].iter().any(|tag| text.starts_with(tag))
}

/// Text of the heading with which a section begins; empty before the first heading.
fn heading(section: &str) -> String {
    if !is_heading(section) {
        return String::new();
    }
    let content = section.split_once('>').map_or("", |(_, rest)| rest);
    content.split_once("</h").map_or("", |(text, _)| text).chars().take(200).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "<html><head></head><body>\n<p>a</p><h1>Fit</h1><p>0.4</p><h2>Data</h2>1<h2>Data</h2>2<footer>f</footer></body></html>";

    #[test]
    fn a_page_gives_back_what_it_carries() {
        for language in [Language::English, catalogues::with(Language::Spanish)] {
            let page = carry(PAGE, b"{}", language);
            assert_eq!(carried(&page), Some((b"{}".to_vec(), sections(PAGE))));
            assert!(!page.contains("<script") && page.contains("meniscus verify"));
        }
        assert_eq!(carried(PAGE), None);
        assert_eq!(carried(&carry_nothing(PAGE, "<b>", Language::English)), None);
        assert!(carry_nothing(PAGE, "<b>", Language::English).contains("&lt;b&gt;"));
    }

    #[test]
    fn each_section_has_a_name_and_a_hash() {
        let names: Vec<String> = sections(PAGE).into_iter().map(|fact| fact.item).collect();
        assert_eq!(names, ["", "Fit", "Data", "Data (2)"]);
        let changed = sections(&PAGE.replace("0.4", "0.5"));
        let different: Vec<usize> = sections(PAGE)
            .iter()
            .zip(&changed)
            .enumerate()
            .filter(|(_, (one, other))| one != other)
            .map(|(at, _)| at)
            .collect();
        assert_eq!(different, [1]);
        // A style sheet or font in the head changes nothing.
        assert_eq!(sections(PAGE), sections(&PAGE.replace("</head>", "<style></style></head>")));
    }
}
