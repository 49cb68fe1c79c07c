//! Files that are dropped anywhere on the page, and the sign that they can be while they are dragged over it.

use crate::app::App;
use crate::files;
use view::browser;
use view::views::*;
use web_sys::{DragEvent, Event};

/// Whether what is dragged are files. Text that is dragged into a field is left to the browser.
fn holds_files(event: &DragEvent) -> bool {
    event.data_transfer().is_some_and(|data| data.types().includes(&"Files".into(), 0))
}

/// Listens as long as the page lives.
pub fn listen(app: App) {
    // `dragenter` and `dragover` have to be refused, or the browser opens the file itself.
    for kind in ["dragenter", "dragover"] {
        browser::listen(kind, move |event: &DragEvent| {
            if holds_files(event) {
                event.prevent_default();
                if !app.dragging_files.get_untracked() {
                    app.dragging_files.set(true);
                }
            }
        });
    }
    // Going from one element to the next leaves the first; out of the window there is no next one.
    browser::listen("dragleave", move |event: &DragEvent| {
        if event.related_target().is_none() {
            app.dragging_files.set(false);
        }
    });
    browser::listen("drop", move |event: &DragEvent| {
        app.dragging_files.set(false);
        if !holds_files(event) {
            return;
        }
        event.prevent_default();
        if let Some(files) = event.data_transfer().and_then(|data| data.files()) {
            files::open(app, &files);
        }
    });
    // A drag that ends elsewhere, or with Escape, may cause no event; a pointer that moves again has let go.
    browser::listen("pointermove", move |_: &Event| {
        if app.dragging_files.get_untracked() {
            app.dragging_files.set(false);
        }
    });
}

/// The sign. It takes no pointer: the drop goes to what lies below it.
pub fn view(app: App) -> View {
    changing(move || {
        if !app.dragging_files.get() {
            return View::new();
        }
        let words = app.words();
        let sign = div().child(p().class("drop-title").child(words.drop_title)).child(p().child(words.drop_what));
        div().class("drop").id("drop").attr("aria-hidden", "true").child(sign).into()
    })
}
