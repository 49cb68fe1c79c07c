//! The teacher's view of the questions: all of them with their answers, hints and what they hide, and a way to add one.

use super::fields::{named, new_line};
use super::{Panel, findings, panels, typing};
use crate::app::App;
use document::edit::{NewQuestion, add_question};
use document::{Asked, asked, possible_answers};
use program::QuestionText;
use units::markup::escaped;
use view::browser;
use view::views::*;
use web_sys::{HtmlInputElement, HtmlSelectElement, HtmlTextAreaElement, SubmitEvent};

/// The panel.
pub fn view(app: App) -> View {
    let all = memo(move || {
        app.typed.track();
        app.written.track();
        asked(&document::read(&typing::text(app, 0)))
    });
    let shown = memo(move || {
        app.written.track();
        app.changes.parameters.track();
        let language = app.language.get_untracked().tag();
        app.read(|play| {
            let count = play.program().questions.len();
            let one = |number| (play.program().question_text(language, number).clone(), play.computed_answer(number));
            (0..count).map(one).collect::<Vec<_>>()
        })
    });
    let list = move || {
        let (all, shown) = (all.get_clone(), shown.get_clone());
        // Where one has an error, the numbers of the others are not certain.
        let is_whole = all.len() == shown.len();
        if all.is_empty() {
            return View::from(note(app.words().questions_none));
        }
        let card = |(number, one): (usize, Asked)| {
            let shown = shown.get(number).filter(|_| is_whole).cloned();
            card(app, number, one, shown)
        };
        ol().class("asked").each(all.into_iter().enumerate(), card).into()
    };
    View::from((changing(list), form(app)))
}

/// A question with all that its readers see sooner or later: `shown` is how they see it, with the answer that is right at present;
/// none where it has an error.
fn card(app: App, number: usize, one: Asked, shown: Option<(QuestionText, String)>) -> HtmlLi {
    let words = app.words();
    let row = |name: &'static str, value: View| div().child(dt().child(name)).child(dd().child(value));
    let written =
        |name: &'static str, text: &str| (!text.is_empty()).then(|| row(name, code().child(text.to_owned()).into()));
    let (texts, computed) = shown.unzip();
    let texts = texts.unwrap_or_else(|| QuestionText {
        prompt: escaped(&one.prompt),
        hint: Some(escaped(&one.hint)),
        explanation: Some(escaped(&one.explanation)),
    });
    let said = |name: &'static str, html: Option<String>| {
        html.filter(|html| !html.is_empty()).map(|html| row(name, div().inner_html(html).into()))
    };
    let computed = computed.map(|value| p().child(strong().child(value)));
    let answer = View::from((computed.map_or_else(View::new, View::from), code().child(one.answer.clone())));
    let go = move |_| {
        panels::show(app, Panel::Text);
        findings::go_to(app, 0, one.place.start);
    };
    let title = format!("{} {}", words.question, number + 1);
    let id = format!("asked-{number}");
    li().class("asked-one")
        .child(h3().id(id.clone()).child(title))
        .child(div().class("asked-prompt").inner_html(texts.prompt))
        .child(
            dl().child(row(words.question_answer, answer))
                .maybe(written(words.question_follows, &one.after))
                .maybe(written(words.question_supposes, &one.set))
                .maybe(written(words.question_unlocks, &one.hide))
                .maybe(said(words.hint, texts.hint))
                .maybe(said(words.question_explanation_title, texts.explanation)),
        )
        .child(
            button().class("quiet").attr("aria-describedby", id).when(events::click, go).child(words.question_in_text),
        )
}

/// A question is added: its prompt, a quantity that answers it, how exact.
fn form(app: App) -> View {
    let words = app.words();
    let open = create_signal(false);
    let names = memo(move || {
        app.written.track();
        let outline_text = typing::text(app, 0);
        let outline = document::read(&outline_text);
        app.read(|play| possible_answers(&outline, play.program()))
    });
    let refusal = create_signal(None::<String>);
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
        .child(new_line("new-prompt", words.question_prompt_title, prompt.attr("required", "").into()))
        .child(new_line("new-answer", words.question_answer, answer.child(options).into()))
        .child(new_line("new-percent", words.question_tolerance, percent.into()))
        .child(new_line("new-hint", words.hint, hint.into()))
        .child(switch(hides, words.question_hides))
        .child(switch(follows, words.question_follows_previous).hidden(move || is_first.get()))
        .child(note(words.question_answers_note))
        .child(refusal_of(refusal))
        .child(button().r#type("submit").class("primary").child(words.question_add));
    let show = move |_| {
        open.update(|open| *open = !*open);
        if open.get_untracked() {
            browser::focus_later("new-prompt".to_owned());
        }
    };
    let button = labelled(view::icons::plus(), words.question)
        .id("new-question")
        .attr("aria-controls", "new-question-form")
        .attr("aria-expanded", move || open.get().to_string())
        .when(events::click, show);
    View::from((div().class("form-tools").child(button), fields))
}
