//! Diagnostics beside a statement.

use super::cell;
use super::fault::id;
use super::forms::{Forms, Refusal};
use crate::app::App;
use crate::write::{briefs, typing};
use document::edit::Edit;
use document::form::places;
use model::Fix;
use view::views::*;

/// Diagnostics of a statement with their remedies, and the reason why its last change was refused.
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
        .child(briefs::view(forms.app, own, move |fix| changed_cell(forms.app, fix)))
        .child(p().class("refusal").role("alert").child(text(refused)))
}

/// Id of the cell that a remedy has changed or added.
fn changed_cell(app: App, fix: &Fix) -> String {
    let text = typing::text(app, 0);
    let form = places(&document::read(&text));
    let written = |edit: &Edit| {
        let blanks = edit.text.len() - edit.text.trim_start().len();
        form.at(edit.span.start + blanks)
    };
    let place = fix.edits.iter().rev().find_map(written);
    place.map_or_else(String::new, |(number, kind)| cell::id(number, kind))
}

/// Signal that is true if there are diagnostics or a refusal for a statement.
pub fn any(forms: Forms, number: usize, refusal: Refusal) -> ReadSignal<bool> {
    memo(move || {
        refusal.with(Option::is_some) || forms.faults.with(|faults| faults.iter().any(|fault| fault.part == number))
    })
}
