//! `meniscus check --propose`: claims that follow from the text of a document, each run before it is shown.

use runner::{JudgedProposal, Loaded, Proposed, proposed};
use serde::Serialize;
use serde_json::Value;
use std::borrow::Cow;
use units::{Language, say, sentence};

/// Proposals for a document; none if it has errors.
pub fn propose(loaded: &Loaded) -> Proposed {
    let base = loaded.sources.texts().next().map(|(_, text)| text);
    base.filter(|_| !loaded.opened.has_errors()).and_then(proposed).unwrap_or_default()
}

/// Proposals with their lines to paste, remarks on untested answers, and what the author has declined.
pub fn as_text(proposed: &Proposed, language: Language) -> String {
    let mut text: String = proposed.proposals.iter().map(|judged| one_as_text(judged, language)).collect();
    for remark in &proposed.untested {
        text.push_str(&format!("  - {}\n", sentence(&remark.text(language))));
    }
    if proposed.unjudged > 0 {
        let line =
            say!(language, "not tested for lack of work: {}; a longer `step` makes runs shorter", proposed.unjudged);
        text.push_str(&format!("  - {line}\n"));
    }
    for declined in &proposed.declined {
        let line = say!(language, "declined: {}, {}", declined.key, declined.reason);
        text.push_str(&format!("  - {line}\n"));
    }
    text
}

fn one_as_text(judged: &JudgedProposal, language: Language) -> String {
    let (proposal, why) = (&judged.proposal, judged.proposal.why.text(language));
    let mark = if judged.held { '✓' } else { '?' };
    let result = judged.text.text(language);
    let mut text = format!("  {mark} {}: {why}\n", proposal.key());
    if let Some(suspicion) = proposal.suspicion.as_ref().filter(|_| !judged.held) {
        text.push_str(&format!("    {}\n", sentence(&suspicion.text(language))));
    }
    text.push_str(&format!("    {result}\n"));
    text.extend(proposal.lines().lines().map(|line| format!("      {line}\n")));
    text
}

/// Number of proposals, and of those that do not hold, in words.
pub fn counted(proposed: &Proposed, language: Language) -> String {
    match (proposed.proposals.len(), proposed.suspicions()) {
        (0, _) => language.say("no proposals").to_owned(),
        (1, 0) => language.say("1 proposal").to_owned(),
        (all, 0) => say!(language, "{all} proposals"),
        (all, suspicions) => say!(language, "proposals: {all}, suspicions: {suspicions}"),
    }
}

/// JSON form of the proposals for a document. Fields are only ever added.
#[derive(Serialize)]
pub struct Document<'a> {
    file: String,
    unjudged: usize,
    proposals: Vec<Proposal<'a>>,
    untested: Vec<Cow<'a, str>>,
    declined: Vec<Declined<'a>>,
}

#[derive(Serialize)]
struct Proposal<'a> {
    key: String,
    holds: bool,
    lines: String,
    why: Cow<'a, str>,
    result: Cow<'a, str>,
    suspicion: Option<Cow<'a, str>>,
}

#[derive(Serialize)]
struct Declined<'a> {
    key: &'a str,
    reason: &'a str,
}

/// The proposals for a document as JSON.
pub fn of_document<'a>(loaded: &Loaded, proposed: &'a Proposed, language: Language) -> Document<'a> {
    Document {
        file: loaded.sources.path().display().to_string(),
        unjudged: proposed.unjudged,
        proposals: proposed.proposals.iter().map(|judged| one_as_json(judged, language)).collect(),
        untested: proposed.untested.iter().map(|remark| remark.text(language)).collect(),
        declined: (proposed.declined.iter())
            .map(|declined| Declined { key: &declined.key, reason: &declined.reason })
            .collect(),
    }
}

/// One object with the array of all findings and the proposals for each document.
pub fn as_json(findings: &str, documents: &[Loaded], proposed: &[Proposed], language: Language) -> String {
    let documents = documents.iter().zip(proposed);
    let documents = documents.map(|(loaded, proposed)| of_document(loaded, proposed, language));
    let findings: Value = serde_json::from_str(findings).unwrap_or_default();
    let all = serde_json::json!({ "findings": findings, "documents": documents.collect::<Vec<_>>() });
    // Texts and numbers can always be serialised.
    serde_json::to_string_pretty(&all).unwrap_or_default() + "\n"
}

fn one_as_json(judged: &JudgedProposal, language: Language) -> Proposal<'_> {
    let suspicion = judged.proposal.suspicion.as_ref().filter(|_| !judged.held);
    Proposal {
        key: judged.proposal.key(),
        holds: judged.held,
        lines: judged.proposal.lines(),
        why: judged.proposal.why.text(language),
        result: judged.text.text(language),
        suspicion: suspicion.map(|suspicion| suspicion.text(language)),
    }
}
