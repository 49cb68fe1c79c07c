//! Hand-in of the work in this page, in the format of `saved::hand_in`: the document, the state, the answers, and the values that
//! follow from them.

use crate::{source, words};
use handed::answer::item;
use handed::json;
use handed::parts::{self, HAND_IN_VERSION, Head, Parts, Sender};
use play::{Answer, Play, facts_of_answers, facts_of_run, name_of};
use program::{BITS, VERSION};
use view::views::*;
use view::{App, browser, page::handing, pieces::icons};
use web_sys::HtmlDialogElement;

/// Id of the dialog.
const ID: &str = "hand-in-dialog";

/// Button of the header; empty if the page does not contain its document.
pub fn button_of(app: App) -> View {
    if source::files().is_empty() {
        return View::new();
    }
    let open = move |_| {
        if let Some(dialog) = browser::by_id::<HtmlDialogElement>(ID) {
            let _ = dialog.show_modal();
        }
    };
    labelled(icons::up(), app.words().hand_in)
        .id("hand-in")
        .attr("aria-haspopup", "dialog")
        .when(events::click, open)
        .into()
}

/// The dialog with the form.
pub fn dialog(app: App) -> View {
    let form = handing::form(app, move |name, done| {
        // The button is there only in a page with its document.
        if let Some(Made { file, parts, count }) = app.read(|play| made(play, &name)) {
            browser::save_text(&file, "application/json", &parts.text());
            done(handing::saved(app, &file, count));
        }
    });
    let words = words::of(app);
    let content = div().class("publishing").child(note(words.hand_in_intro)).child(form);
    view::views::dialog(ID, "hand-in-title", app.words().hand_in, words.close).child(content).into()
}

/// A hand-in.
pub struct Made {
    /// Name of the file.
    file: String,
    /// The parts of the hand-in.
    pub parts: Parts<'static>,
    /// Number of its values.
    count: usize,
}

/// The hand-in of this name; `None` if the page does not contain its document. The values are computed again from the state, as they
/// are when the file is verified.
pub fn made(play: &mut Play, name: &str) -> Option<Made> {
    let files = source::files();
    let (first, text) = files.first()?;
    let state = play.share();
    let mut again = Play::open(play.program().clone());
    // Parts that cannot be restored are missing when the file is verified, too.
    let _ = again.restore(&state);
    let saved = play.answers().saved(play.basis());
    for (question, answer) in &saved {
        again.change_answers(|answers, run| answers.restore(run, question, answer));
    }
    let facts = [facts_of_run(&again, name_of(&[text])), facts_of_answers(&again)].concat();
    let (seat, assignment) = play.basis().seat().map_or((None, String::new()), |seat| (seat.number, seat.assignment));
    let head = Head {
        version: HAND_IN_VERSION,
        program: VERSION.to_owned(),
        bits: Some(BITS),
        made: js_sys::Date::now() as u64,
        sender: Sender { name: name.to_owned(), seat, assignment },
    };
    let item = |(question, answer): (String, Answer)| {
        let item = parts::named_item(&question, &item("answer", &answer.stored().json(), 0));
        (question, item.into())
    };
    let parts = Parts {
        head,
        documents: parts::documents(files.iter().map(|(name, text)| (name.as_str(), text.as_str()))).into(),
        state: json::text(&state).into(),
        items: saved.into_iter().map(item).collect(),
        facts: parts::facts(&facts).into(),
    };
    let stem = first.split('.').next().filter(|stem| !stem.is_empty()).unwrap_or("work");
    Some(Made { file: format!("{stem}.hand-in"), parts, count: facts.len() })
}
