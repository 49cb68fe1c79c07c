//! The index page of the simulations: one card per simulation, in every language of the interface that the documents
//! have.

use super::collect::Simulation;
use super::curve;
use super::files::Files;
use super::names::LABORATORY;
use super::parts::{Parts, SITE_POLICY, between};
use std::fmt::Write as _;
use units::Language;
use units::alphabet::capitalised;
use units::markup::escaped;
use units::percent_encoded;

const STYLE: &str = include_str!("index.css");
/// Script that shows the list in the language of the reader.
const SCRIPT: &str = include_str!("index.js");

/// Texts of the index page.
struct Words {
    title: &'static str,
    language: &'static str,
    laboratory: &'static str,
    open: &'static str,
    footer: &'static str,
}

fn words_in(language: Language) -> Words {
    Words {
        title: language.say("Simulations"),
        language: language.say("Language"),
        laboratory: language.say("Laboratory"),
        open: language.say("Open in the laboratory"),
        footer: language
            .say("Made with Meniscus. These pages work offline after the first visit and send nothing to anyone."),
    }
}

/// The index page. `player`: source of the styles shared with the pages of the simulations.
pub fn page(simulations: &[Simulation], player: &Parts, files: &mut Files) -> String {
    let languages = languages(simulations);
    let curves: Vec<Option<String>> =
        simulations.iter().map(|simulation| curve::path(&simulation.document.program)).collect();
    let style = files.share("index", "css", STYLE);
    let script = files.share("index", "js", SCRIPT);
    let icon = between(&player.html, "<link rel=\"icon\"", ">").unwrap_or_default();
    let first = languages.first().copied().unwrap_or_default();
    let mut titles = String::new();
    let mut lists = String::new();
    for language in &languages {
        let _ = write!(titles, " data-{}=\"{}\"", language.tag(), words_in(*language).title);
        lists.push_str(&list(*language, &languages, simulations, &curves));
    }
    format!(
        "<!doctype html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{SITE_POLICY}\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<meta name=\"generator\" content=\"Meniscus\">\n\
         <title>{}</title>\n<link rel=\"icon\"{icon}>\n\
         <link rel=\"stylesheet\" href=\"{}\">\n<link rel=\"stylesheet\" href=\"{style}\">\n{}\n\
         <script src=\"{script}\"{titles}></script>\n</head>\n<body>\n{lists}</body>\n</html>\n",
        first.tag(),
        words_in(first).title,
        player.style,
        player.begin(),
    )
}

/// Languages of the interface that the documents have, in order of first appearance.
fn languages(simulations: &[Simulation]) -> Vec<Language> {
    let mut languages = Vec::new();
    for simulation in simulations {
        for tag in simulation.document.program.languages() {
            let language = Language::of(tag);
            if tag.starts_with(language.tag()) && !languages.contains(&language) {
                languages.push(language);
            }
        }
    }
    if languages.is_empty() { vec![Language::English] } else { languages }
}

/// The index in one language.
fn list(language: Language, all: &[Language], simulations: &[Simulation], curves: &[Option<String>]) -> String {
    let words = words_in(language);
    let tag = language.tag();
    let mut html = format!(
        "<div class=\"edition\" lang=\"{tag}\">\n<header class=\"head\">{MARK}<h1>{}</h1>\
         <div class=\"head-tools\"><a class=\"quiet with-icon\" href=\"{LABORATORY}\">{FLASK}<span>{}</span></a>{}</div>\
         </header>\n<main>\n",
        words.title,
        words.laboratory,
        switch(language, all, &words),
    );
    let cards: Vec<(&Simulation, &Option<String>)> = simulations.iter().zip(curves).collect();
    for group in cards.chunk_by(|(one, _), (next, _)| one.folder() == next.folder()) {
        let folder = group.first().map_or("", |(simulation, _)| simulation.folder());
        if !folder.is_empty() {
            let _ = writeln!(html, "<h2>{}</h2>", escaped(&heading(folder)));
        }
        let cards = group.iter().map(|(simulation, curve)| card(language, simulation, curve.as_deref(), &words));
        let _ = write!(html, "<ul class=\"simulations\">\n{}</ul>\n", cards.collect::<String>());
    }
    let _ = write!(html, "</main>\n<footer><p>{}</p></footer>\n</div>\n", words.footer);
    html
}

