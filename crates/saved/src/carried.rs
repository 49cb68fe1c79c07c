//! Hand-ins carried by reports: a link whose target is the deflated hand-in. The page has no script; the link saves the data.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use handed::fact::{Fact, FactValue, Part};
use std::collections::BTreeMap;
use units::{Language, name_of};

/// Beginning and end of the section that carries the hand-in. Texts of a page are escaped and cannot contain them.
const BEGIN: &str = "<section id=\"hand-in\">";
const END: &str = "</section>";
/// Beginning of the target of the link.
const TARGET: &str = "href=\"data:application/octet-stream;base64,";
/// Element before which the section is inserted.
const BEFORE: &str = "<footer>";

/// Maximum number of sections; the last one has the rest of the page.
const MOST_SECTIONS: usize = 10_000;

/// A page with a hand-in. `packed`: the text of the hand-in, which may be deflated with a zlib header. It states the text of the page
/// ([`crate::hand_in::HandIn::of_page`]).
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
    [&page[..place], BEGIN, &content.concat(), END, "\n", &page[place..]].concat()
}

/// A page that carries a hand-in, taken apart.
pub(crate) struct Carried {
    /// The hand-in, as it was packed.
    pub packed: Vec<u8>,
    /// The page without it.
    rest: String,
}

impl Carried {
    /// Takes a page apart; `None` if it carries no hand-in.
    pub fn of(page: &str) -> Option<Self> {
        // Some programs write all line ends anew.
        let page = page.trim_start_matches('\u{feff}');
        let is_rewritten = page.matches('\n').count() == page.matches("\r\n").count();
        let page = if is_rewritten { page.replace("\r\n", "\n") } else { page.to_owned() };
        let begin = page.rfind(BEGIN)?;
        let end = begin + page.get(begin..)?.find(END)?;
        let start = begin + page.get(begin..end)?.find(TARGET)? + TARGET.len();
        let length = page.get(start..end)?.find('"')?;
        let packed = STANDARD.decode(page.get(start..start + length)?).ok()?;
        Some(Self { packed, rest: [&page[..start], &page[start + length..]].concat() })
    }

    /// Facts about the page, as a hand-in of this version states them.
    pub fn facts(&self, version: u32) -> Vec<Fact> {
        if version > 1 { facts(&self.rest) } else { facts_of_version_1(&self.rest) }
    }
}

/// Facts about a page that carries an empty hand-in, or about one that carries another hand-in without it.
pub(crate) fn facts_without_data(page: &str, language: Language) -> Vec<Fact> {
    facts(&carry(page, b"", language))
}

/// Facts about all of a page: its head, each style sheet in it, each section of its body, and elements that the program does not write.
/// Line ends and blanks at the end do not count.
fn facts(page: &str) -> Vec<Fact> {
    let page = page.trim_end().replace('\r', "");
    let (head, body) = page.split_once("<body>").unwrap_or(("", &page));
    let (styles, head) = styles(head);
    let mut all = vec![fact(String::new(), "head".to_owned(), name_of(&[&head]))];
    all.extend(
        styles.iter().zip(1..).map(|(style, number)| fact(String::new(), format!("style:{number}"), name_of(&[style]))),
    );
    all.extend(foreign(&page));
    all.extend(sections(body));
    all
}

/// Facts about a page as versions up to 0.2.0 stated them: the sections of its body without that of the hand-in. What is not in a page of
/// that version is added, so that it differs: other style sheets, text before the body, and another section of the hand-in.
fn facts_of_version_1(page: &str) -> Vec<Fact> {
    let (before, body) = page.split_once("<body>").unwrap_or(("", page));
    let begin = body.rfind(BEGIN).unwrap_or(body.len());
    let end = body[begin..].find(END).map_or(body.len(), |end| begin + end + END.len() + 1).min(body.len());
    let mut all = sections(&[&body[..begin], body.get(end..).unwrap_or_default()].concat());
    let (styles, head) = styles(before);
    let other = |(text, number): (&String, usize)| {
        let name = name_of(&[text]);
        (!STYLES_OF_0_2.contains(&name.as_str())).then(|| fact(String::new(), format!("style:{number}"), name))
    };
    all.extend(styles.iter().zip(1..).filter_map(other));
    let after_head = head.split_once("</head>").map_or("", |(_, after)| after.trim());
    if !after_head.is_empty() {
        all.push(fact(String::new(), "head".to_owned(), excerpt(after_head)));
    }
    let own = name_of(&[body.get(begin..end).unwrap_or_default()]);
    if !SECTIONS_OF_0_2.contains(&own.as_str()) {
        all.push(fact(String::new(), "own-section".to_owned(), own));
    }
    all.extend(foreign(page));
    all
}

/// Hashes of the style sheets in reports of version 0.2.0.
const STYLES_OF_0_2: [&str; 2] = ["dd390ae06f5c229c", "9cc6bda06c2432b7"];
/// Hashes of the section with the hand-in, without its data, in reports of version 0.2.0: in English, Spanish and Portuguese.
const SECTIONS_OF_0_2: [&str; 3] = ["211d2fc1900d00b7", "84d15818aa8aa294", "9f463c560ee79411"];

