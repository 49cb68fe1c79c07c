//! Documents inside a page: an exported page contains its source.

use base64::Engine as _;
use program::Program;
use serde::{Deserialize, Serialize};
use serde_json::ser::Formatter;
use std::io::{self, Write};
use std::ops::Range;

/// A file of a document.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Source {
    /// File name, such as `utube.es.md`.
    pub name: String,
    /// Text of the file.
    pub text: String,
}

/// Properties of a page that depend on its documents.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Content of `<title>`.
    pub title: Option<String>,
    /// Attribute `lang` of `<html>`.
    pub language: Option<String>,
    /// For a page that plays a simulation: its bundle, gzipped.
    pub bundle: Option<Vec<u8>>,
}

/// Content security policy of the page: no requests, and no resources outside the file.
pub const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; \
                          img-src data: blob:; font-src data:; worker-src data:; base-uri 'none'; form-action 'none'";

/// Opening tag of the element with the editor of the laboratory: a deflated script in base64.
pub const EDITOR: &str = "<script type=\"application/octet-stream\" id=\"editor\">";

/// Opening tag of the element with the page template for [`played`], used to publish documents from the laboratory:
/// deflated, in base64. The template lacks the parts of the player, with which the laboratory opens ([`without_parts`]).
pub const PLAYER: &str = "<script type=\"application/octet-stream\" id=\"player\">";

/// Opening tag of the element with the module of the player: gzipped, in base64.
pub const MODULE: &str = "<script type=\"application/octet-stream\" id=\"module\">";

/// Beginning of the opening tag of an element with texts of a language for the player, up to the tag of the language: a packed
/// catalogue, gzipped, in base64.
pub const TEXTS: &str = "<script type=\"application/octet-stream\" id=\"texts-";

/// As [`TEXTS`], for the laboratory.
pub const LABORATORY_TEXTS: &str = "<script type=\"application/octet-stream\" id=\"laboratory-texts-";

/// Opening tag of the element with the module of the laboratory: gzipped, in base64.
pub const LABORATORY: &str = "<script type=\"application/octet-stream\" id=\"laboratory\">";

/// Opening tag of the element with the script of the module of the laboratory: deflated, in base64.
pub const GLUE: &str = "<script type=\"application/octet-stream\" id=\"laboratory-glue\">";

/// Opening tag of the element with the documents of the laboratory ([`write_list`]).
pub const LIBRARY: &str = "<script type=\"application/json\" id=\"library\">";

/// Opening tag of the element with the sample film of the laboratory: an MP4 file in base64.
pub const FILM: &str = "<script type=\"application/octet-stream\" id=\"sample-film\">";

/// Marker for the place of the documents in a page.
pub const MARKER: &str = "<!--documents-->";

const OPENING: &str = "<script type=\"application/json\" id=\"documents\">";
const CLOSING: &str = "</script>";
const BUNDLE: &str = "<script type=\"application/octet-stream\" id=\"bundle\"";

/// Page that plays a simulation: `player` with the bundle of the program (`program::bundle::write`), gzipped, and its
/// sources. `None` if `player` has no place for them.
pub fn played(player: &str, sources: &[Source], program: &Program, gzipped_bundle: Vec<u8>) -> Option<String> {
    let (title, language) = (Some(program.title.clone()), Some(program.language.clone()));
    embed(player, sources, &Options { title, language, bundle: Some(gzipped_bundle) })
}

/// Inserts `documents` into `template` at [`MARKER`], or replaces the documents that it contains. `None` if the template
/// has neither.
pub fn embed(template: &str, documents: &[Source], options: &Options) -> Option<String> {
    let (before, after) = match template.split_once(MARKER) {
        Some(around) => around,
        None => {
            let (start, end) = embedded(template)?;
            (&template[..start - OPENING.len()], &template[end + CLOSING.len()..])
        }
    };
    let mut head = without_bundle(before).to_owned();
    if let Some(title) = &options.title {
        replace_between(&mut head, "<title>", "</title>", &units::markup::escaped(title));
    }
    if let Some(language) = options.language.as_ref().filter(|language| crate::blocks::settings::is_language(language))
    {
        replace_between(&mut head, "<html lang=\"", "\"", language);
    }
    let name = documents.first().map_or("", |document| &document.name);
    let bundle = options.bundle.as_ref().map_or_else(String::new, |bytes| bundle(name, bytes));
    Some(format!("{head}{bundle}{OPENING}{}{CLOSING}{after}", write_list(documents)))
}

/// Inserts the simulation with which a laboratory opens, at the [`MARKER`] of its page: the document's name, and its bundle,
/// gzipped. `None` if the page has no marker.
pub fn opening(laboratory: &str, name: &str, gzipped_bundle: &[u8]) -> Option<String> {
    let (before, after) = laboratory.split_once(MARKER)?;
    Some(format!("{}{}{MARKER}{after}", without_bundle(before), bundle(name, gzipped_bundle)))
}