/// Heading of a folder: `damped-oscillations` becomes *Damped oscillations*.
fn heading(folder: &str) -> String {
    capitalised(&folder.replace(['-', '_'], " ").replace('/', " · "))
}

/// Links to the index in other languages; empty if there is only one.
fn switch(language: Language, all: &[Language], words: &Words) -> String {
    let link = |other: &Language| {
        let (tag, name) = (other.tag(), other.name());
        let current = if *other == language { " aria-current=\"true\"" } else { "" };
        format!(
            "<a href=\"?language={tag}\" lang=\"{tag}\" hreflang=\"{tag}\" title=\"{name}\"{current}>{}</a>",
            tag.to_uppercase()
        )
    };
    match all {
        [] | [_] => String::new(),
        _ => format!(
            "<nav class=\"segments\" aria-label=\"{}\">{}</nav>",
            words.language,
            all.iter().map(link).collect::<String>()
        ),
    }
}

fn card(language: Language, simulation: &Simulation, curve: Option<&str>, words: &Words) -> String {
    let program = &simulation.document.program;
    let edition = program.edition(language.tag());
    // Tells screen readers the language of a document that is not in the language of the list.
    let lang = if edition.language == language.tag() {
        String::new()
    } else {
        format!(" lang=\"{}\"", escaped(&edition.language))
    };
    let page = percent_encoded(simulation.page());
    let heading = if simulation.folder().is_empty() { "h2" } else { "h3" };
    let drawing = curve.map_or_else(String::new, |path| {
        let (width, height) = curve::SIZE;
        format!(
            "<svg class=\"curve\" viewBox=\"0 0 {width} {height}\" preserveAspectRatio=\"none\" aria-hidden=\"true\">\
             <path d=\"{path}\"/></svg>"
        )
    });
    let mut also = String::new();
    let others = Language::ALL.into_iter().filter(|other| *other != language);
    for other in others.filter(|other| program.languages().any(|tag| tag == other.tag())) {
        let (tag, name) = (other.tag(), other.name());
        let _ = write!(also, "<a href=\"{page}?language={tag}\" lang=\"{tag}\" hreflang=\"{tag}\">{name}</a>");
    }
    format!(
        "<li class=\"card\">{drawing}<{heading}{lang}><a href=\"{page}\">{}</a></{heading}><p{lang}>{}</p>\
         <p class=\"ways\">{also}<a class=\"laboratory\" href=\"{}\">{}</a></p></li>\n",
        escaped(&edition.title),
        document::card(simulation.text(&edition.language)).summary,
        escaped(&simulation.in_laboratory()),
        words.open,
    )
}

const MARK: &str = "<p class=\"brand\"><svg class=\"mark\" viewBox=\"0 0 32 32\" width=\"32\" height=\"32\" aria-hidden=\"true\">\
                    <path class=\"mark-liquid\" d=\"M8 12q8 8.5 16 0v9a8 8 0 0 1-16 0z\"/>\
                    <path class=\"mark-glass\" d=\"M8 4v17a8 8 0 0 0 16 0V4\"/></svg><span>Meniscus</span></p>";
const FLASK: &str = "<svg class=\"glyph\" viewBox=\"0 0 24 24\" width=\"20\" height=\"20\" aria-hidden=\"true\">\
                     <path d=\"M9 4h6M10.2 4v5.5L5.6 18a1.6 1.6 0 0 0 1.4 2.4h10a1.6 1.6 0 0 0 1.4-2.4L13.8 9.5V4M8 14.5h8\"/></svg>";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_become_headings() {
        assert_eq!(heading("damped-oscillations/part_2"), "Damped oscillations · part 2");
        assert_eq!(heading("óptica"), "Óptica");
    }
}
