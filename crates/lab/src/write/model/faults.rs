//! What is wrong with a statement, beside it.

use super::fault::id;
use super::forms::{Forms, Refusal};
use crate::write::briefs;
use view::views::*;

/// What is wrong with a statement, with its remedies, and why its last change was refused.
pub fn view(forms: Forms, number: usize, refusal: Refusal) -> HtmlDiv {
    let own = memo(move || {
        forms.faults.with(|faults| {
            let own = faults.iter().filter(|fault| fault.part == number);
            own.map(|fault| fault.found.clone()).collect::<Vec<_>>()
        })
    });
    let refused =
        move || refusal.with(|refusal| refusal.as_ref().map(|(_, why)| format!("{why}.")).unwrap_or_default());
    div()
        .class("faults")
        .id(id(number))
        .child(briefs::view(forms.app, own))
        .child(p().class("refusal").role("alert").child(text(refused)))
}

/// Whether there is anything to say of a statement.
pub fn any(forms: Forms, number: usize, refusal: Refusal) -> ReadSignal<bool> {
    memo(move || {
        refusal.with(Option::is_some) || forms.faults.with(|faults| faults.iter().any(|fault| fault.part == number))
    })
}
