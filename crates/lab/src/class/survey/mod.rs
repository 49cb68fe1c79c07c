//! Answers of the class to a survey: bars, word clouds beside their lists, and comments.

mod comments;
mod room;
mod words;

pub use room::SurveyRoom;

use crate::app::App;
use ::class::survey::page::{self, SurveyLook};
use desk::saved::survey::{ItemKind, LONGEST_SHEET, SHEET_ENDING, Sheet, SheetError};
use view::views::*;
use view::{browser, page::theme};
use web_sys::File;

/// True if a file has answers to a survey, by the ending of its name.
pub fn is_sheet(file: &File) -> bool {
    file.name().to_lowercase().ends_with(SHEET_ENDING)
}

/// Reads files with answers into the dashboard.
pub async fn add(app: App, files: Vec<File>) {
    let mut read = Vec::new();
    for file in files {
        let text = if file.size() > LONGEST_SHEET as f64 {
            Err(SheetError::TooLarge)
        } else {
            let text = browser::wait(file.text()).await.ok().and_then(|text| text.as_string());
            text.ok_or(SheetError::Damaged)
        };
        read.push((file.name(), text.and_then(|text| Sheet::read(&text))));
    }
    app.survey.add(read);
}

/// The section of the dashboard; nothing if no file has been added.
pub fn view(app: App) -> View {
    changing(move || {
        if !app.survey.has_files() {
            return View::new();
        }
        let words = words::of(app);
        let refused = each(app.survey.refused(), |(name, error)| {
            p().class("refusal").child(format!("{name} {}", error.words().text(app.language.get_untracked())))
        });
        let save = move |_| {
            let language = app.language.get_untracked();
            let html = page::html(&app.survey.released(), true, language);
            browser::save_text("survey.html", "text/html", &html);
        };
        let button = |id: &'static str, label: &'static str| button().class("quiet").id(id).child(label);
        let tools = div()
            .class("ways")
            .child(button("survey-page", words.save).when(events::click, save))
            .child(button("survey-clear", words.clear).when(events::click, move |_| app.survey.clear()));
        section()
            .id("class-survey")
            .attr("aria-label", words.title)
            .child(h3().child(words.title))
            .child(note(words.intro))
            .child(refused)
            .child(tools)
            .child(surveys(app))
            .into()
    })
}

/// Results of all documents.
fn surveys(app: App) -> View {
    let look = SurveyLook { palette: theme::palette(), language: app.language.get_untracked() };
    let html = |html: String| div().class("class-report").inner_html(html);
    let surveys = app.survey.results(|all| {
        let survey = |survey: &::class::survey::Results| {
            let texts = survey.tallies.iter().enumerate().filter(|(_, tally)| tally.item.kind == ItemKind::Text);
            let texts: Vec<(usize, String)> =
                texts.map(|(item, tally)| (item, page::frequent_words(tally, look))).collect();
            (survey.document.clone(), page::figures(survey, look), texts)
        };
        all.iter().map(survey).collect::<Vec<_>>()
    });
    each(surveys.into_iter().enumerate(), |(document, (title, figures, texts))| {
        let texts = each(texts, |(item, words)| View::from((html(words), comments::view(app, (document, item)))));
        View::from((h4().dir("auto").child(title), html(figures), texts))
    })
}
