//! Hand-in of the work with this document: its values are computed again from the work in slices, then a file is saved.

use super::words;
use crate::app::App;
use crate::documents::visited::{files, stem};
use crate::verifying::recomputing;
use crate::verifying::sender::sender;
use class::verify::Recomputation;
use desk::saved::hand_in::{HAND_IN_ENDING, HandIn};
use desk::saved::project::Project;
use view::views::*;
use view::{browser, page::handing};

/// Section of the dialog: what the file contains, and the form.
pub fn view(app: App) -> View {
    View::from((note(words::of(app).hand_in_intro), handing::form(app.page, move |name, done| make(app, name, done))))
}

/// Computes the values that follow from the work, saves the file, and passes a sentence about it to `done`.
fn make(app: App, name: String, done: impl FnOnce(String) + 'static) {
    let words = words::of(app);
    wasm_bindgen_futures::spawn_local(async move {
        let Some((hand_in, lost)) = made(app, name).await else { return done(words.faulty.to_owned()) };
        let file = format!("{}{HAND_IN_ENDING}", stem(app));
        browser::save_text(&file, "application/json", &hand_in.write());
        let mut sentences = handing::saved(app.page, &file, hand_in.facts.len());
        if lost > 0 {
            sentences = format!("{sentences} {}", words.hand_in_left_out.replace('#', &lost.to_string()));
        }
        done(sentences);
    });
}

/// Hand-in of the present work, and the number of its parts that were left out; `None` if the document has errors.
pub async fn made(app: App, name: String) -> Option<(HandIn, usize)> {
    let now = js_sys::Date::now() as u64;
    let (state, items, left_out) = app.read_desk(|desk| {
        let stored = desk.records().saved().len();
        let left_out = desk.records().list().len().saturating_sub(stored);
        // Without the times of storage: the same work makes the same items.
        (desk.play().share(), desk::project_items(desk, 0), left_out)
    });
    let work = Project { documents: files(app), state, items };
    let recomputation = Recomputation::begin(&work).ok()?;
    let sender = sender(app, name);
    let recomputation = recomputing::finished(recomputation).await;
    let lost = recomputation.refused() + left_out;
    Some((HandIn::new(now, sender, work, recomputation.facts()), lost))
}
