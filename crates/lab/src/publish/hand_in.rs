//! Hand-in of the work with this document: its values are computed again from the work in slices, then a file is saved.

use super::words;
use crate::app::App;
use crate::verifying::recomputing;
use crate::verifying::sender::sender;
use crate::visited::{files, stem};
use class::verify::Recomputation;
use desk::saved::hand_in::{HAND_IN_ENDING, HandIn, LONGEST_NAME};
use desk::saved::project::Project;
use view::browser;
use view::views::*;

/// Storage key of the name handed in last.
const NAME: &str = "hand-in-name";

/// Section of the dialog: a field for the name, and a button that saves the hand-in.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let name = create_signal(browser::remembered(NAME).unwrap_or_default());
    let said = create_signal(String::new());
    let is_busy = create_signal(false);
    let field = input()
        .r#type("text")
        .id("hand-in-name")
        .attr("maxlength", LONGEST_NAME.to_string())
        .attr("autocomplete", "off")
        .attr("value", name.get_clone_untracked())
        .when(events::input, move |event| name.set(value_of(&event)));
    let save = move |_| {
        let name = name.get_clone_untracked().trim().to_owned();
        if is_busy.get_untracked() {
            return;
        }
        if name.is_empty() {
            said.set(words.hand_in_unnamed.to_owned());
            return browser::focus("hand-in-name");
        }
        browser::remember(NAME, &name);
        is_busy.set(true);
        said.set(words.hand_in_computing.to_owned());
        make(app, name, move |sentences| {
            // The dialog may have been closed meanwhile.
            if said.is_alive() {
                said.set(sentences);
                is_busy.set(false);
            }
        });
    };
    let busy = move || is_busy.get().then_some("true");
    let save = button().class("action").id("save-hand-in").attr("aria-disabled", busy).when(events::click, save);
    View::from((
        note(words.hand_in_intro),
        label().class("field").child(span().child(words.hand_in_name)).child(field),
        div().class("ways").child(save.child(words.hand_in_save)),
        p().class("note").role("status").id("hand-in-said").child(text(move || said.get_clone())),
        note(words.hand_in_meaning),
    ))
}

/// Computes the values that follow from the work, saves the file, and passes a sentence about it to `done`.
fn make(app: App, name: String, done: impl FnOnce(String) + 'static) {
    let words = words::of(app);
    let now = js_sys::Date::now() as u64;
    let (state, items, left_out) = app.read_desk(|desk| {
        let stored = desk.saved_records().len();
        let left_out = desk.records().len().saturating_sub(stored);
        (desk.play().share(), desk.project_items(now), left_out)
    });
    let work = Project { documents: files(app), state, items };
    let recomputation = match Recomputation::begin(&work) {
        Ok(recomputation) => recomputation,
        Err(_) => return done(words.faulty.to_owned()),
    };
    let sender = sender(app, name);
    let hand_in =
        HandIn { program: env!("CARGO_PKG_VERSION").to_owned(), made: now, sender, work, ..HandIn::default() };
    wasm_bindgen_futures::spawn_local(async move {
        let recomputation = recomputing::finished(recomputation).await;
        let lost = recomputation.refused() + left_out;
        let hand_in = HandIn { facts: recomputation.facts(), ..hand_in };
        let file = format!("{}{HAND_IN_ENDING}", stem(app));
        browser::save_text(&file, "application/json", &hand_in.write());
        let count = hand_in.facts.len().to_string();
        let mut sentences = words.hand_in_saved.replace("{file}", &file).replace('#', &count);
        if lost > 0 {
            sentences = format!("{sentences} {}", words.hand_in_left_out.replace('#', &lost.to_string()));
        }
        done(sentences);
    });
}
