//! What is wrong with a statement, beside it.

use super::fault::id;
use super::forms::{Forms, Refusal};
use crate::diagnostics::{self, CarryOut};
use crate::write::typing;
use std::rc::Rc;
use view::views::*;

/// What is wrong with a statement, with its remedies, and why its last change was refused.
pub fn view(forms: Forms, number: usize, refusal: Refusal) -> HtmlDiv {
    let own = memo(move || {
        forms.faults.with(|faults| faults.iter().filter(|fault| fault.part == number).cloned().collect::<Vec<_>>())
    });
    let carry_out: CarryOut = Rc::new(move |_, fix| {
        let app = forms.app;
        let checked = app.read_writing(|writing| writing.texts().first().cloned().unwrap_or_default());
        // A text that has changed since is checked first.
        if checked == typing::text(app, 0) {
            let _ = typing::act(app, 0, &checked, |_| Ok(fix.edits.clone()));
        }
        crate::write::flush(app);
    });
    let list = move || {
        let text = forms.app.read_writing(|writing| writing.texts().first().cloned().unwrap_or_default());
        each(own.get_clone(), |fault| diagnostics::brief(forms.app, &text, &fault.found, carry_out.clone()))
    };
    let refused =
        move || refusal.with(|refusal| refusal.as_ref().map(|(_, why)| format!("{why}.")).unwrap_or_default());
    div()
        .class("faults")
        .id(id(number))
        .child(changing(list))
        .child(p().class("refusal").role("alert").child(text(refused)))
}

/// Whether there is anything to say of a statement.
pub fn any(forms: Forms, number: usize, refusal: Refusal) -> ReadSignal<bool> {
    memo(move || {
        refusal.with(Option::is_some) || forms.faults.with(|faults| faults.iter().any(|fault| fault.part == number))
    })
}
