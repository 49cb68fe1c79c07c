//! Form of a hand-in: the name, a button that saves the file, and what became of it.

use crate::app::App;
use crate::browser;
use crate::views::*;

/// Storage key of the name handed in last.
const NAME: &str = "hand-in-name";

/// Maximum length of a name, in characters.
const LONGEST_NAME: u32 = 100;

/// The form. `save` makes the file for a name and passes a sentence about it to the function that it gets.
pub fn form(app: App, save: impl Fn(String, Box<dyn FnOnce(String)>) + 'static) -> View {
    let words = app.words();
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
        let done = move |sentences| {
            // The dialog may have been closed meanwhile.
            if said.is_alive() {
                said.set(sentences);
                is_busy.set(false);
            }
        };
        save(name, Box::new(done));
    };
    let busy = move || is_busy.get().then_some("true");
    let save = button().class("action").id("save-hand-in").attr("aria-disabled", busy).when(events::click, save);
    View::from((
        label().class("field").child(span().child(words.hand_in_name)).child(field),
        div().class("ways").child(save.child(words.hand_in_save)),
        p().class("note").role("status").id("hand-in-said").child(text(move || said.get_clone())),
        note(words.hand_in_meaning),
    ))
}

/// Sentence about a saved file with this number of values.
pub fn saved(app: App, file: &str, values: usize) -> String {
    app.words().hand_in_saved.replace("{file}", file).replace('#', &values.to_string())
}