/// Element with a simulation.
fn bundle(name: &str, gzipped: &[u8]) -> String {
    let encoded = base64::engine::general_purpose::STANDARD.encode(gzipped);
    format!("{BUNDLE} data-name=\"{}\">{encoded}{CLOSING}", units::markup::escaped(name))
}

/// Text without the element of a simulation at its end.
fn without_bundle(text: &str) -> &str {
    match text.rfind(BUNDLE) {
        Some(start) if text.ends_with(CLOSING) => &text[..start],
        _ => text,
    }
}

/// The parts of the player that the laboratory carries, too: the id of each element, and the range of its text.
fn parts(player: &str) -> Vec<(&str, Range<usize>)> {
    let beginnings = [MODULE, TEXTS].into_iter().flat_map(|tag| player.match_indices(tag));
    let mut parts: Vec<(&str, Range<usize>)> = beginnings
        .filter_map(|(at, _)| {
            let start = at + player[at..].find('>')? + 1;
            let (_, id) = player[at..start].split_once("id=\"")?;
            Some((id.split_once('"')?.0, start..start + player[start..].find(CLOSING)?))
        })
        .collect();
    parts.sort_by_key(|(_, range)| range.start);
    parts
}

/// The player without the texts of its parts. `None` if it has no module.
pub fn without_parts(player: &str) -> Option<String> {
    player.contains(MODULE).then(|| filled(player, |_| ""))
}

/// Ids of the parts that [`without_parts`] has left out.
pub fn part_ids(player: &str) -> Vec<String> {
    parts(player).into_iter().map(|(id, _)| id.to_owned()).collect()
}

/// The player with these texts of its parts, which [`without_parts`] has left out.
pub fn with_parts(player: &str, texts: &[(String, String)]) -> String {
    filled(player, |id| texts.iter().find(|(own, _)| own == id).map_or("", |(_, text)| text))
}

fn filled<'a>(player: &str, text: impl Fn(&str) -> &'a str) -> String {
    let (mut page, mut done) = (String::new(), 0);
    for (id, range) in parts(player) {
        page.extend([&player[done..range.start], text(id)]);
        done = range.end;
    }
    page + &player[done..]
}

/// Documents as a JSON list that is safe inside a `script` element: it cannot end the element or begin a comment.
pub fn write_list(documents: &[Source]) -> String {
    let mut bytes = Vec::new();
    // Serializing texts to memory cannot fail.
    let _ = documents.serialize(&mut serde_json::Serializer::with_formatter(&mut bytes, ForScript));
    String::from_utf8(bytes).unwrap_or_default()
}

/// Documents in a page made by [`embed`]. `None` if it contains none.
pub fn read(page: &str) -> Option<Vec<Source>> {
    let (start, end) = embedded(page)?;
    read_list(&page[start..end])
}

/// Documents of a list made by [`write_list`]. `None` if it is invalid or empty.
pub fn read_list(list: &str) -> Option<Vec<Source>> {
    serde_json::from_str(list).ok().filter(|documents: &Vec<Source>| !documents.is_empty())
}

/// Byte range of the embedded JSON. It is in the last such element: an encoded document cannot contain the opening tag, but
/// the text before it may.
fn embedded(page: &str) -> Option<(usize, usize)> {
    let start = page.rfind(OPENING)? + OPENING.len();
    let end = start + page[start..].find(CLOSING)?;
    Some((start, end))
}

fn replace_between(text: &mut String, before: &str, after: &str, new: &str) {
    let Some(start) = text.find(before).map(|at| at + before.len()) else {
        return;
    };
    if let Some(length) = text[start..].find(after) {
        text.replace_range(start..start + length, new);
    }
}

/// JSON formatter that escapes the characters with a meaning in HTML and the line separators of JavaScript as `\uXXXX`.
/// Each document begins on a new line.
struct ForScript;

