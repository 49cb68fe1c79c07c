//! Pages for students and teacher: the pages of Meniscus with a script of their own, compressed once.
//!
//! They are the page of the laboratory or the player with a script of their own, which `cli` hands over. `student.js` asks
//! the page for the parts of its hand-in by one call (`view/src/page/class.rs`), and keeps those that have changed until they
//! are acknowledged; after joining, and when another device has used its numbers, it passes the hand-in of the server to the
//! page, which merges (`Answers::merge`). `teacher.js` passes hand-ins as files to `lab/src/class/live.rs` by events of the
//! window. `bar.js` makes the line of the class in both; its height is `--over` in the page's styles, which keep it free.
//! `stream.js` reads streams and gives up silent ones by the clock, which goes on while a computer sleeps.
//!
//! `outbox.js` keeps the parts that the server does not have yet in the storage of the browser.

use crate::texts;
use axum::body::Bytes;
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use flate2::Compression;
use flate2::write::GzEncoder;
use percent_encoding::{NON_ALPHANUMERIC, utf8_percent_encode};
use serde::Serialize;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::io::Write;
use std::sync::Arc;
use units::Language;
use units::markup::escaped;

/// Script of the students' pages, and its style.
const STUDENT: &str = concat!(
    include_str!("pages/bar.js"),
    include_str!("pages/stream.js"),
    include_str!("pages/outbox.js"),
    include_str!("pages/student.js")
);
/// Script of the teacher's page.
const TEACHER: &str =
    concat!(include_str!("pages/bar.js"), include_str!("pages/stream.js"), include_str!("pages/teacher.js"));
const STYLE: &str = include_str!("pages/style.css");

/// Policy of the list of the documents and of *What is stored*.
const PLAIN_POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; connect-src 'self'; \
                            base-uri 'none'; form-action 'none'";

/// A document for a class.
#[derive(Clone, Debug)]
pub struct Document {
    /// File name.
    pub name: String,
    /// Title.
    pub title: String,
    /// True if parameters depend on the seat.
    pub has_seats: bool,
    /// The page that plays it.
    pub html: String,
    /// The document and its translations: names and texts.
    pub sources: Vec<Source>,
    /// Grades the answers to its questions.
    pub grader: Grader,
}

/// A file of a document.
#[derive(Clone, Debug, Serialize)]
pub struct Source {
    /// File name.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// The answer to a question, graded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Given {
    /// The last answer that was checked, as it was typed.
    pub typed: String,
    /// True if a right answer was given, and before the right answer was shown.
    pub is_right: bool,
}

type Grade = dyn Fn(u32, &str, &str) -> Option<Given> + Send + Sync;

/// Grades answers by a document.
#[derive(Clone)]
pub struct Grader(Arc<Grade>);

impl Grader {
    /// A function of a seat, the name of a question, and the text of a stored item. It gives `None` if there is no such question, if
    /// the item is no answer, or if nothing was checked.
    pub fn new(grade: impl Fn(u32, &str, &str) -> Option<Given> + Send + Sync + 'static) -> Self {
        Self(Arc::new(grade))
    }

    /// The answer to the question of this name in the text of an item, for a seat.
    pub fn answer(&self, seat: u32, question: &str, item: &str) -> Option<Given> {
        (self.0)(seat, question, item)
    }
}

impl std::fmt::Debug for Grader {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str("Grader")
    }
}

/// A page, also compressed.
#[derive(Debug)]
pub struct Page {
    html: Bytes,
    gzipped: Bytes,
    tag: HeaderValue,
}

impl Page {
    fn new(html: String) -> Self {
        let mut gzip = GzEncoder::new(Vec::new(), Compression::new(6));
        // Writing to memory cannot fail.
        let gzipped = gzip.write_all(html.as_bytes()).and_then(|()| gzip.finish()).unwrap_or_default();
        let hash = Sha256::digest(html.as_bytes());
        let tag = hash.iter().take(16).fold(String::from("\""), |tag, byte| format!("{tag}{byte:02x}")) + "\"";
        let tag = HeaderValue::from_str(&tag).unwrap_or(HeaderValue::from_static("\"\""));
        Self { html: html.into(), gzipped: gzipped.into(), tag }
    }

    /// The page, or the answer that the browser has it already.
    pub fn respond(&self, asked: &HeaderMap) -> Response {
        let has = |name: header::HeaderName, word: &str| {
            asked.get_all(name).iter().any(|value| value.to_str().is_ok_and(|value| value.contains(word)))
        };
        let tag = self.tag.to_str().unwrap_or_default();
        let mut response = if has(header::IF_NONE_MATCH, tag) {
            StatusCode::NOT_MODIFIED.into_response()
        } else if has(header::ACCEPT_ENCODING, "gzip") {
            ([(header::CONTENT_ENCODING, "gzip")], self.gzipped.clone()).into_response()
        } else {
            self.html.clone().into_response()
        };
        let headers = response.headers_mut();
        headers.insert(header::ETAG, self.tag.clone());
        headers.insert(header::CONTENT_TYPE, HeaderValue::from_static("text/html; charset=utf-8"));
        headers.insert(header::CACHE_CONTROL, HeaderValue::from_static("no-cache"));
        headers.insert(header::VARY, HeaderValue::from_static("accept-encoding"));
        response
    }
}

