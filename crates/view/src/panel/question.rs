//! A question with its answer field, grade, hint and right answer.

use super::choice;
use crate::app::App;
use crate::views::*;
use play::{Grade, Limit};
use program::QuestionKind;
use web_sys::SubmitEvent;

/// The question with this index, once the questions that it waits for are answered.
pub fn view(app: App, index: usize) -> View {
    if app.read(|play| play.program().questions.get(index).is_none_or(|asked| asked.after.is_empty())) {
        return open(app, index);
    }
    let awaited = memo(move || {
        // Questions open in the same frame in which hidden values appear.
        app.changes.frame.track();
        app.read(|play| play.answers().awaited(play.basis(), index))
    });
    changing(move || {
        let awaited = awaited.get_clone();
        if awaited.is_empty() { open(app, index) } else { locked(app, index, &awaited) }
    })
}

/// Placeholder of a question that waits for others.
fn locked(app: App, index: usize, awaited: &[usize]) -> View {
    let words = app.words();
    let numbers: Vec<String> = awaited.iter().map(|other| format!("{} {}", words.question, other + 1)).collect();
    let (id, number) = (format!("question-{index}"), index + 1);
    section()
        .class("question locked-question")
        .attr("aria-labelledby", id.clone())
        .child(h4().id(id).child(format!("{} {number}", words.question)))
        .child(note(format!("{}: {}", words.question_awaits, numbers.join(", "))))
        .into()
}

fn open(app: App, index: usize) -> View {
    let words = app.words();
    let language = app.language.get_untracked().tag();
    let asked = app.read(|play| Some(play.program().question_text(language, index).clone())).unwrap_or_default();
    let Some(kind) = app.read(|play| play.program().questions.get(index).map(|asked| asked.kind.clone())) else {
        return View::new();
    };
    let given = app.read(|play| play.answers().answer(play.basis(), index));
    let verdict = create_signal(given.verdict);
    let revealed = create_signal(
        given.shown.map(|_| app.read(|play| play.change_answers(|answers, run| answers.reveal(run, index)))),
    );
    let (field, number) = (format!("answer-{index}"), index + 1);
    let typed = create_signal(given.typed);
    let limit = create_signal(given.limit);
    let is_used_up = move || limit.get().is_some_and(|limit| limit.left() == 0);
    let check = move |event: SubmitEvent| {
        event.prevent_default();
        if is_used_up() {
            return;
        }
        let answer = typed.get_clone_untracked();
        verdict.set(app.act(|play| Some(play.change_answers(|answers, run| answers.check(run, index, &answer)))));
        limit.set(app.read(|play| play.answers().answer(play.basis(), index)).limit);
    };
    let grade = move || {
        verdict.with(|verdict| match verdict.as_ref().map(|verdict| verdict.grade) {
            None => "",
            Some(Grade::Correct) => "right",
            Some(Grade::Unreadable) => "unreadable",
            Some(Grade::Partly(_) | Grade::Close | Grade::WrongSign | Grade::WrongScale) => "near",
            Some(Grade::Wrong | Grade::Unanswerable) => "wrong",
        })
    };
    let reported =
        move || verdict.with(|verdict| verdict.as_ref().map(|verdict| verdict.text.clone()).unwrap_or_default());
    let answer = move || match revealed.get_clone() {
        Some(answer) => span().child(words.right_answer).child(": ").child(strong().child(answer)).into(),
        None => View::new(),
    };
    let hint =
        asked.hint.map(|hint| details().class("hint").child(summary().child(words.hint)).child(div().inner_html(hint)));
    let explanation = asked.explanation.map(|explanation| {
        div()
            .class("explanation")
            .hidden(move || revealed.with(Option::is_none) && grade() != "right")
            .inner_html(explanation)
    });
    let name = format!("{}, {} {number}", words.answer, words.question);
    let change = move |text: String| {
        verdict.set(None);
        app.act(|play| play.change_answers(|answers, _| answers.type_text(index, &text)));
        typed.set(text);
    };
    let input: View = match kind {
        QuestionKind::Number(_) => {
            let input = short_field(field.clone())
                .placeholder(words.answer)
                .attr("aria-describedby", format!("prompt-{index} verdict-{index}"))
                .attr("aria-invalid", move || (grade() == "unreadable").then_some("true"))
                .attr("readonly", move || is_used_up().then_some("true"))
                .prop("value", typed.get_clone_untracked())
                .when(events::input, move |event| change(value_of(&event)));
            let unit = app.read(|play| play.basis().question_unit(index));
            let label = label().r#for(field).class("visually-hidden").child(name);
            View::from((label, with_unit(input, unit)))
        }
        QuestionKind::Choice(asked) => choice::field(app, index, asked, *typed, is_used_up, change),
    };
    let remarks = move || {
        let remarks = verdict.with(|verdict| verdict.as_ref().map(|verdict| verdict.remarks.clone()));
        each(remarks.unwrap_or_default(), |remark| p().inner_html(remark))
    };
    let reveal =
        move |_| revealed.set(Some(app.act(|play| play.change_answers(|answers, run| answers.reveal(run, index)))));
    let form = form()
        .class("answer")
        .when(events::submit, check)
        .child(input)
        .child(
            button()
                .class("primary")
                .r#type("submit")
                .attr("aria-disabled", move || is_used_up().then_some("true"))
                .child(words.check),
        )
        .child(button().class("quiet").when(events::click, reveal).child(words.reveal));
    let verdict = p().class("verdict").role("status").id(format!("verdict-{index}")).attr("data-grade", grade);
    section()
        .class("question")
        .attr("aria-labelledby", format!("question-{index}"))
        .child(h4().id(format!("question-{index}")).child(format!("{} {number}", words.question)))
        .child(div().class("prompt").id(format!("prompt-{index}")).inner_html(asked.prompt))
        .child(setup(app, index))
        .child(form)
        .maybe(given.limit.map(|_| attempts(app, index, limit)))
        .child(verdict.child(text(reported)))
        .child(div().class("remarks").role("status").child(changing(remarks)))
        .child(p().class("revealed").role("status").child(changing(answer)))
        .maybe(explanation)
        .maybe(hint)
        .into()
}