impl Formatter for ForScript {
    fn begin_array_value<W: ?Sized + Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        if first { Ok(()) } else { out.write_all(b",\n") }
    }

    fn write_string_fragment<W: ?Sized + Write>(&mut self, out: &mut W, fragment: &str) -> io::Result<()> {
        let is_special = |letter| matches!(letter, '<' | '>' | '&' | '\u{7f}' | '\u{2028}' | '\u{2029}');
        let mut rest = fragment;
        while let Some((plain, special)) = rest.find(is_special).map(|at| rest.split_at(at)) {
            out.write_all(plain.as_bytes())?;
            let mut letters = special.chars();
            if let Some(letter) = letters.next() {
                write!(out, "\\u{:04x}", u32::from(letter))?;
            }
            rest = letters.as_str();
        }
        out.write_all(rest.as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEMPLATE: &str = "<!doctype html><html lang=\"en\"><title>M</title><body><!--documents--></body></html>";

    fn source(text: &str) -> Source {
        Source { name: "a \"b\".md".to_owned(), text: text.to_owned() }
    }

    #[test]
    fn what_goes_in_comes_out() {
        let hard = "</script><script>alert(1)</script> <!-- & \u{2028} \u{0} \u{7f} \\ \" \r\n\t é 😀 <!--documents-->";
        let sources = [source(hard), source("")];
        let page = embed(TEMPLATE, &sources, &Options::default()).unwrap();
        assert_eq!(read(&page).unwrap(), sources);
        assert_eq!(page.matches("<script").count(), 1);
        assert_eq!(page.matches("</script").count(), 1);
        assert!(!page.contains("<!--"));
    }

    #[test]
    fn an_exported_page_can_be_given_other_documents() {
        let options = Options { title: Some("A < B".into()), language: Some("es".into()), bundle: None };
        let page = embed(TEMPLATE, &[source("1")], &options).unwrap();
        let again = embed(&page, &[source("2")], &Options::default()).unwrap();
        assert_eq!(read(&again).unwrap(), [source("2")]);
        assert!(again.starts_with("<!doctype html><html lang=\"es\"><title>A &lt; B</title><body><script"));
        assert!(again.ends_with("</script></body></html>"));
    }

    #[test]
    fn a_page_that_plays_holds_bundle_and_source() {
        let program = crate::open("---\ntitle: A & B\nlanguage: es\n---\n```model\nx' = 1 [1/s]\nx(0) = 0\n```\n", &[]);
        let program = program.document.unwrap().program;
        let page = played(TEMPLATE, &[source("1")], &program, vec![0, 1, 254]).unwrap();
        let bundle =
            format!("<title>A &amp; B</title><body>{BUNDLE} data-name=\"a &quot;b&quot;.md\">AAH+{CLOSING}{OPENING}");
        assert!(page.starts_with("<!doctype html><html lang=\"es\">") && page.contains(&bundle), "{page}");
        assert_eq!(read(&page).unwrap(), [source("1")]);
    }

    #[test]
    fn the_simulation_of_a_laboratory_gives_way_to_others() {
        let page = opening(TEMPLATE, "a.md", &[0, 1, 254]).unwrap();
        assert_eq!(page.matches(MARKER).count(), 1);
        assert!(page.contains("id=\"bundle\" data-name=\"a.md\">AAH+</script>"), "{page}");
        let other = opening(&page, "b.md", &[0]).unwrap();
        assert!(other.contains("data-name=\"b.md\"") && !other.contains("a.md"), "{other}");
        let own = embed(&other, &[source("1")], &Options::default()).unwrap();
        assert!(!own.contains("id=\"bundle\""), "{own}");
        let bundle = Some(vec![7]);
        let played = embed(&other, &[source("1")], &Options { bundle, ..Options::default() }).unwrap();
        assert_eq!(played.matches("id=\"bundle\"").count(), 1);
        let again = embed(&played, &[source("2")], &Options::default()).unwrap();
        assert!(!again.contains("id=\"bundle\""), "{again}");
    }

    #[test]
    fn the_module_of_a_player_is_left_out_and_put_back() {
        let player = format!("<body>{MODULE}AAEC{CLOSING}<script>1;</script>{TEXTS}es\">AAED{CLOSING}</body>");
        let template = without_parts(&player).unwrap();
        assert!(!template.contains("AAE"), "{template}");
        let texts = [("texts-es", "AAED"), ("module", "AAEC")].map(|(id, text)| (id.to_owned(), text.to_owned()));
        assert_eq!(part_ids(&template), ["module", "texts-es"]);
        assert_eq!(with_parts(&template, &texts), player);
        assert_eq!(without_parts("<body></body>"), None);
    }

    #[test]
    fn other_pages_hold_no_documents() {
        assert_eq!(embed("<html></html>", &[], &Options::default()), None);
        for page in [
            "",
            "<html></html>",
            OPENING,
            &format!("{OPENING}[{{\"name\":1}}]{CLOSING}"),
            &format!("{OPENING}[]{CLOSING}"),
        ] {
            assert_eq!(read(page), None, "{page}");
        }
    }

    #[test]
    fn the_list_is_json_without_markup() {
        let list = write_list(&[source("</a> & \u{7f}\u{1}\n\r\té\u{2028}"), source("")]);
        let name = r#"{"name":"a \"b\".md","text":"#;
        assert_eq!(list, format!(r#"[{name}"\u003c/a\u003e \u0026 \u007f\u0001\n\r\té\u2028"}},{}{name}""}}]"#, "\n"));
    }

    #[test]
    fn json_of_other_writers_is_read() {
        let page = format!(
            "{OPENING}\n[ {{ \"text\" : \"\\u00e9\\ud83d\\ude00\\/\", \"name\" : \"x\", \"a\": [1] }} ]\n{CLOSING}"
        );
        assert_eq!(read(&page).unwrap(), [Source { name: "x".into(), text: "é😀/".into() }]);
    }
}
