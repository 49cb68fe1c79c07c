//! The survey of the document, and the button that saves the answers.

use crate::app::App;
use crate::browser;
use crate::page::class;
use crate::views::*;
use play::SurveyView;
use program::SurveyKind;

/// Extension of files with answers.
const ENDING: &str = ".survey";

/// True if the document has a survey.
pub fn asks(app: App) -> bool {
    app.read(|play| !play.program().survey.is_empty())
}

/// The survey; nothing if the document has none.
pub fn view(app: App) -> View {
    if !asks(app) {
        return View::new();
    }
    let words = app.words();
    let items = app.read(|play| play.survey().items(play.basis()));
    let saved = create_signal("");
    let save = move |_| {
        let file = app.read(|play| (!play.survey().is_empty()).then(|| play.survey().file(play.basis())));
        saved.set(if file.is_some() { words.survey_saved } else { words.survey_empty });
        if let Some(file) = file {
            // The browser replaces what a file name cannot have.
            let title = app.read(|play| play.program().title.clone());
            browser::save_text(&[&title, ENDING].concat(), "application/json", &file);
            class::give_survey(&file);
        }
    };
    section()
        .class("survey")
        .attr("aria-labelledby", "survey-title")
        .child(h3().id("survey-title").child(words.survey))
        .child(note(words.survey_note))
        .each(items.into_iter().enumerate(), |(index, view)| item(app, index, view))
        .child(button().class("primary").id("save-survey").when(events::click, save).child(words.survey_save))
        .child(p().class("note").role("status").id("survey-said").child(text(move || saved.get().to_owned())))
        .into()
}

fn item(app: App, index: usize, view: SurveyView) -> View {
    let SurveyView { item, text, chosen, typed } = view;
    let id = format!("survey-{index}");
    let radio = |answer: Option<usize>, words: View| {
        let id = format!("survey-{index}-{}", answer.map_or_else(|| "none".to_owned(), |answer| answer.to_string()));
        let input = input()
            .r#type("radio")
            .id(id)
            .name(format!("survey-{index}"))
            .prop("checked", chosen == answer)
            .when(events::change, move |_| {
                app.act(|play| play.change_survey(|survey, basis| survey.choose(basis, index, answer)))
            });
        View::from(label().child(input).child(span().child(words)))
    };
    let none = || radio(None, app.words().survey_none.into());
    let group = || fieldset().class("survey-item").child(legend().child(text.asked.clone()));
    match item.kind {
        SurveyKind::Text => {
            let field =
                textarea().id(id.clone()).attr("maxlength", "2000").attr("rows", "4").prop("value", typed).when(
                    events::input,
                    move |event| {
                        app.act(|play| {
                            play.change_survey(|survey, basis| survey.type_text(basis, index, &value_of(&event)))
                        })
                    },
                );
            div().class("survey-item").child(label().r#for(id).child(text.asked.clone())).child(field).into()
        }
        SurveyKind::Role | SurveyKind::Choice => {
            let answers = text.words.iter().enumerate();
            group()
                .child(
                    div()
                        .class("alternatives")
                        .each(answers, |(answer, word)| radio(Some(answer), word.clone().into()))
                        .child(none()),
                )
                .into()
        }
        SurveyKind::Scale => {
            // The words at the ends are read with the first and the last step.
            let end = |answer: usize| {
                let word = if answer == 0 { text.words.first() } else { text.words.last() };
                word.filter(|_| answer == 0 || answer + 1 == item.answers).cloned()
            };
            let step = |answer: usize| {
                let word = end(answer).map(|word| span().class("visually-hidden").child(format!(" {word}")));
                radio(Some(answer), View::from(((answer + 1).to_string(), word.map_or_else(View::new, View::from))))
            };
            let shown = |word: Option<&String>| {
                span().class("scale-end").attr("aria-hidden", "true").child(word.cloned().unwrap_or_default())
            };
            let steps = div()
                .class("scale-steps")
                .child(shown(text.words.first()))
                .each(0..item.answers, step)
                .child(shown(text.words.last()));
            group().child(steps).child(div().class("alternatives").child(none())).into()
        }
    }
}
