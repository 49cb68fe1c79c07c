//! The report of a tracked film: a page without a fit.

use super::{Film, section};
use crate::markup::{self, Page, escaped};
use crate::page::footer;
use units::Language;

/// Data of the report of a tracked film.
#[derive(Clone, Copy, Debug)]
pub struct TrackReport<'a> {
    /// The film with its pictures.
    pub film: &'a Film,
    /// The language of the report.
    pub language: Language,
    /// Command that repeats the tracking; may be empty.
    pub command: &'a str,
    /// Version of the program.
    pub version: &'a str,
    /// Date of the report as text; may be empty.
    pub date: &'a str,
}

/// The report as one self-contained HTML page.
pub fn film_html(report: &TrackReport<'_>) -> String {
    let (language, film) = (report.language, report.film);
    let mut page = Page::default();
    page.raw("<header>\n");
    page.element("p class=\"kicker\"", language.say("Positions tracked in a film"));
    page.element("h1", &film.name);
    if !report.date.is_empty() {
        page.element("p class=\"meta\"", report.date);
    }
    page.raw("</header>\n");
    page.heading(language.say("The film"));
    section::contents(&mut page, film, language);
    if !report.command.is_empty() {
        page.heading(language.say("To repeat this"));
        page.wrapped("pre tabindex=\"0\"", &escaped(report.command));
    }
    footer(&mut page, language, report.version, report.date);
    markup::document(&film.name, language.tag(), report.version, &page.out)
}