fn fact(item: String, quantity: String, text: String) -> Fact {
    Fact { part: Part::Report, item, quantity, value: FactValue::Text(text) }
}

/// Style sheets of a head, and the head without them.
fn styles(head: &str) -> (Vec<String>, String) {
    let (mut styles, mut rest, mut open) = (Vec::new(), String::new(), head);
    while styles.len() < MOST_SECTIONS
        && let Some((before, after)) = open.split_once("<style>")
    {
        let (style, next) = after.split_once("</style>").unwrap_or((after, ""));
        styles.push(style.to_owned());
        rest.extend([before, "<style>"]);
        open = next;
    }
    rest.push_str(open);
    (styles, rest)
}

/// Elements that the program does not write into reports.
const FOREIGN: [&str; 8] =
    ["<script", "<link", "<iframe", "<object", "<embed", "<base", "<form", "<meta http-equiv=\"refresh"];

/// A fact for each element that the program does not write.
fn foreign(page: &str) -> Vec<Fact> {
    let lower = page.to_ascii_lowercase();
    let places = FOREIGN.iter().flat_map(|tag| lower.match_indices(tag)).map(|(place, _)| place);
    let fact_at = |(place, number): (usize, usize)| {
        fact(String::new(), format!("foreign:{number}"), excerpt(page.get(place..).unwrap_or_default()))
    };
    places.take(MOST_SECTIONS).zip(1..).map(fact_at).collect()
}

fn excerpt(text: &str) -> String {
    text.chars().take(100).collect()
}

/// One fact for each section of a body: its heading, and the hash of its text with its markup.
fn sections(body: &str) -> Vec<Fact> {
    let headings = body.match_indices("<h").filter(|(at, _)| is_heading(&body[*at..])).map(|(at, _)| at);
    let starts: Vec<usize> = std::iter::once(0).chain(headings).take(MOST_SECTIONS).collect();
    let ends = starts.iter().skip(1).copied().chain([body.len()]);
    let mut named: BTreeMap<String, usize> = BTreeMap::new();
    let section = |(start, end): (&usize, usize)| {
        let section = &body[*start..end];
        let name = heading(section);
        let count = named.entry(name.clone()).or_default();
        *count += 1;
        let item = if *count == 1 { name } else { format!("{name} ({count})") };
        fact(item, "text".to_owned(), name_of(&[section]))
    };
    starts.iter().zip(ends).map(section).collect()
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

    const PAGE: &str = "<html><head><style>s</style></head><body>\n<p>a</p><h1>Fit</h1><p>0.4</p><h2>Data</h2>1<h2>Data</h2>2<footer>f</footer></body></html>";

    #[test]
    fn a_page_gives_back_what_it_carries() {
        for language in [Language::English, catalogues::with(Language::Spanish)] {
            let page = carry(PAGE, b"{}", language);
            let carried = Carried::of(&page).unwrap();
            assert_eq!((carried.facts(2), carried.packed), (facts_without_data(PAGE, language), b"{}".to_vec()));
            assert!(!page.contains("<script") && page.contains("meniscus verify"));
        }
        assert!(Carried::of(PAGE).is_none());
        assert!(Carried::of(&carry_nothing(PAGE, "<b>", Language::English)).is_none());
        assert!(carry_nothing(PAGE, "<b>", Language::English).contains("&lt;b&gt;"));
    }

    /// Places that differ in the facts of a page.
    fn different(page: &str, other: &str) -> Vec<String> {
        let of = |page: &str| Carried::of(page).unwrap().facts(2);
        let (one, other) = (of(page), of(other));
        let own = other.iter().filter(|fact| !one.contains(fact));
        own.map(|fact| format!("{}/{}", fact.item, fact.quantity)).collect()
    }

    #[test]
    fn all_but_the_data_is_hashed() {
        let page = carry(PAGE, b"{}", Language::English);
        let section = &page[page.find(BEGIN).unwrap()..];
        for (from, to, expected) in [
            ("0.4", "0.5", &["Fit/text"][..]),
            ("2<section", "3<section", &["Data (2)/text"]),
            ("<style>s", "<style>td { display: none } s", &["/style:1"]),
            ("</head>", "<script>x</script></head>", &["/head", "/foreign:1"]),
            ("<body>", "<h1>g = 10.5</h1><body>", &["/head"]),
            ("<section id=\"hand-in\">", "<section id=\"hand-in\"><p>g = 10.5</p>", &["Data (2)/text"]),
            ("Save the data", "Save g = 10.5", &["To verify this/text"]),
            ("</html>", "g = 10.5</html>", &["To verify this/text"]),
        ] {
            assert!(page.contains(from), "{from}");
            assert_eq!(different(&page, &page.replacen(from, to, 1)), expected, "{from}");
        }
        assert_eq!(different(&page, &format!("\u{feff}{}\r\n", page.replace('\n', "\r\n"))), [""; 0]);
        assert!(section.contains("base64,e30=\""), "{section}");
        assert_eq!(different(&page, &page.replace("base64,e30=", "base64,W10=")), [""; 0]);
    }
}
