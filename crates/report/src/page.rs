//! The report of one fit as an HTML page.

use crate::markup::{self, Page};
use crate::{FitReport, Report, drawing, export, film, findings, results, theory};
use units::Language;

/// Maximum number of figures.
const FIGURES: usize = 12;

/// The report as one self-contained HTML page in its language.
pub fn html(report: &Report<'_>) -> String {
    let language = report.language;
    let title = report.document.program.edition(language.tag()).title.as_str();
    let fit = FitReport::new(report);
    let mut page = Page::default();
    header(&mut page, report, &fit, title);
    figures(&mut page, report);
    page.heading(language.say("Results"));
    results::estimates(&mut page, report, fit.varied(), !report.intervals.is_empty());
    findings::errors(&mut page, report);
    findings::warnings(&mut page, &fit);
    if fit.derived().next().is_some() {
        page.element("h3", language.say("What follows from them"));
        results::estimates(&mut page, report, fit.derived(), false);
    }
    findings::residuals(&mut page, report, &fit);
    findings::prediction(&mut page, report);
    results::correlations(&mut page, report);
    theory::theory(&mut page, report);
    theory::data(&mut page, report);
    film::films(&mut page, report.films, language);
    theory::repeat(&mut page, report, &export::csv(report, false));
    footer(&mut page, language, report.version, report.date);
    markup::document(title, language.tag(), report.version, &page.out)
}

fn header(page: &mut Page, report: &Report<'_>, fit: &FitReport, title: &str) {
    let language = report.language;
    page.raw("<header>\n");
    page.element("p class=\"kicker\"", language.say("Fit of a theory to measured data"));
    page.element("h1", title);
    let mut names: Vec<String> = report.task.records.iter().map(|record| record.name.clone()).collect();
    if names.len() > 8 {
        names.truncate(8);
        names.push("…".to_owned());
    }
    let mut meta = language.join(&names);
    if !report.date.is_empty() {
        meta.extend([" · ", report.date]);
    }
    page.element("p class=\"meta\"", &meta);
    page.raw("</header>\n");
    let class = if findings::warns(report.outcome) { "p class=\"verdict warn\"" } else { "p class=\"verdict\"" };
    page.element(class, &fit.verdict);
    page.raw("<dl class=\"numbers\">\n");
    findings::numbers(page, fit);
    page.raw("</dl>\n");
}

/// Adds the figures of the observations, at most [`FIGURES`].
fn figures(page: &mut Page, report: &Report<'_>) {
    let language = report.language;
    let observations = &report.outcome.observations;
    for (number, fit) in observations.iter().take(FIGURES).enumerate() {
        page.raw("<figure>\n");
        page.raw(&drawing::panels(report, fit));
        let mut caption = findings::record(report, fit).to_owned();
        if !caption.is_empty() {
            caption.push_str(". ");
        }
        if number == 0 {
            caption.push_str(language.say(
                "Above the measured values and the fitted curve, below what is left over. The band is where the curve itself \
                 may lie (95 %).",
            ));
        }
        let every = drawing::thinned(fit);
        if every > 1 {
            let count = every.to_string();
            caption.extend([language.say(" One value in "), &count, language.say(" is drawn.")]);
        }
        page.element("figcaption", caption.trim());
        page.raw("</figure>\n");
    }
    if observations.len() > FIGURES {
        let text = language.say("Further observations are not drawn: ");
        page.element("p class=\"note\"", &[text, &(observations.len() - FIGURES).to_string(), "."].concat());
    }
}

/// Adds the footer of a page.
pub fn footer(page: &mut Page, language: Language, version: &str, date: &str) {
    let mut text = [language.say("Made with Meniscus "), version].concat();
    if !date.is_empty() {
        text.extend([", ", date]);
    }
    page.element("footer", &text);
}
