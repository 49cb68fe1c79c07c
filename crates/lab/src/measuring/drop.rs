//! Dropping files anywhere on the page, with a visible hint while they are dragged over it.

use crate::app::App;
use crate::{class, measuring::files};
use view::browser;
use view::views::*;
use web_sys::{DragEvent, Event};

/// True if files are being dragged. Dragged text is left to the browser.
fn holds_files(event: &DragEvent) -> bool {
    event.data_transfer().is_some_and(|data| data.types().includes(&"Files".into(), 0))
}

/// Installs the listeners, which live as long as the page.
pub fn listen(app: App) {
    // The default action must be prevented; otherwise the browser opens the file itself.
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
    // A move to another element also fires `dragleave`; only on leaving the window is there no related target.
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
        let Some(data) = event.data_transfer() else { return };
        let folders = class::folders(&data);
        if !folders.is_empty() {
            wasm_bindgen_futures::spawn_local(class::add_of_folders(app, folders));
        } else if let Some(files) = data.files() {
            files::open(app, &files);
        }
    });
    // A drag that ends elsewhere or with Escape may fire no event. A pointer move shows that it has ended.
    browser::listen("pointermove", move |_: &Event| {
        if app.dragging_files.get_untracked() {
            app.dragging_files.set(false);
        }
    });
}

/// The hint. It ignores the pointer, so that the drop reaches the content below.
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
