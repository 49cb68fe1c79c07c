//! Tools about the text of documents: `check`, `propose_claims`, `format`, `examples`, `guide`.

use super::answer::{Answer, Refused, data};
use super::workplace::Call;
use crate::check::proposals;
use crate::page;
use crate::terminal::findings::{Finding, findings};
use document::page::{LIBRARY, Source, read_list};
use document::{Searchable, edit, read};
use rmcp::schemars::{self, JsonSchema};
use runner::{JudgedClaim, Loaded, judged};
use serde::Deserialize;
use serde_json::{Value, json};

/// Arguments of `check`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Check {
    /// Path of the document below the folder.
    document: Option<String>,
    /// The document itself, in place of a path.
    text: Option<String>,
    /// Also run it and test its claims.
    #[serde(default)]
    run: bool,
}

/// The findings about a document; with `run` its claims, too.
pub fn check(call: Call, asked: Check) -> Result<Answer, Refused> {
    let loaded = Loaded::open(call.sources(asked.document.as_ref(), asked.text.as_ref())?);
    let mut found: Vec<Value> = findings(&loaded, call.language).map(data).collect();
    let document = loaded.opened.document.as_ref().filter(|_| asked.run && !loaded.opened.has_errors());
    let claims = document.map(|document| judged(document, call.language)).unwrap_or_default();
    if let Some(document) = document {
        let name = || loaded.sources.path().display().to_string();
        let failed = claims.iter().filter_map(JudgedClaim::finding);
        found.extend(failed.map(|failed| data(Finding::new((name(), &document.source), &failed, call.language))));
    }
    let claims: Vec<Value> = claims
        .iter()
        .map(|claim| json!({ "name": claim.name, "holds": claim.held, "result": claim.text.text(call.language) }))
        .collect();
    let mut answer = json!({ "ok": found.is_empty(), "errors": loaded.errors(), "findings": found });
    if document.is_some() {
        answer["claims"] = claims.into();
    }
    Ok(Answer::Data(answer))
}

/// Arguments of `propose_claims`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Propose {
    /// Path of the document below the folder.
    document: Option<String>,
    /// The document itself, in place of a path.
    text: Option<String>,
}

/// Claims that follow from the document, each with its result.
pub fn propose_claims(call: Call, asked: Propose) -> Result<Answer, Refused> {
    let loaded = call.loaded(asked.document.as_ref(), asked.text.as_ref())?;
    let proposed = proposals::propose(&loaded);
    Ok(Answer::Data(data(proposals::of_document(&loaded, &proposed, call.language))))
}

/// Arguments of `format`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Format {
    /// Path of the document below the folder.
    document: Option<String>,
    /// The document itself, in place of a path.
    text: Option<String>,
    /// Path of a file to write; without it the text is returned and nothing is written.
    output: Option<String>,
}

/// The document in the standard layout.
pub fn format(call: Call, asked: Format) -> Result<Answer, Refused> {
    let text = match (&asked.document, &asked.text) {
        (Some(path), None) => runner::text_of(&call, path.as_ref())?,
        (None, Some(text)) => text.clone(),
        _ => return Err(Refused::because("give either `document`, a path, or `text`, the document itself")),
    };
    let formatted = document::format(&read(&text));
    let written = edit::apply(&text, &formatted.edits).map_err(|error| Refused::because(error.words().english()))?;
    let answer = json!({ "changed": written != text, "parts_with_errors": formatted.left.len() });
    Ok(Answer::Data(match asked.output {
        Some(path) => {
            call.write(&path, written.as_bytes())?;
            merged(answer, json!({ "written": path }))
        }
        None => merged(answer, json!({ "text": written })),
    }))
}

/// An object with the fields of another.
pub fn merged(mut object: Value, other: Value) -> Value {
    if let (Some(fields), Value::Object(other)) = (object.as_object_mut(), other) {
        fields.extend(other);
    }
    object
}

/// Arguments of `examples`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Examples {
    /// Words to search for in titles, topics and texts; all documents without it.
    #[serde(default)]
    query: String,
    /// Name of one document, such as "pendulum.md", whose whole text is returned.
    name: Option<String>,
}

/// The documents that the program carries.
pub fn examples(_: Call, asked: Examples) -> Result<Answer, Refused> {
    let sources = gallery()?;
    if let Some(name) = asked.name {
        let found = sources.iter().find(|source| source.name == name);
        return match found {
            Some(source) => Ok(Answer::Text(source.text.clone())),
            None => Err(Refused::because(format!("there is no example `{name}`; search with `query`"))),
        };
    }
    let cards: Vec<Value> = sources
        .iter()
        .filter(|source| document::translates(&source.text).is_none())
        .filter(|source| {
            let own =
                |other: &&Source| document::translates(&other.text).is_some_and(|base| source.name.ends_with(&base));
            let files = std::iter::once(*source).chain(sources.iter().filter(own));
            Searchable::of(files.map(|file| file.text.as_str())).has(&asked.query)
        })
        .map(|source| {
            let card = document::card(&source.text);
            json!({ "name": source.name, "title": card.title, "topics": card.topics })
        })
        .collect();
    Ok(Answer::Data(json!({ "examples": cards })))
}

/// The documents of the laboratory's page, the one it opens with first.
fn gallery() -> Result<Vec<Source>, Refused> {
    let page = page::own().map_err(|_| Refused::because("this program was built without the laboratory's page"))?;
    let list = page.split_once(LIBRARY).and_then(|(_, rest)| read_list(rest.split("</script>").next()?));
    let opening = document::page::read(page).into_iter().flatten();
    Ok(opening.chain(list.into_iter().flatten()).collect())
}

/// Arguments of `guide`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Guide {}

/// The language in short.
pub fn guide(_: Call, _: Guide) -> Result<Answer, Refused> {
    Ok(Answer::Text(crate::guide::GUIDE.to_owned()))
}