/// All pages of a server.
#[derive(Debug)]
pub struct Pages {
    documents: Vec<(Document, Page)>,
    index: Page,
    stored: Page,
    teacher: Page,
    /// Policy of the documents' pages, in which the server is added.
    policy: String,
}

impl Pages {
    /// Pages of these documents. `laboratory`: the page with the dashboard. `policy`: policy that stands in all these pages.
    pub fn new(documents: Vec<Document>, laboratory: &str, policy: &str, language: Language) -> Self {
        let of = |document: Document| {
            let config = config(&document, "", "");
            let page = Page::new(with_script(&document.html, policy, "'self'", &config, STUDENT));
            (document, page)
        };
        let documents: Vec<(Document, Page)> = documents.into_iter().map(of).collect();
        let teacher = with_script(laboratory, policy, "'self'", &json!({ "texts": texts::all() }), TEACHER);
        let index = Page::new(index(&documents, language));
        let stored = Page::new(stored(language));
        Self { documents, index, stored, teacher: Page::new(teacher), policy: policy.to_owned() }
    }

    /// List of the documents.
    pub fn index(&self) -> &Page {
        &self.index
    }

    /// Address of the only document; `None` if there are several.
    pub fn only(&self) -> Option<String> {
        let [(document, _)] = self.documents.as_slice() else { return None };
        Some(format!("/d/{}", escaped_name(document)))
    }

    /// *What is stored*.
    pub fn stored(&self) -> &Page {
        &self.stored
    }

    /// The dashboard.
    pub fn teacher(&self) -> &Page {
        &self.teacher
    }

    /// Page of a document.
    pub fn document(&self, name: &str) -> Option<&Page> {
        self.documents.iter().find(|(document, _)| document.name == name).map(|(_, page)| page)
    }

    /// The documents.
    pub fn documents(&self) -> impl Iterator<Item = &Document> {
        self.documents.iter().map(|(document, _)| document)
    }

    /// Names and titles of the documents.
    pub fn names(&self) -> Vec<Value> {
        let one = |(document, _): &(Document, Page)| json!({ "name": document.name, "title": document.title });
        self.documents.iter().map(one).collect()
    }

    /// Files of the documents, for the dashboard.
    pub fn sources(&self) -> Vec<&[Source]> {
        self.documents().map(|document| document.sources.as_slice()).collect()
    }

    /// Page of a document as a file that opens from disk: it hands in to this address, and to no other.
    pub fn file(&self, name: &str, address: &str, code: &str) -> Option<String> {
        let (document, _) = self.documents.iter().find(|(document, _)| document.name == name)?;
        Some(with_script(&document.html, &self.policy, address, &config(document, address, code), STUDENT))
    }
}

/// Settings for the script of a document's page. `address`: the server, empty for its own pages.
fn config(document: &Document, address: &str, code: &str) -> Value {
    json!({
        "document": document.name, "title": document.title, "seats": document.has_seats, "server": address, "code": code,
        "own": null, "texts": texts::all(),
    })
}

/// The page with a script that may connect to a server.
fn with_script(html: &str, policy: &str, server: &str, config: &Value, script: &str) -> String {
    let html = html.replacen(policy, &format!("{policy}; connect-src {server}"), 1);
    html.replacen("</head>", &format!("{}</head>", scripts(config, script)), 1)
}

fn scripts(config: &Value, script: &str) -> String {
    // Nothing in JSON needs these characters as they are.
    let config = config.to_string().replace('<', "\\u003c");
    format!(
        "<style>{STYLE}</style><script type=\"application/json\" id=\"class-config\">{config}</script>\
         <script>\n{script}</script>\n"
    )
}

/// A small page of its own.
fn plain(title: &str, language: Language, head: &str, body: &str) -> String {
    format!(
        "<!doctype html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n<meta http-equiv=\"Content-Security-Policy\" \
         content=\"{PLAIN_POLICY}\">\n<meta name=\"viewport\" content=\"width=device-width\">\n<title>{title}</title>\n{head}</head>\n\
         <body class=\"class-plain\">\n{body}</body>\n</html>\n",
        language.tag()
    )
}

fn escaped_name(document: &Document) -> String {
    utf8_percent_encode(&document.name, NON_ALPHANUMERIC).to_string()
}

fn index(documents: &[(Document, Page)], language: Language) -> String {
    let link = |document: &Document| {
        let address = escaped_name(document);
        format!("<li><a href=\"d/{address}\">{}</a></li>\n", escaped(&document.title))
    };
    let list: String = documents.iter().map(|(document, _)| link(document)).collect();
    let config = json!({ "document": "", "title": "", "seats": false, "server": "", "code": "", "own": null, "texts": texts::all() });
    let title = language.say("Class");
    let body = format!("<main><h1>{title}</h1>\n<ul>\n{list}</ul></main>\n");
    plain(title, language, &scripts(&config, STUDENT), &body)
}

fn stored(language: Language) -> String {
    let section = |language: Language| {
        let [title, lines @ ..] = texts::stored(language);
        let lines: String = lines.iter().map(|line| format!("<li>{}</li>\n", escaped(line))).collect();
        format!("<section lang=\"{}\"><h1>{title}</h1>\n<ul>\n{lines}</ul></section>\n", language.tag())
    };
    let others = Language::ALL.into_iter().filter(|other| *other != language);
    let all: String = std::iter::once(language).chain(others).map(section).collect();
    let title = language.say("What is stored");
    plain(title, language, &format!("<style>{STYLE}</style>"), &format!("<main>{all}</main>"))
}
