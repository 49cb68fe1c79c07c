//! Storage of the answers to the page's questions, for the next visit.

use play::{Answer, name_of};
use view::{App, browser};

/// Prefix of the storage keys of the answers to this simulation.
fn prefix(app: App) -> String {
    let program = app.read(|play| Some((play.program().title.clone(), play.program().language.clone())));
    let (title, language) = program.unwrap_or_default();
    format!("played:{}:", name_of(&[&title, &language]))
}

/// Restores the answers of the last visit.
pub fn restore(app: App) {
    let prefix = prefix(app);
    for (key, text) in browser::all_remembered(&prefix) {
        let name = key.strip_prefix(&prefix).unwrap_or_default();
        if let Some(answer) = Answer::of_lines(&text) {
            app.read(|play| play.change_answers(|answers, run| answers.restore(run, name, &answer)));
        }
    }
}

/// Stores all answers. Returns true if the browser allowed it.
pub fn save(app: App) -> bool {
    let prefix = prefix(app);
    let answers = app.read(|play| play.answers().saved(play.basis()));
    answers.into_iter().all(|(name, answer)| browser::remember(&format!("{prefix}{name}"), &answer.lines()))
}
