//! Verification of a dropped hand-in or report: its values are computed again in slices, and a dialog shows the result. Its work
//! can be opened like a project.

use super::reading::read;
use super::recomputing;
use super::verdict::Verified;
use crate::app::App;
use crate::{class, documents::project};
use ::class::verify::{Recomputation, compare, meaning};
use desk::saved::hand_in::{HandIn, HandInError};
use std::rc::Rc;
use view::views::*;
use view::{browser, pieces, table_of_words};
use web_sys::{File, HtmlDialogElement};

/// Id of the dialog.
const ID: &str = "verified";

/// Maximum number of differences that are listed; the number of the others is stated.
const MOST_LISTED: usize = 200;

table_of_words! {
    title: "Verification";
    close: "Close";
    computing: "The values are being computed again ...";
    holds: "Every value follows from the data.";
    fails: "Not every value follows from the data.";
    more: "Further differences: #";
    open: "Open this work";
    to_class: "Add to the class";
    open_title: "Opens the document with its records, fits and answers";
}

/// Verifies a file that should be a hand-in.
pub async fn open(app: App, file: &File) {
    let name = file.name();
    let Some(hand_in) = read(file).await else {
        return app.complain(format!("{} {name}", app.words().file_not_read));
    };
    verify(app, &name, hand_in, Some(file.clone())).await;
}

/// Verifies the hand-in of a report, or states why there is none.
pub async fn show(app: App, file: &str, hand_in: Result<HandIn, HandInError>) {
    verify(app, file, hand_in, None).await;
}

async fn verify(app: App, file: &str, hand_in: Result<HandIn, HandInError>, handed: Option<File>) {
    let mut hand_in = match hand_in {
        Ok(hand_in) => hand_in,
        Err(error) => return refuse(app, file, error),
    };
    let sender = &hand_in.sender.name;
    let name = if sender.is_empty() { file.to_owned() } else { format!("{file} ({sender})") };
    let recomputation = match Recomputation::begin(&hand_in.work) {
        Ok(recomputation) => recomputation,
        Err(why) => return app.complain(format!("{name}: {}", why.text(app.language.get_untracked()))),
    };
    let work = Rc::new(std::mem::take(&mut hand_in.work));
    let computing = Verified { name, holds: None, lines: Vec::new(), work, file: handed };
    app.verified.set(Some(computing.clone()));
    if let Some(dialog) = browser::by_id::<HtmlDialogElement>(ID).filter(|dialog| !dialog.open()) {
        let _ = dialog.show_modal();
    }
    let recomputation = recomputing::finished(recomputation).await;
    let refused = recomputation.refused();
    let verdict = compare(&hand_in, &recomputation.facts(), refused);
    // Closed, or replaced by another file meanwhile.
    let is_shown =
        app.verified.with_untracked(|now| now.as_ref().is_some_and(|now| Rc::ptr_eq(&now.work, &computing.work)));
    if is_shown {
        let lines = verdict.lines(app.language.get_untracked());
        app.verified.set(Some(Verified { holds: Some(verdict.holds()), lines, ..computing }));
    }
}

fn refuse(app: App, file: &str, error: HandInError) {
    app.complain(format!("{file} {}", error.words().text(app.language.get_untracked())));
}

/// The dialog. Its content exists only while it is open.
pub fn dialog(app: App) -> HtmlDialog {
    let words = words_in(app.language.get_untracked());
    pieces::dialog(ID, "verified-title", words.title, words.close)
        .when(events::close, move |_| app.verified.set(None))
        .child(changing(move || app.verified.get_clone().map_or_else(View::new, |verified| content(app, verified))))
}

fn close() {
    if let Some(dialog) = browser::by_id::<HtmlDialogElement>(ID) {
        dialog.close();
    }
}

fn content(app: App, verified: Verified) -> View {
    let language = app.language.get_untracked();
    let words = words_in(language);
    let verdict = match verified.holds {
        None => words.computing,
        Some(true) => words.holds,
        Some(false) => words.fails,
    };
    let mut lines = verified.lines.into_iter();
    let summary = lines.next().unwrap_or_default();
    let left_out = lines.len().saturating_sub(MOST_LISTED);
    let listed: Vec<String> = lines.take(MOST_LISTED).collect();
    let more = (left_out > 0).then(|| words.more.replace('#', &left_out.to_string()));
    let (name, work) = (verified.name.clone(), verified.work);
    let to_class = verified.file.map(|file| {
        let add = move |_| {
            close();
            wasm_bindgen_futures::spawn_local(class::add(app, vec![file.clone()]));
        };
        button().class("quiet").id("verified-to-class").when(events::click, add).child(words.to_class)
    });
    let open = move |_| {
        close();
        project::show(app, &verified.name, (*work).clone());
    };
    View::from((
        p().child(strong().attr("dir", "auto").child(name)),
        p().role("status").id("verdict").child(verdict).child(" ").child(summary),
        ul().id("differences").each(listed, |line| li().attr("dir", "auto").child(line)),
        p().class("note").child(more.unwrap_or_default()),
        p().class("note").child(meaning().text(language).into_owned()),
        div()
            .class("ways")
            .child(
                button()
                    .class("action")
                    .id("open-verified")
                    .title(words.open_title)
                    .when(events::click, open)
                    .child(words.open),
            )
            .maybe(to_class),
    ))
}
