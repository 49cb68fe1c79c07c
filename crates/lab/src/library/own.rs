//! Cards of documents written in this browser. Each can be removed, and restored while the library is open.

use crate::app::App;
use crate::write::kept::{self, Document, Removed};
use crate::write::time_text;
use std::rc::Rc;
use view::views::*;
use view::{browser, pieces::icons};

/// Card of a document. `id` is that of the button that opens or restores it. `face` builds the card from this button
/// and the content below the summary.
pub fn card(
    app: App,
    document: Document,
    id: String,
    face: impl Fn(View, View) -> View + 'static,
    open: impl Fn(&Document) + Clone + 'static,
) -> View {
    let removed = create_signal(None::<Rc<Removed>>);
    let document = Rc::new(document);
    changing(move || match removed.get_clone() {
        Some(gone) => undo(app, &document, &id, move || {
            if kept::put_back(&gone) {
                removed.set(None);
            } else {
                app.complain(app.words().not_saved.to_owned());
            }
        }),
        None => {
            let words = app.words();
            let (own, open) = (document.clone(), open.clone());
            let lead = button()
                .id(id.clone())
                .class("entry")
                .attr("aria-describedby", format!("{id}-time"))
                .when(events::click, move |_| open(&own))
                .child(document.title.clone());
            let (name, undo) = (document.name.clone(), id.clone());
            let remove = button()
                .class("icon")
                .called(format!("{}: {}", words.own_remove, document.title))
                .when(events::click, move |_| {
                    browser::focus_later(undo.clone());
                    removed.set(Some(Rc::new(kept::remove(&name))));
                })
                .child(icons::bin());
            let time = span().id(format!("{id}-time")).child(format!(
                "{}: {}",
                words.own_changed,
                time_text(app, document.changed)
            ));
            face(lead.into(), p().class("library-own").child(time).child(remove).into())
        }
    })
}

/// Replaces the card of a removed document.
fn undo(app: App, document: &Document, id: &str, put_back: impl Fn() + 'static) -> View {
    let words = app.words();
    let (note, back) = (format!("{id}-removed"), id.to_owned());
    let undo = button()
        .class("quiet outlined")
        .id(id.to_owned())
        .attr("aria-describedby", note.clone())
        .when(events::click, move |_| {
            browser::focus_later(back.clone());
            put_back();
        })
        .child(words.undo_change);
    let said = p().class("library-removed").id(note).child(format!("{}: {}", words.own_removed, document.title));
    View::from((said, p().class("library-removed").child(undo)))
}
