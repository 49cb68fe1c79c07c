//! A question: an answer to type, what it is worth, a hint, the right answer.

use crate::app::App;
use leptos::html;
use leptos::prelude::*;
use session::{Grade, Verdict};

/// The question of this number.
pub fn view(app: App, index: usize) -> AnyView {
    let words = app.words();
    let language = app.language.get_untracked().tag();
    let text = app.read(|session| Some(session.document().question_text(language, index).clone())).unwrap_or_default();
    let unit = app.read(|session| session.question_unit(index));
    let verdict = RwSignal::new(None::<Verdict>);
    let revealed = RwSignal::new(None::<String>);
    let input = NodeRef::<html::Input>::new();
    let check = move || {
        let Some(input) = input.get_untracked() else { return };
        let answer = input.value();
        verdict.set(app.act(|session| Some(session.check_answer(index, &answer))));
    };
    let grade = move || {
        verdict.with(|verdict| match verdict.as_ref().map(|verdict| verdict.grade) {
            None => "",
            Some(Grade::Correct) => "right",
            Some(Grade::Unreadable) => "unreadable",
            Some(Grade::Close | Grade::WrongSign | Grade::WrongScale) => "near",
            Some(Grade::Wrong | Grade::Unanswerable) => "wrong",
        })
    };
    let hint = text.hint.map(|hint| {
        view! { <details class="hint"><summary>{words.hint}</summary><div inner_html=hint></div></details> }
    });
    let explanation = text.explanation.map(|explanation| {
        view! { <div class="explanation" hidden=move || revealed.with(Option::is_none) && grade() != "right" inner_html=explanation></div> }
    });
    let (field, number) = (format!("answer-{index}"), index + 1);
    view! {
        <section class="question" aria-labelledby=format!("question-{index}")>
            <h4 id=format!("question-{index}")>{format!("{} {number}", words.question)}</h4>
            <div class="prompt" id=format!("prompt-{index}") inner_html=text.prompt></div>
            {setup(app, index)}
            <form class="answer" on:submit=move |event| { event.prevent_default(); check(); }>
                <label for=field.clone() class="visually-hidden">{format!("{}, {} {number}", words.answer, words.question)}</label>
                <span class="quantity">
                    <input node_ref=input type="text" class="number" id=field autocomplete="off" spellcheck="false" placeholder=words.answer
                        aria-describedby=format!("prompt-{index} verdict-{index}")
                        aria-invalid=move || (grade() == "unreadable").then_some("true")
                        on:input=move |_| verdict.set(None) />
                    <span class="unit">{unit}</span>
                </span>
                <button type="submit" class="primary">{words.check}</button>
                <button type="button" class="quiet" on:click=move |_| revealed.set(Some(app.read(|session| session.reveal_answer(index))))>{words.reveal}</button>
            </form>
            <p class="verdict" role="status" id=format!("verdict-{index}") data-grade=grade>
                {move || verdict.with(|verdict| verdict.as_ref().map(|verdict| verdict.text.clone()))}
            </p>
            <p class="revealed" role="status">
                {move || revealed.get().map(|answer| view! { <span>{words.right_answer}": "<strong>{answer}</strong></span> })}
            </p>
            {explanation}
            {hint}
        </section>
    }
    .into_any()
}

/// What the question supposes, and a button that sets it.
fn setup(app: App, index: usize) -> AnyView {
    let words = app.words();
    let now = Memo::new(move |_| {
        app.changes.parameters.track();
        app.read(|session| session.question_setup(index))
    });
    if now.with_untracked(Option::is_none) {
        return ().into_any();
    }
    let refusal = RwSignal::new(None::<String>);
    let is_set = move || now.with(|setup| setup.as_ref().is_some_and(|(_, set)| *set));
    view! {
        <p class="setup">
            <span>{words.supposes}" "{move || supposed(now.get().map_or_else(Vec::new, |(values, _)| values))}</span>
            <button type="button" class="quiet" aria-disabled=move || is_set().to_string()
                on:click=move |_| refusal.set(app.attempt(|session| session.apply_question_setup(index)))>
                {move || if is_set() { format!("✓ {}", words.is_set_up) } else { words.set_up.to_owned() }}
            </button>
            <span class="refusal" role="alert">{move || refusal.get()}</span>
        </p>
    }
    .into_any()
}

/// `h_l = 4 m, b = 0 kg/s`, with the names as in formulas.
fn supposed(values: Vec<(String, String)>) -> Vec<AnyView> {
    let one = |(place, (name, value)): (usize, (String, String))| {
        let before = if place == 0 { "" } else { ", " };
        view! { {before}<span class="symbol" inner_html=model::typeset_name(&name)></span>{format!(" = {value}")} }
            .into_any()
    };
    values.into_iter().enumerate().map(one).collect()
}
