//! Values that follow from a run and from answers: what a hand-in states, and what is computed again to verify it.

use crate::{Grade, Limit, Play, SeatView, StateView};
use handed::Number;
use handed::fact::{Fact, FactValue, Part};

fn fact(part: Part, item: &str, quantity: impl Into<String>, value: FactValue) -> Fact {
    Fact { part, item: item.to_owned(), quantity: quantity.into(), value }
}

fn number(value: f64) -> FactValue {
    FactValue::Number(Number(value))
}

fn text(text: &str) -> FactValue {
    FactValue::Text(text.to_owned())
}

/// Facts of the run at the time shown, and of the kept runs at theirs: the independent variable, the states, and the
/// parameters that are shown. `document`: name of the text of the document.
pub fn facts_of_run(play: &Play, document: String) -> Vec<Fact> {
    let (model, states) = (play.model(), play.values().states());
    let title = &play.program().title;
    let mut facts = vec![fact(Part::Run, title, "document", FactValue::Text(document))];
    if let Some(SeatView { assignment, number: seat }) = play.basis().seat() {
        facts.push(fact(Part::Run, title, "assignment", FactValue::Text(assignment)));
        facts.extend(seat.map(|seat| fact(Part::Run, title, "seat", number(seat.into()))));
    }
    let mut add = |item: &str, time: f64, state: &dyn Fn(&StateView) -> f64, parameters: &[f64]| {
        let states = states.iter().map(|own| (format!("value:{}", own.name), state(own)));
        let shown = model.shown_parameters();
        let parameters =
            shown.filter_map(|(index, own)| Some((format!("parameter:{}", own.name), *parameters.get(index)?)));
        let time = (format!("value:{}", model.independent.name), time);
        let values = std::iter::once(time).chain(states).chain(parameters);
        facts.extend(values.map(|(quantity, value)| fact(Part::Run, item, quantity, number(value))));
    };
    add(title, play.course().time(), &|own| own.value, play.course().parameters());
    let mut names: Vec<String> = Vec::new();
    for kept in play.time_line().kept_values(play.basis()) {
        let same = names.iter().filter(|name| **name == kept.name).count();
        let again = if same == 0 { String::new() } else { format!(" ({})", same + 1) };
        let state = |own: &StateView| kept.state.get(own.index).copied().unwrap_or(f64::NAN);
        add(&format!("{title}: {}{again}", kept.name), kept.time, &state, &kept.parameters);
        names.push(kept.name.clone());
    }
    facts
}

/// Value of the fact of a computed grade if the conditions of the attempt are unknown.
pub const UNKNOWN_GRADE: &str = "unknown";

/// Facts of the answers by the number of their question: the text in the field, the number of attempts before the right answer was
/// shown, the attempts allowed and made if the document limits them, and each attempt with its conditions, the grade that was given and the grade that follows. An attempt without conditions
/// has besides the grade that follows from the values at the end, which versions up to 0.2.0 stated.
pub fn facts_of_answers(play: &Play) -> Vec<Fact> {
    let mut facts = Vec::new();
    for question in 0..play.program().questions.len() {
        let answer = play.answers().answer(play.basis(), question);
        let mut add = |quantity: String, value: FactValue| {
            facts.push(fact(Part::Answer, &(question + 1).to_string(), quantity, value));
        };
        let end_grade = |typed: &str| play.answers().end_grade(play.basis(), play.course(), question, typed);
        if !answer.typed.is_empty() {
            add("text".to_owned(), text(&answer.typed));
        }
        if let Some(before) = answer.shown {
            add("shown".to_owned(), number(before as f64));
        }
        if let Some(stated) =
            answer.stated.filter(|_| answer.attempts.last().is_none_or(|one| one.conditions.is_none()))
        {
            add("given".to_owned(), text(&stated.code()));
            add("end-grade".to_owned(), text(&end_grade(&answer.typed).code()));
        }
        if let Some(Limit { allowed, made }) = answer.limit {
            add("allowed".to_owned(), number(allowed as f64));
            add("made".to_owned(), number(made as f64));
        }
        for (attempt, number) in answer.attempts.iter().zip(1..) {
            add(format!("attempt:{number}"), text(&attempt.typed));
            if let Some(conditions) = &attempt.conditions {
                add(format!("conditions:{number}"), text(&conditions.text()));
            }
            add(format!("given:{number}"), text(&attempt.stated.code()));
            if attempt.conditions.is_none() {
                add(format!("end-grade:{number}"), text(&end_grade(&attempt.typed).code()));
            }
            add(format!("grade:{number}"), text(&attempt.computed.map_or(UNKNOWN_GRADE.into(), Grade::code)));
        }
    }
    facts
}
