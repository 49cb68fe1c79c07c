//! Course packages: manifests that platforms can read, and pages that are hardly larger.

use class::course::{Kind, package};
use document::page::{POLICY, Source, played};
use flate2::Compression;
use flate2::write::GzEncoder;
use quick_xml::Reader;
use quick_xml::events::Event;
use std::io::Write;

/// Titles of a hostile document in two languages.
const TITLES: [&str; 2] = ["A & \"ñandú\" <swing> ]]> 🎉", "Un 'columpio' & </title> ñ"];

fn template() -> String {
    let policy = format!("<meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">");
    format!(
        "<!doctype html><html lang=\"en\"><head>{policy}<title>M</title></head><body><!--documents--></body></html>"
    )
}

fn sources() -> Vec<Source> {
    let text = |title: &str, more: &str| format!("---\ntitle: {title}\n{more}\n---\n");
    let model = "```model\nx' = 1 [1/s]\nx(0) = 0\n```\n";
    let documents = [
        ("a.md", text(TITLES[0], "assignment: tube") + model),
        ("a.es.md", text(TITLES[1], "language: es\ntranslates: a.md")),
    ];
    documents.map(|(name, text)| Source { name: name.to_owned(), text }).to_vec()
}

fn packaged(kind: Kind) -> (String, Vec<(String, String)>) {
    let sources = sources();
    let opened = document::open(&sources[0].text, &[&sources[1].text]);
    let program = opened.document.expect("a sound document").program;
    let page = played(&template(), &sources, &program, vec![1, 2, 3]).expect("a page");
    let archive = package(kind, &page, &program);
    (page, unzipped(&archive))
}

/// Files of an archive without compression: names and texts.
pub fn unzipped(archive: &[u8]) -> Vec<(String, String)> {
    let number =
        |at: usize, bytes: usize| (0..bytes).rev().fold(0, |all, next| all << 8 | usize::from(archive[at + next]));
    let (mut at, mut files) = (0, Vec::new());
    while archive[at..].starts_with(b"PK\x03\x04") {
        let (size, name) = (number(at + 22, 4), number(at + 26, 2));
        let text =
            |from: usize, length: usize| String::from_utf8(archive[from..from + length].to_vec()).expect("a text");
        files.push((text(at + 30, name), text(at + 30 + name, size)));
        at += 30 + name + size;
    }
    assert!(archive[at..].starts_with(b"PK\x01\x02"), "the directory follows");
    files
}

/// Texts of the elements with this name. Panics if the XML is not well-formed.
fn texts(xml: &str, element: &str) -> Vec<String> {
    let mut reader = Reader::from_str(xml);
    reader.config_mut().check_end_names = true;
    let (mut open, mut found) = (0, Vec::new());
    let mut is_inside = false;
    loop {
        match reader.read_event().expect("well-formed XML") {
            Event::Start(start) => {
                open += 1;
                is_inside = start.local_name().as_ref() == element;
                if is_inside {
                    found.push(String::new());
                }
                assert!(start.attributes().all(|attribute| attribute.is_ok()), "attributes");
            }
            Event::Text(text) if is_inside => {
                found.last_mut().expect("an element").push_str(&text);
            }
            Event::GeneralRef(name) if is_inside => {
                let character = match &*name {
                    "#39" => '\'',
                    "amp" => '&',
                    "lt" => '<',
                    "gt" => '>',
                    "quot" => '"',
                    other => panic!("&{other};"),
                };
                found.last_mut().expect("an element").push(character);
            }
            Event::End(_) => {
                open -= 1;
                is_inside = false;
            }
            Event::Eof => {
                assert_eq!(open, 0, "open elements");
                return found;
            }
            _ => {}
        }
    }
}

#[test]
fn manifests_are_xml_with_the_titles_in_each_language() {
    for (kind, name, localised) in [
        (Kind::Scorm12, "imsmanifest.xml", "langstring"),
        (Kind::Scorm2004, "imsmanifest.xml", "string"),
        (Kind::Cmi5, "cmi5.xml", "langstring"),
    ] {
        let (_, files) = packaged(kind);
        let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, [name, "index.html"]);
        let manifest = &files[0].1;
        let titles = texts(manifest, localised);
        assert!(!titles.is_empty() && titles.chunks(2).all(|titles| titles == TITLES), "{manifest}");
        let plain = texts(manifest, "title");
        assert!(kind == Kind::Cmi5 || plain.iter().any(|title| title == TITLES[0]), "{plain:?}");
    }
}

#[test]
fn the_course_is_the_same_for_another_version_of_the_document() {
    let identifier = |text: &str| {
        let program = document::open(text, &[]).document.expect("a document").program;
        let files = unzipped(&package(Kind::Scorm12, "", &program));
        files[0].1.split('"').nth(5).map(str::to_owned)
    };
    let document = |head: &str, rate: u8| format!("---\n{head}\n---\n```model\nx' = {rate} [1/s]\nx(0) = 0\n```\n");
    let first = identifier(&document("title: A", 1));
    assert!(first.as_ref().is_some_and(|name| name.starts_with("meniscus-")), "{first:?}");
    assert_eq!(identifier(&document("title: A", 2)), first);
    assert_ne!(identifier(&document("title: B", 1)), first);
    assert_eq!(
        identifier(&document("title: A\nassignment: c", 1)),
        identifier(&document("title: B\nassignment: c", 1))
    );
}

#[test]
fn a_page_alone_is_unchanged() {
    let (page, files) = packaged(Kind::Web);
    assert_eq!(files, [("index.html".to_owned(), page)]);
}

#[test]
fn only_a_page_of_cmi5_may_ask_the_addresses_of_its_launch() {
    for kind in Kind::ALL {
        let (_, files) = packaged(kind);
        let page = &files.last().expect("a page").1;
        let is_fixed = page.contains(&format!("content=\"{POLICY}\">"));
        assert_eq!(
            (is_fixed, page.contains("connect-src")),
            (kind != Kind::Cmi5, kind == Kind::Cmi5),
            "{}",
            kind.name()
        );
    }
}

#[test]
fn a_package_is_its_page_and_at_most_3_kb() {
    let gzipped = |bytes: &[u8]| {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(bytes).expect("memory");
        encoder.finish().expect("memory").len()
    };
    for kind in Kind::ALL {
        let (page, files) = packaged(kind);
        let whole: String = files.iter().flat_map(|(name, text)| [name.as_str(), text.as_str()]).collect();
        let more = gzipped(whole.as_bytes()) - gzipped(page.as_bytes());
        println!("{}: {more} B more than the page, gzipped", kind.name());
        assert!(more <= 3000, "{}: {more} B", kind.name());
    }
}
