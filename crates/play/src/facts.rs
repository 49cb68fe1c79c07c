//! Values that follow from a run and from answers: what a hand-in states, and what is computed again to verify it.

use crate::{Play, StateView};

/// Value that follows from the state of a simulation.
#[derive(Clone, Debug, PartialEq)]
pub struct Fact {
    /// Title of the document, or the question by its number.
    pub item: String,
    /// Name of the quantity.
    pub quantity: String,
    /// The value.
    pub value: FactValue,
}

/// Value of a [`Fact`].
#[derive(Clone, Debug, PartialEq)]
pub enum FactValue {
    /// A number, in SI units.
    Number(f64),
    /// A text, such as a grade.
    Text(String),
}

/// Facts of the run at the time shown, and of the kept runs at theirs: the independent variable, the states, and the
/// parameters that are shown. `document`: name of the text of the document.
pub fn facts_of_run(play: &Play, document: String) -> Vec<Fact> {
    let (model, states) = (play.model(), play.values().states());
    let title = &play.program().title;
    let document = Fact { item: title.clone(), quantity: "document".to_owned(), value: FactValue::Text(document) };
    let mut facts = vec![document];
    let mut add = |item: &str, time: f64, state: &dyn Fn(&StateView) -> f64, parameters: &[f64]| {
        let states = states.iter().map(|own| (own.name.clone(), state(own)));
        let shown = model.shown_parameters();
        let parameters =
            shown.filter_map(|(index, own)| Some((format!("parameter {}", own.name), *parameters.get(index)?)));
        let time = (model.independent.name.clone(), time);
        facts.extend(std::iter::once(time).chain(states).chain(parameters).map(|(quantity, value)| Fact {
            item: item.to_owned(),
            quantity,
            value: FactValue::Number(value),
        }));
    };
    add(title, play.course().time(), &|own| own.value, play.course().parameters());
    let mut names: Vec<String> = Vec::new();
    for kept in play.time_line().kept_values(play.basis()) {
        let same = names.iter().filter(|name| **name == kept.name).count();
        let number = if same == 0 { String::new() } else { format!(" ({})", same + 1) };
        let state = |own: &StateView| kept.state.get(own.index).copied().unwrap_or(f64::NAN);
        add(&format!("{title}: {}{number}", kept.name), kept.time, &state, &kept.parameters);
        names.push(kept.name.clone());
    }
    facts
}

/// Facts of the answers, which are graded again.
pub fn facts_of_answers(play: &Play) -> Vec<Fact> {
    let mut facts = Vec::new();
    for question in 0..play.program().questions.len() {
        let answer = play.answers().answer(play.basis(), question);
        let mut add = |quantity: &str, text: &str| {
            facts.push(Fact {
                item: format!("question {}", question + 1),
                quantity: quantity.to_owned(),
                value: FactValue::Text(text.to_owned()),
            });
        };
        let grade = |typed: &str| play.answers().verdict(play.basis(), play.course(), question, typed).grade.code();
        if !answer.typed.is_empty() {
            add("text", &answer.typed);
        }
        if answer.revealed {
            add("right answer", "shown");
        }
        if let Some(given) = answer.verdict {
            add("grade given", given.grade.code());
            add("grade", grade(&answer.typed));
        }
        for (attempt, number) in answer.attempts.iter().zip(1..) {
            add(&format!("attempt {number}"), &attempt.typed);
            add(&format!("grade given to attempt {number}"), attempt.grade.code());
            add(&format!("grade of attempt {number}"), grade(&attempt.typed));
        }
    }
    facts
}
