//! Teacher's view of the questions: all questions with answers, hints and hidden values, and a form for a new one.

mod card;
mod new_question;

use super::typing;
use crate::app::App;
use card::Questions;
use document::{Asked, QuestionPart, asked};
use model::Diagnostic;
use view::views::*;

/// Panel of the questions.
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
            let one = |number| {
                (
                    play.program().question_text(language, number).clone(),
                    play.answers().right_text(play.basis(), play.course(), number),
                )
            };
            (0..count).map(one).collect::<Vec<_>>()
        })
    });
    let faults = memo(move || {
        app.written.track();
        app.read_writing(|writing| {
            let checked = asked(&document::read(writing.texts().first().map_or("", String::as_str)));
            let of = |(file, found): &(usize, Diagnostic)| {
                let place = found.span().start;
                let is_own = |one: &Asked| one.place.start <= place && place <= one.place.end;
                let number = checked.iter().position(is_own).filter(|_| *file == 0)?;
                Some((number, found.clone()))
            };
            writing.findings().iter().filter_map(of).collect()
        })
    });
    let questions = Questions { app, all, shown, faults };
    // Determines the fields; their contents change inside them. An emptied field stays until a question is added or
    // removed.
    let mut last: Vec<Vec<QuestionPart>> = Vec::new();
    let shapes = memo(move || {
        let now: Vec<Vec<QuestionPart>> = all.with(|all| all.iter().map(card::parts).collect());
        if now.len() != last.len() {
            last = now;
        } else {
            for (known, now) in last.iter_mut().zip(now) {
                known.extend(now.into_iter().filter(|part| !known.contains(part)).collect::<Vec<_>>());
            }
        }
        last.clone()
    });
    let list = move || {
        let shapes = shapes.get_clone();
        if shapes.is_empty() {
            return View::from(note(app.words().questions_none));
        }
        let card = |(number, parts): (usize, Vec<QuestionPart>)| card::view(questions, number, parts);
        ol().class("asked").each(shapes.into_iter().enumerate(), card).into()
    };
    View::from((typing::undo_buttons(app), changing(list), new_question::view(app)))
}
