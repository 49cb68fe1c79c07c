//! `meniscus class survey`: the answers of a class to a survey.

use super::arguments::{Survey, SurveyFormat};
use crate::failure::Failure;
use crate::handing::read::{bytes, files_in};
use crate::terminal::Terminal;
use crate::terminal::output;
use crate::terminal::visible::visible;
use analysis::csv::{self, Dialect};
use analysis::spreadsheet::Cell;
use class::share::Share;
use class::survey::{Results, Tally, Word, page, results};
use saved::survey::{ItemKind, LONGEST_SHEET, SHEET_ENDING, Sheet};
use serde_json::{Value, json};
use std::path::PathBuf;
use units::{Language, words};

/// Number of words that the text shows.
const WORDS: usize = 20;

/// Writes the results.
///
/// # Errors
/// A file cannot be read, or none has answers.
pub fn survey(arguments: &Survey, terminal: Terminal) -> Result<(), Failure> {
    let language = terminal.language;
    let files = files(&arguments.paths)?;
    let mut sheets = Vec::new();
    for path in &files {
        match Sheet::read(&String::from_utf8_lossy(&bytes(path, LONGEST_SHEET)?)) {
            Ok(sheet) => sheets.push(sheet),
            Err(error) => terminal.print(&format!("{} {}\n", path.display(), error.words().text(language))),
        }
    }
    if sheets.is_empty() {
        return Err(Failure::in_words(
            words("no file has answers to a survey"),
            words("*Save answers* makes them, below the questions of a document with a survey"),
        ));
    }
    let mut surveys = results(&sheets);
    let released = arguments.comments;
    if !released {
        surveys.iter_mut().flat_map(|survey| &mut survey.tallies).for_each(|tally| tally.comments.clear());
    }
    let written = match SurveyFormat::chosen(arguments.format, arguments.output.as_deref()) {
        SurveyFormat::Text => visible(&as_text(&surveys, released, language)).into_owned(),
        SurveyFormat::Html => page::html(&surveys, released, language),
        SurveyFormat::Csv => as_csv(&surveys),
        SurveyFormat::Json => as_json(&surveys, released),
    };
    output::deliver(arguments.output.as_deref(), &files, written.as_bytes())
}

/// The files among `paths`, and the files with answers in folders among them, in the order of their names.
///
/// # Errors
/// A folder cannot be read or has no such files.
fn files(paths: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let mut files = Vec::new();
    for path in paths {
        if !path.is_dir() {
            files.push(path.clone());
            continue;
        }
        let mut inside = files_in(path, |name| name.to_lowercase().ends_with(SHEET_ENDING))?;
        if inside.is_empty() {
            return Err(Failure::with_hint(
                format!("{} has no answers to a survey", path.display()),
                format!("their names end in {SHEET_ENDING}"),
            ));
        }
        files.append(&mut inside);
    }
    Ok(files)
}

fn kind_name(kind: ItemKind) -> &'static str {
    match kind {
        ItemKind::Role => "role",
        ItemKind::Scale => "scale",
        ItemKind::Choice => "choice",
        ItemKind::Text => "text",
    }
}

fn as_text(surveys: &[Results], released: bool, language: Language) -> String {
    let mut text = String::new();
    for survey in surveys {
        text += &format!("{}, n = {}\n", survey.document, survey.sheets);
        for tally in &survey.tallies {
            text += &format!("\n  {}, n = {}\n", tally.item.asked, tally.count);
            let names = tally.answers();
            let width = names.iter().map(|name| name.chars().count()).max().unwrap_or(0);
            for (name, share) in names.iter().zip(&tally.shares) {
                text += &format!("    {name:width$}  {:>4}  {}\n", share.count, share.text(language));
            }
            if let (ItemKind::Scale, [low, high]) = (tally.item.kind, tally.item.words.as_slice()) {
                text += &format!("    1: {low}; {}: {high}\n", tally.item.answers);
            }
            if tally.item.kind == ItemKind::Text {
                let most = tally.words.iter().take(WORDS).map(|word| format!("{} {}", word.text, word.persons));
                text += &format!("    {}\n", most.collect::<Vec<_>>().join(", "));
                text += &comments_text(tally, released, language);
            }
        }
        if let Some(sentence) = page::held_back(survey, language) {
            text += &format!("\n  {sentence}\n");
        }
        text.push('\n');
    }
    text
}

fn comments_text(tally: &Tally, released: bool, language: Language) -> String {
    if !released {
        let told = language.say("The comments are not shown; --comments releases them.");
        return format!("    {told}\n");
    }
    tally.comments.iter().map(|comment| format!("    - {}\n", comment.replace('\n', "\n      "))).collect()
}

fn as_csv(surveys: &[Results]) -> String {
    let headings = ["document", "item", "kind", "answer", "persons", "n", "share", "low", "high"];
    let mut rows: Vec<Vec<Cell>> = vec![headings.map(Cell::from).to_vec()];
    for survey in surveys {
        for tally in &survey.tallies {
            let row = |kind: &str, answer: &str, numbers: [Option<f64>; 5]| {
                let texts = [&survey.document, tally.item.asked.as_str(), kind, answer].map(Cell::from);
                texts.into_iter().chain(numbers.map(|number| number.map_or(Cell::Empty, Cell::Number))).collect()
            };
            let n = Some(tally.count as f64);
            for (name, share) in tally.answers().iter().zip(&tally.shares) {
                let (low, high) = share.interval();
                let numbers = [Some(share.count as f64), n, Some(share.value()), Some(low), Some(high)];
                rows.push(row(kind_name(tally.item.kind), name, numbers));
            }
            for word in &tally.words {
                rows.push(row("word", &word.text, [Some(word.persons as f64), n, None, None, None]));
            }
            for comment in &tally.comments {
                rows.push(row("comment", comment, [None, n, None, None, None]));
            }
        }
    }
    csv::write_rows(&rows, Dialect::Commas)
}

fn as_json(surveys: &[Results], released: bool) -> String {
    let item = |tally: &Tally| {
        let share = |(name, share): (String, &Share)| json!({ "answer": name, "persons": share.count, "share": share.value(), "interval": share.interval() });
        let mut object = json!({
            "name": tally.item.name,
            "kind": kind_name(tally.item.kind),
            "asked": tally.item.asked,
            "n": tally.count,
        });
        if tally.item.kind == ItemKind::Text {
            let word = |word: &Word| json!({ "word": word.text, "persons": word.persons });
            object["words"] = tally.words.iter().map(word).collect::<Value>();
            if released {
                object["comments"] = json!(tally.comments);
            }
        } else {
            object["answers"] = tally.answers().into_iter().zip(&tally.shares).map(share).collect::<Value>();
        }
        object
    };
    let survey = |survey: &Results| {
        json!({
            "document": survey.document,
            "n": survey.sheets,
            "held_back": survey.held_back,
            "items": survey.tallies.iter().map(item).collect::<Value>(),
        })
    };
    format!("{:#}\n", surveys.iter().map(survey).collect::<Value>())
}
