//! Diagnostics of a part of the document, shown beside its fields.

use super::{draft, typing};
use crate::app::App;
use crate::documents::diagnostics::{self, CarryOut};
use model::{Diagnostic, Fix};
use std::rc::Rc;
use view::browser;
use view::views::*;

/// Diagnostics with buttons for their remedies, which change the document. `next` returns the id of the element that
/// takes the focus when such a button disappears.
pub fn view(app: App, found: ReadSignal<Vec<Diagnostic>>, next: impl Fn(&Fix) -> String + 'static) -> View {
    let carry_out: CarryOut = Rc::new(move |_, fix| {
        let checked = app.read_writing(|writing| writing.texts().first().cloned().unwrap_or_default());
        // If the text has changed since the check, it is checked again first.
        if checked == typing::text(app, 0) {
            let _ = typing::act(app, 0, &checked, |_| Ok(fix.edits.clone()));
        }
        draft::flush(app);
        browser::keep_focus_later(next(fix));
    });
    changing(move || {
        let text = app.read_writing(|writing| writing.texts().first().cloned().unwrap_or_default());
        each(found.get_clone(), |found| diagnostics::brief(app, &text, &found, carry_out.clone()))
    })
}
