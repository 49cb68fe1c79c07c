//! Form for a new question whose answer is computed by the model.

use crate::app::App;
use crate::write::fields::{named, new_line, opener};
use crate::write::typing;
use document::edit::{NewQuestion, add_question};
use document::{asked, possible_answers};
use view::browser;
use view::views::*;
use web_sys::{HtmlInputElement, HtmlSelectElement, HtmlTextAreaElement, SubmitEvent};

/// The form: prompt, quantity of the answer, tolerance.
pub fn view(app: App) -> View {
    let words = app.words();
    let open = create_signal(false);
    let names = memo(move || {
        app.written.track();
        let outline_text = typing::text(app, 0);
        let outline = document::read(&outline_text);
        app.read(|play| possible_answers(&outline, play.program()))
    });
    let refusal = create_signal(None::<String>);
    let lacks_prompt = create_signal(None::<String>);
    let mut prompt = textarea().class("cell prose-cell").id("new-prompt").attr("rows", "2");
    let mut answer = select().class("cell").id("new-answer");
    let mut percent = input().r#type("text").class("cell").id("new-percent").attr("inputmode", "decimal").value("3");
    let mut hint = input().r#type("text").class("cell").id("new-hint").autocomplete("off");
    let mut hides = input().r#type("checkbox").id("new-hides").prop("checked", true);
    let mut follows = input().r#type("checkbox").id("new-follows");
    let nodes: (HtmlTextAreaElement, HtmlSelectElement, [HtmlInputElement; 4]) =
        (prompt.node(), answer.node(), [percent.node(), hint.node(), hides.node(), follows.node()]);
    let is_first = memo(move || {
        app.typed.track();
        app.written.track();
        asked(&document::read(&typing::text(app, 0))).is_empty()
    });
    let add = move |event: SubmitEvent| {
        event.prevent_default();
        let is_empty = nodes.0.value().trim().is_empty();
        lacks_prompt.set(is_empty.then(|| words.question_needs_prompt.to_owned()));
        if is_empty {
            return browser::focus("new-prompt");
        }
        let (prompt, answer, [percent, hint, hides, follows]) = &nodes;
        let question = NewQuestion {
            prompt: prompt.value(),
            answer: answer.value(),
            percent: percent.value(),
            hint: hint.value(),
            hides: hides.checked(),
            follows: follows.checked() && !is_first.get_untracked(),
        };
        let text = typing::text(app, 0);
        let added = typing::act(app, 0, &text, |outline| add_question(outline, &question).map(|edit| vec![edit]));
        if added.is_ok() {
            prompt.set_value("");
            hint.set_value("");
            open.set(false);
            browser::focus("new-question");
        }
        refusal.set(added.err());
    };
    let option = |(name, label): (String, Option<String>)| {
        let title = named(&name, label);
        option().value(name).child(title)
    };
    let options = changing(move || each(names.get_clone(), option));
    let fields = tags::form()
        .class("new-question card")
        .id("new-question-form")
        .hidden(move || !open.get())
        .when(events::submit, add)
        .child(new_line(
            "new-prompt",
            words.question_prompt_title,
            prompt.attr("aria-invalid", move || lacks_prompt.get_clone().map(|_| "true")).into(),
        ))
        .child(refusal_of(lacks_prompt).hidden(move || lacks_prompt.get_clone().is_none()))
        .child(new_line("new-answer", words.question_answer, answer.child(options).into()))
        .child(new_line("new-percent", words.question_tolerance, percent.into()))
        .child(new_line("new-hint", words.hint, hint.into()))
        .child(switch(hides, words.question_hides))
        .child(switch(follows, words.question_follows_previous).hidden(move || is_first.get()))
        .child(note(words.question_answers_note))
        .child(refusal_of(refusal))
        .child(button().r#type("submit").class("primary").child(words.add_new));
    let button =
        opener(words.question_add, open, "new-prompt").id("new-question").attr("aria-controls", "new-question-form");
    View::from((div().class("form-tools").child(button), fields))
}
