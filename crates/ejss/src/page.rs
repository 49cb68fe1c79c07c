//! The document around a model: front matter, description, and the section that says where it comes from.

use crate::imported::Imported;
use crate::listing::{listing, report_view};
use crate::originals::{Original, originals};
use crate::place::{Place, Section};
use crate::prose::{escaped, language_of, markdown, plain_text, wrapped};
use crate::reading::Files;
use crate::report::{EntryKind, Report};
use crate::simulation::Simulation;
use crate::translation::{Blocker, Document, Solved, active_equations, method_of};
use std::fmt::Write as _;
use units::number::shortest;
use units::{Language, say, words};

/// Greatest number of entries of the report that stand in the document.
const MOST_LISTED: usize = 80;
/// Longest title, in characters.
const LONGEST_TITLE: usize = 90;
/// Longest summary, in characters; with its key it stays within the line.
const LONGEST_SUMMARY: usize = 185;
/// Greatest length of the description, in bytes; a document may have 1 MB.
const LONGEST_PROSE: usize = 500 << 10;
/// Greatest length of the listing of a model, in bytes.
const LONGEST_LISTING: usize = 350 << 10;

/// Parts of the document that the model does not determine.
#[derive(Debug)]
pub(crate) struct Page {
    pub title: String,
    language: Language,
    summary: Option<String>,
    prose: String,
    authors: String,
    pub report: Report,
}

impl Page {
    pub fn new(simulation: &Simulation, files: &Files) -> Self {
        let mut report = Report::default();
        let title = plain_text(&simulation.title);
        let title: String = title.chars().take(LONGEST_TITLE).collect();
        let pages: Vec<_> =
            simulation.description.iter().filter(|page| page.locale == "_default_" || page.locale.is_empty()).collect();
        let pages = if pages.is_empty() { simulation.description.iter().take(1).collect() } else { pages };
        let mut blocks = Vec::new();
        let mut plain = String::new();
        for page in &pages {
            let place = Place::new(Section::Description, &page.title);
            if page.is_external {
                report.add(EntryKind::Left, place, words!("The page is a file of its own and is not carried over."));
                continue;
            }
            let (text, lost) = markdown(&page.html, &title, &|path| files.picture(path));
            for _ in 0..lost {
                report.add(
                    EntryKind::Left,
                    place.clone(),
                    words!("The picture is not carried over: it is not in the file, or too large."),
                );
            }
            if page.html.to_ascii_lowercase().contains("<script") {
                report.add(EntryKind::Left, place, words!("The script of the description is not carried over."));
            }
            if pages.len() > 1 && !text.is_empty() {
                let heading = escaped(&plain_text(&page.title));
                blocks.push(format!("## {}", if heading.is_empty() { "…" } else { &heading }));
            }
            plain.push_str(&plain_text(&page.html));
            plain.push(' ');
            blocks.push(text);
        }
        let others = simulation.description.len() - pages.len();
        if others > 0 {
            let place = Place::new(Section::Description, "");
            report.add(EntryKind::Left, place, words!("{others} pages in other languages are not carried over."));
        }
        blocks.retain(|block| !block.trim().is_empty());
        let summary = plain_text(&simulation.summary);
        let is_said = plain.contains(&summary);
        if blocks.is_empty() && !summary.is_empty() {
            let (text, _) = markdown(&simulation.summary, &title, &|_| None);
            blocks.push(text);
        }
        let mut prose = blocks.join("\n\n");
        if prose.len() > LONGEST_PROSE {
            let end = (0..=LONGEST_PROSE).rev().find(|end| prose.is_char_boundary(*end)).unwrap_or(0);
            let end = prose.get(..end).and_then(|text| text.rfind("\n\n")).unwrap_or(0);
            prose.truncate(end);
            let place = Place::new(Section::Description, "");
            report.add(
                EntryKind::Left,
                place,
                words!("The rest of the description is not carried over: it is too long."),
            );
        }
        let cut: String = summary.chars().take(LONGEST_SUMMARY).collect();
        let authors: Vec<String> =
            simulation.authors.iter().map(|author| plain_text(author)).filter(|author| !author.is_empty()).collect();
        Self {
            title: if title.is_empty() { "Simulation".to_owned() } else { title },
            language: language_of(&format!("{} {plain} {summary}", simulation.title)),
            summary: (!is_said && !cut.is_empty() && !plain.trim().is_empty()).then_some(cut),
            prose,
            authors: authors.join(", ").chars().take(200).collect(),
            report,
        }
    }

