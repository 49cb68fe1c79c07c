//! A question with all texts that its readers can see, each in a field.

use crate::app::App;
use crate::write::fields::Piece;
use crate::write::{Panel, briefs, findings, panels, typing};
use document::edit::{remove_question, set_question};
use document::{Asked, QuestionPart};
use model::Diagnostic;
use program::QuestionText;
use view::browser;
use view::views::*;

/// Parts that have a field in this question, in the usual order: those that it has, and those that it lacks but could have.
pub fn parts(asked: &Asked) -> Vec<QuestionPart> {
    let is_choice = !asked.choose.is_empty() || !asked.options.is_empty();
    let always = |part: &QuestionPart| match part {
        QuestionPart::Prompt | QuestionPart::Hint | QuestionPart::Explanation => true,
        QuestionPart::Answer | QuestionPart::Wrong => !is_choice,
        QuestionPart::Choose | QuestionPart::Options => is_choice,
        QuestionPart::After | QuestionPart::Set | QuestionPart::Hide | QuestionPart::Attempts => false,
    };
    QuestionPart::ALL.into_iter().filter(|part| always(part) || !asked.text(*part).is_empty()).collect()
}

/// Data shared by the cards.
#[derive(Clone, Copy)]
pub struct Questions {
    /// Handle of the laboratory.
    pub app: App,
    /// Questions as written in the text.
    pub all: ReadSignal<Vec<Asked>>,
    /// Questions as shown to readers, with the present right answer; questions with errors are missing.
    pub shown: ReadSignal<Vec<(QuestionText, String)>>,
    /// Diagnostics: (question index, diagnostic).
    pub faults: ReadSignal<Vec<(usize, Diagnostic)>>,
}

impl Questions {
    /// Question as shown to readers. `None` if any question has an error, because the indices may then differ.
    fn shown(self, number: usize) -> Option<(QuestionText, String)> {
        let is_whole = self.all.with(Vec::len) == self.shown.with(Vec::len);
        self.shown.with(|shown| shown.get(number).filter(|_| is_whole).cloned())
    }
}

/// Card of a question.
pub fn view(questions: Questions, number: usize, parts: Vec<QuestionPart>) -> HtmlLi {
    let Questions { app, faults, .. } = questions;
    let words = app.words();
    let refusal = create_signal(None::<String>);
    let title = format!("{} {}", words.question, number + 1);
    let heading = format!("asked-{number}");
    let go = move |_| {
        let place = questions.all.with_untracked(|all| all.get(number).map_or(0, |one| one.place.start));
        panels::show(app, Panel::Text);
        findings::go_to(app, 0, place);
    };
    let prompt = memo(move || questions.shown(number).map(|(texts, _)| texts.prompt));
    let prompt = changing(move || match prompt.get_clone() {
        Some(html) => div().class("asked-prompt").inner_html(html).into(),
        None => View::new(),
    });
    let found = memo(move || {
        faults.with(|faults| {
            let own = faults.iter().filter(|(of, _)| *of == number);
            own.map(|(_, found)| found.clone()).collect::<Vec<_>>()
        })
    });
    let in_text = button().class("quiet").attr("aria-describedby", heading.clone()).when(events::click, go);
    let remove = cross(format!("{} {title}", words.remove_statement)).when(events::click, move |_| remove(app, number));
    li().class("asked-one")
        .child(
            div()
                .class("asked-head")
                .child(h3().id(heading.clone()).tabindex("-1").child(title))
                .child(in_text.child(words.question_in_text))
                .child(remove),
        )
        .child(prompt)
        .each(parts, |part| field(questions, number, part, refusal))
        .child(refusal_of(refusal))
        .child(div().class("faults").child(briefs::view(app, found, move |_| heading.clone())))
}

/// Field of a part with its label; for the answer also its value.
fn field(questions: Questions, number: usize, part: QuestionPart, refusal: Signal<Option<String>>) -> HtmlDiv {
    let Questions { app, all, .. } = questions;
    let name = name(app, part);
    let id = format!("asked-{number}-{part:?}").to_lowercase();
    let piece = Piece {
        id: id.clone(),
        name: format!("{} {}: {name}", app.words().question, number + 1),
        text: memo(move || all.with(|all| all.get(number).map(|one| one.text(part).to_owned()).unwrap_or_default())),
        refusal,
        write: Box::new(move |typed| {
            let text = typing::text(app, 0);
            typing::change(app, 0, &text, |outline| set_question(outline, number, part, typed)).map(|_| ())
        }),
    };
    // Entries stand one a line.
    let is_prose = matches!(
        part,
        QuestionPart::Prompt
            | QuestionPart::Wrong
            | QuestionPart::Options
            | QuestionPart::Hint
            | QuestionPart::Explanation
    );
    let field: View = match is_prose {
        true => piece.prose(app).into(),
        false => piece.line(app).into(),
    };
    let value = memo(move || questions.shown(number).map(|(_, value)| value).unwrap_or_default());
    let value = (part == QuestionPart::Answer).then(|| strong().child(text(move || value.get_clone())));
    let label = label().r#for(id).child(name);
    div().class("new-line").child(label).child(field).maybe(value)
}

fn name(app: App, part: QuestionPart) -> &'static str {
    let words = app.words();
    match part {
        QuestionPart::Prompt => words.question_prompt_title,
        QuestionPart::After => words.question_follows,
        QuestionPart::Set => words.question_supposes,
        QuestionPart::Hide => words.question_unlocks,
        QuestionPart::Answer => words.question_answer,
        QuestionPart::Wrong => words.question_wrong,
        QuestionPart::Choose => words.question_choose,
        QuestionPart::Options => words.question_options,
        QuestionPart::Attempts => words.question_attempts,
        QuestionPart::Hint => words.hint,
        QuestionPart::Explanation => words.question_explanation_title,
    }
}

/// Removes a question, also from the translations.
fn remove(app: App, number: usize) {
    match typing::change_all(app, |outline, translations| remove_question(outline, number, translations)) {
        Ok(()) => browser::focus_later("new-question".to_owned()),
        Err(refusal) => app.complain(refusal),
    }
}
