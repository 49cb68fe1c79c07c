//! `meniscus check`: findings in documents as text or JSON.

mod claims;
pub mod proposals;

use crate::arguments::{Check, Findings};
use crate::failure::Failure;
use crate::load;
use crate::terminal::findings::findings_as_json;
use crate::terminal::output::Output;
use crate::terminal::visible::visible;
use crate::terminal::{Terminal, findings_as_text};
use claims::Claims;
use runner::{Loaded, Proposed};
use std::io::Write;
use std::path::PathBuf;
use units::{Language, say};

/// Checks each document once, with its translations.
pub fn check(arguments: &Check, terminal: Terminal) -> Result<(), Failure> {
    let mut checked: Vec<PathBuf> = Vec::new();
    let mut loaded = Vec::new();
    for path in &arguments.documents {
        let sources = load::sources(path)?;
        let base = sources.path().to_owned();
        if !checked.contains(&base) {
            checked.push(base);
            loaded.push(Loaded::open(sources));
        }
    }
    let language = terminal.language;
    let claims: Vec<Option<Claims>> =
        loaded.iter().map(|document| arguments.run.then(|| Claims::judge(document, language))).collect();
    let proposed: Vec<Proposed> = loaded.iter().filter(|_| arguments.propose).map(proposals::propose).collect();
    if arguments.format == Findings::Json {
        for (document, claims) in loaded.iter_mut().zip(&claims) {
            document.opened.diagnostics.extend(claims.iter().flat_map(Claims::findings).map(|finding| (0, finding)));
        }
    }
    let (mut output, text) = match arguments.format {
        Findings::Json => {
            let findings = findings_as_json(&loaded, language);
            let all = || proposals::as_json(&findings, &loaded, &proposed, language);
            (Output::standard(), if arguments.propose { all() } else { findings.clone() })
        }
        Findings::Text => {
            let findings = findings_as_text(&loaded, language, terminal.standard_output_colors());
            (Output::rendered(), findings + &visible(&summary(&loaded, &claims, &proposed, language)))
        }
    };
    output.write_all(text.as_bytes()).map_err(|error| output.failure(&error))?;
    output.finish()?;
    let refuted = claims.iter().flatten().any(|claims| claims.counts().1 > 0);
    let wrong = refuted || loaded.iter().any(|document| document.opened.has_errors());
    if wrong { Err(Failure::Document) } else { Ok(()) }
}

/// One line per document, followed by its claims and by its proposals.
fn summary(documents: &[Loaded], claims: &[Option<Claims>], proposed: &[Proposed], language: Language) -> String {
    let error = language.say_all(["error", "errors"]);
    let warning = language.say_all(["warning", "warnings"]);
    let mut summary = String::new();
    for (number, (loaded, claims)) in documents.iter().zip(claims).enumerate() {
        let proposed = proposed.get(number);
        let errors = loaded.errors();
        let warnings = loaded.opened.diagnostics.len() - errors;
        let found = match (errors, warnings) {
            (0, 0) => None,
            (0, _) => Some(counted(warnings, warning)),
            (_, 0) => Some(counted(errors, error)),
            (_, _) => Some(format!("{}, {}", counted(errors, error), counted(warnings, warning))),
        };
        let claims = claims.as_ref().filter(|_| errors == 0);
        let refuted = claims.is_some_and(|claims| claims.counts().1 > 0);
        let fine = (found.is_none() && !refuted).then(|| language.say("ok").to_owned());
        let claimed = claims.map(|claims| claimed(claims, language));
        let offered = proposed.filter(|_| errors == 0).map(|proposed| proposals::counted(proposed, language));
        let verdict: Vec<String> = found.into_iter().chain(fine).chain(claimed).chain(offered).collect();
        summary.push_str(&format!("{}: {}\n", loaded.sources.path().display(), verdict.join(", ")));
        summary.extend(claims.iter().map(|claims| claims.lines(language)));
        summary.extend(proposed.map(|proposed| proposals::as_text(proposed, language)));
    }
    summary
}

/// Summary of the claims, such as `4 claims hold`.
fn claimed(claims: &Claims, language: Language) -> String {
    match claims.counts() {
        (0, _) => language.say("no claims").to_owned(),
        (1, 0) => language.say("1 claim holds").to_owned(),
        (all, 0) => say!(language, "{all} claims hold"),
        (all, failed) => say!(language, "{failed} of {all} claims do not hold"),
    }
}

fn counted(count: usize, [one, many]: [&str; 2]) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{count} {many}") }
}
