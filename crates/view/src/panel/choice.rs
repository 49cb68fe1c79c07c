//! Options of a question, of which one or several are chosen.

use crate::app::App;
use crate::views::*;
use program::{ChoiceAnswer, OptionText};

/// The options with a radio button or a check box each. `typed`: letters of the chosen options. `is_locked`: true if no attempt is left.
/// `change` takes the letters after each choice.
pub fn field(
    app: App,
    index: usize,
    choice: ChoiceAnswer,
    typed: ReadSignal<String>,
    is_locked: impl Fn() -> bool + Copy + 'static,
    change: impl Fn(String) + Copy + 'static,
) -> View {
    let language = app.language.get_untracked().tag();
    let options = app.read(|play| play.program().question_text(language, index).options.clone());
    let kind = if choice.several { "checkbox" } else { "radio" };
    let several = choice.several;
    let chosen = typed.with_untracked(|typed| choice.chosen(typed)).unwrap_or(vec![false; choice.right.len()]);
    let chosen = create_signal(chosen);
    let one = move |(option, (text, is_chosen)): (usize, (OptionText, bool))| {
        let choose = move |event: web_sys::Event| {
            let is_now = is_checked(&event);
            chosen.update(|chosen| {
                for (other, chosen) in chosen.iter_mut().enumerate() {
                    *chosen = if other == option { is_now } else { several && *chosen };
                }
            });
            let chosen = chosen.get_clone_untracked();
            let letters = chosen.iter().enumerate().filter(|(_, chosen)| **chosen).map(|(option, _)| option);
            change(ChoiceAnswer::letters(letters));
        };
        let input = input()
            .r#type(kind)
            .id(format!("answer-{index}-{option}"))
            .name(format!("answer-{index}"))
            .prop("checked", is_chosen)
            .prop("disabled", is_locked)
            .when(events::change, choose);
        let letter = span().class("letter").child(ChoiceAnswer::letter(option).to_string());
        label().child(input).child(letter).child(span().inner_html(text.text))
    };
    let options = options.into_iter().zip(chosen.get_clone_untracked()).enumerate();
    let name = format!("{}, {} {}", app.words().answer, app.words().question, index + 1);
    fieldset()
        .class("alternatives options")
        .attr("aria-describedby", format!("prompt-{index} verdict-{index}"))
        .child(legend().class("visually-hidden").child(name))
        .child(note(if several { app.words().choose_several } else { app.words().choose_one }))
        .each(options, one)
        .into()
}

/// The options of a question on paper; nothing for other kinds.
pub fn printed(options: Vec<OptionText>) -> Option<HtmlUl> {
    let option = |(option, text): (usize, OptionText)| {
        let letter = span().class("letter").child(ChoiceAnswer::letter(option).to_string());
        li().child("☐ ").child(letter).child(" ").child(span().inner_html(text.text))
    };
    (!options.is_empty()).then(|| ul().class("sheet-options").each(options.into_iter().enumerate(), option))
}