/// Number of attempts that are left at a question with a limit.
fn attempts(app: App, index: usize, limit: Signal<Option<Limit>>) -> HtmlP {
    let words = app.words();
    let left = move || {
        let Some(limit) = limit.get() else { return String::new() };
        let sentence = match limit.left() {
            _ if limit.made == 0 => words.attempts_allowed,
            0 if limit.made > limit.allowed => words.attempts_beyond,
            0 => words.attempts_used,
            _ => words.attempts_left,
        };
        let numbers = [("{allowed}", limit.allowed), ("{left}", limit.left()), ("{made}", limit.made)];
        numbers.iter().fold(sentence.to_owned(), |text, (name, number)| text.replace(name, &number.to_string()))
    };
    p().class("note").role("status").id(format!("attempts-{index}")).child(text(left))
}

/// Values for which the question asks, assigned to the seat or assumed, and a button that sets them.
fn setup(app: App, index: usize) -> View {
    let words = app.words();
    let now = memo(move || {
        app.changes.parameters.track();
        app.read(|play| play.answers().setup(play.basis(), play.course(), index))
    });
    if now.with_untracked(Option::is_none) {
        return View::new();
    }
    let refusal = create_signal(None::<String>);
    let is_set = move || now.with(|setup| setup.as_ref().is_some_and(|(_, set)| *set));
    let supposed = move || supposed(now.get_clone().map_or_else(Vec::new, |(values, _)| values));
    let set_up = button()
        .class("quiet")
        .attr("aria-disabled", move || is_set().to_string())
        .when(events::click, move |_| refusal.set(app.attempt(|play| play.apply_question_setup(index))))
        .child(text(move || if is_set() { format!("✓ {}", words.is_set_up) } else { words.set_up.to_owned() }));
    let why = text(move || refusal.get_clone().unwrap_or_default());
    p().class("setup")
        .child(span().child(words.supposes).child(" ").child(changing(supposed)))
        .child(set_up)
        .child(span().class("refusal").role("alert").child(why))
        .into()
}

/// Assumed parameters, such as `h_l = 4 m, b = 0 kg/s`, with typeset names.
pub fn supposed(values: Vec<(String, String)>) -> View {
    let one = |(place, (name, value)): (usize, (String, String))| {
        let before = if place == 0 { "" } else { ", " };
        let symbol = span().class("symbol").inner_html(units::mathml::typeset_name(&name));
        View::from((before, span().class("unbroken").child(symbol).child(format!(" = {value}"))))
    };
    each(values.into_iter().enumerate(), one)
}
