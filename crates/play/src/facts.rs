//! Values that follow from a run and from answers: what a hand-in states, and what is computed again to verify it.

use crate::{Grade, Play, SeatView, StateView};

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
    if let Some(SeatView { assignment, number }) = play.basis().seat() {
        let mut add = |quantity: &str, value| {
            facts.push(Fact { item: title.clone(), quantity: quantity.to_owned(), value });
        };
        add("assignment", FactValue::Text(assignment));
        number.into_iter().for_each(|number| add("seat", FactValue::Number(number.into())));
    }
    let mut add = |item: &str, time: f64, state: &dyn Fn(&StateView) -> f64, parameters: &[f64]| {
        let states = states.iter().map(|own| (format!("value:{}", own.name), state(own)));
        let shown = model.shown_parameters();
        let parameters =
            shown.filter_map(|(index, own)| Some((format!("parameter:{}", own.name), *parameters.get(index)?)));
        let time = (format!("value:{}", model.independent.name), time);
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

/// Value of the fact of a computed grade if the conditions of the attempt are unknown.
pub const UNKNOWN_GRADE: &str = "unknown";

/// Facts of the answers by the number of their question: the text in the field, the number of attempts before the right answer was
/// shown, and each attempt with its conditions, the grade that was given and the grade that follows. An attempt without conditions
/// has besides the grade that follows from the values at the end, which versions up to 0.2.0 stated.
pub fn facts_of_answers(play: &Play) -> Vec<Fact> {
    let mut facts = Vec::new();
    for question in 0..play.program().questions.len() {
        let answer = play.answers().answer(play.basis(), question);
        let mut add = |quantity: String, value: FactValue| {
            facts.push(Fact { item: (question + 1).to_string(), quantity, value });
        };
        let text = |text: &str| FactValue::Text(text.to_owned());
        let end_grade = |typed: &str| play.answers().end_grade(play.basis(), play.course(), question, typed);
        if !answer.typed.is_empty() {
            add("text".to_owned(), text(&answer.typed));
        }
        if let Some(before) = answer.shown {
            add("shown".to_owned(), FactValue::Number(before as f64));
        }
        if let Some(stated) =
            answer.stated.filter(|_| answer.attempts.last().is_none_or(|one| one.conditions.is_none()))
        {
            add("given".to_owned(), text(stated.code()));
            add("end-grade".to_owned(), text(end_grade(&answer.typed).code()));
        }
        for (attempt, number) in answer.attempts.iter().zip(1..) {
            add(format!("attempt:{number}"), text(&attempt.typed));
            if let Some(conditions) = &attempt.conditions {
                add(format!("conditions:{number}"), text(&conditions.text()));
            }
            add(format!("given:{number}"), text(attempt.stated.code()));
            if attempt.conditions.is_none() {
                add(format!("end-grade:{number}"), text(end_grade(&attempt.typed).code()));
            }
            add(format!("grade:{number}"), text(attempt.computed.map_or(UNKNOWN_GRADE, Grade::code)));
        }
    }
    facts
}