    /// The document of a translated simulation.
    pub fn translated(
        &self,
        simulation: &Simulation,
        solved: &Solved,
        blocks: &Document,
        has_units: bool,
        mut report: Report,
    ) -> Imported {
        let equations = solved.equations();
        let (method, is_same) = method_of(&equations.method);
        if !is_same {
            let (place, own) =
                (Place::new(Section::Evolution, &equations.name), crate::report::shown(&equations.method));
            report.add(EntryKind::Differs, place, words!("The method {own} is replaced by {method}."));
        }
        let mut settings = String::new();
        let unit = if has_units { " [s]" } else { "" };
        let _ = writeln!(settings, "method: {method}\nstep: {}{unit}", shortest(solved.step));
        if let Some(until) = solved.until {
            let _ = writeln!(settings, "until: {}{unit}", shortest(until));
        }
        if let Some(speed) = solved.speed(simulation) {
            let _ = writeln!(settings, "speed: {}{unit}", shortest(speed));
        }
        let mut text = self.beginning(&settings);
        for (word, lines) in [("model", &blocks.model), ("scene", &blocks.scene), ("plots", &blocks.plots)] {
            if !lines.is_empty() {
                let _ = writeln!(text, "```{word}\n{}\n```\n", lines.join("\n"));
            }
        }
        self.origin(&mut text, &mut report, None);
        let originals = originals(simulation, &blocks.names);
        self.imported(text, report, None, originals)
    }

    /// The document of a simulation that is listed.
    pub fn listed(&self, simulation: &Simulation, blocker: &Blocker) -> Imported {
        let mut report = self.report.clone();
        report_view(simulation, &|_| false, &mut report);
        let language = self.language;
        let mut blocks = listing(simulation, language);
        let mut length = 0;
        let fits = blocks.iter().take_while(|block| {
            length += block.len();
            length <= LONGEST_LISTING
        });
        let count = fits.count();
        if count < blocks.len() {
            blocks.truncate(count);
            report.add(
                EntryKind::Left,
                Place::new(Section::Information, ""),
                words!("The rest of the model is not listed: it is too long."),
            );
        }
        let settings = listed_method(simulation).map(|(method, step)| format!("method: {method}\nstep: {step}\n"));
        let mut text = self.beginning(&settings.unwrap_or_default());
        let todo = say!(language, "The equations go here. Below stands what they are made from.");
        let _ = writeln!(text, "```model\n# {todo}\n```\n");
        for block in blocks {
            let _ = writeln!(text, "{block}\n");
        }
        self.origin(&mut text, &mut report, Some(blocker));
        self.imported(text, report, Some(blocker.words()), Vec::new())
    }

    fn imported(
        &self,
        document: String,
        report: Report,
        listed_because: Option<units::Words>,
        originals: Vec<Original>,
    ) -> Imported {
        Imported { document, title: self.title.clone(), language: self.language, report, listed_because, originals }
    }

    /// Front matter, with the lines of these settings, and description.
    fn beginning(&self, settings: &str) -> String {
        let mut text = format!("---\ntitle: {}\nlanguage: {}\n", self.title, self.language.tag());
        if let Some(summary) = &self.summary {
            let _ = writeln!(text, "summary: {summary}");
        }
        let _ = writeln!(text, "{settings}---\n");
        if !self.prose.is_empty() {
            let _ = writeln!(text, "{}\n", self.prose);
        }
        text
    }

    /// Appends the last section: author, licence, and the entries of the report, each of which gets its line.
    fn origin(&self, text: &mut String, report: &mut Report, blocker: Option<&Blocker>) {
        let language = self.language;
        let _ = writeln!(text, "## {}\n", say!(language, "Imported from"));
        let (title, authors) = (escaped(&self.title), escaped(&self.authors));
        let origin = if authors.is_empty() {
            say!(language, "Imported from *{title}*. The licence of the original applies.")
        } else {
            say!(language, "Imported from *{title}* by {authors}. The licence of the original applies.")
        };
        let _ = writeln!(text, "{}", wrapped(&origin));
        if let Some(blocker) = blocker {
            let why = blocker.words().text(language).into_owned();
            let _ = writeln!(
                text,
                "\n{}",
                wrapped(&listed(&say!(language, "The model is listed and not translated: {why}.")))
            );
        }
        if report.entries().is_empty() {
            return;
        }
        let _ = writeln!(text, "\n{}\n", say!(language, "What is missing, or differs from the original:"));
        for entry in report.entries_mut().iter_mut().take(MOST_LISTED) {
            let sentence = listed(&entry.sentence(language)).replace('\n', "\n  ");
            entry.document_line = Some(text.matches('\n').count() + 1);
            let _ = writeln!(text, "- {sentence}");
        }
        let more = report.entries().len().saturating_sub(MOST_LISTED) + report.more();
        if more > 0 {
            let _ = writeln!(text, "- {}", say!(language, "{more} more are in the report of the import."));
        }
    }
}

/// Method and step of the only active equations, if the step is a number or a variable with one.
fn listed_method(simulation: &Simulation) -> Option<(&'static str, String)> {
    let active = active_equations(simulation);
    let [equations] = active.as_slice() else { return None };
    let tables = simulation.variables.iter().filter(|page| page.is_active);
    let own = tables.flat_map(|page| &page.variables).find(|variable| variable.name == equations.increment);
    let step: f64 = own.map_or(&equations.increment, |variable| &variable.value).trim().parse().ok()?;
    (step > 0.0 && step.is_finite()).then(|| (method_of(&equations.method).0, shortest(step)))
}

/// A sentence of the report as an item of a list: names stand in quotation marks, nothing else is markup.
fn listed(sentence: &str) -> String {
    wrapped(&escaped(&sentence.replace('`', "\"")))
}
