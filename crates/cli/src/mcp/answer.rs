//! Answers of tools, and refusals, as the protocol has them.

use crate::terminal::findings::Finding;
use rmcp::model::{CallToolResult, ContentBlock};
use runner::{Refusal, Sources, in_keywords};
use serde::Serialize;
use serde_json::{Value, json};
use units::Language;

/// Answer of a tool.
#[derive(Debug)]
pub enum Answer {
    /// Data.
    Data(Value),
    /// A text, as it is.
    Text(String),
    /// PNG files, and data about them.
    Pictures(Vec<Vec<u8>>, Value),
}

/// Reason why a call is not carried out, as data: `error`, perhaps `hint`, `findings`.
#[derive(Debug)]
pub struct Refused(Value);

impl Refused {
    /// A refusal without a remedy.
    pub fn because(message: impl Into<String>) -> Self {
        Self(json!({ "error": message.into() }))
    }

    /// A refusal with findings about a document.
    pub fn with_findings(message: &str, findings: impl Serialize) -> Self {
        Self(json!({ "error": message, "findings": data(findings) }))
    }
}

impl From<Refusal> for Refused {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Request { message, hint } => {
                let mut refused = json!({ "error": english(&message) });
                if let Some(hint) = hint {
                    refused["hint"] = english(&hint).into();
                }
                Self(refused)
            }
            Refusal::Expression { setting, text, found } => {
                let (setting, sources) = (in_keywords(&setting), Sources::of_text(&setting, &text));
                let name = || sources.path().display().to_string();
                let finding = |found| Finding::new((name(), &text), found, Language::English);
                let findings: Vec<Finding> = found.iter().map(finding).collect();
                Self::with_findings(&format!("{setting} has errors"), findings)
            }
        }
    }
}

/// The words in English, with settings named as the arguments of tools.
fn english(words: &units::Words) -> String {
    in_keywords(&words.text(Language::English))
}

/// A value as JSON. Numbers without a value become null.
pub fn data(value: impl Serialize) -> Value {
    serde_json::to_value(value).unwrap_or_default()
}

/// The result of a call: data both as text and as a structure.
pub fn result(answered: Result<Answer, Refused>) -> CallToolResult {
    match answered {
        Ok(Answer::Data(data)) => CallToolResult::structured(data),
        Ok(Answer::Text(text)) => CallToolResult::success(vec![ContentBlock::text(text)]),
        Ok(Answer::Pictures(pictures, data)) => {
            use base64::Engine as _;
            let encoded = |png: &Vec<u8>| base64::engine::general_purpose::STANDARD.encode(png);
            let pictures = pictures.iter().map(|png| ContentBlock::image(encoded(png), "image/png"));
            CallToolResult::success(std::iter::once(ContentBlock::text(data.to_string())).chain(pictures).collect())
        }
        Err(Refused(why)) => CallToolResult::structured_error(why),
    }
}
