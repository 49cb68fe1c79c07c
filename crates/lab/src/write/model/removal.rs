//! Removal of statements.

use super::cell;
use super::forms::Forms;
use crate::write::typing;
use document::edit::remove_statement;
use document::form::CellKind;
use view::browser;
use view::pieces::icons;
use view::views::*;

/// Removes a statement; the focus moves to the button of its section.
fn remove(forms: Forms, number: usize) {
    let app = forms.app;
    let text = typing::text(app, 0);
    let removed = typing::act(app, 0, &text, |outline| remove_statement(outline, number).map(|edit| vec![edit]));
    match removed {
        Ok(_) => {
            let left = forms.form.with_untracked(|form| {
                let near = number.min(form.parts.len().saturating_sub(1));
                form.parts.get(near).and_then(|part| part.cells.first()).map(|cell| (near, cell.kind))
            });
            if let Some((number, kind)) = left {
                browser::focus_later(cell::id(number, kind));
            }
        }
        Err(refusal) => app.complain(refusal),
    }
}

/// Button that removes a statement.
pub fn remove_button(forms: Forms, number: usize) -> HtmlButton {
    let name = memo(move || {
        forms.form.with(|form| {
            let part = form.parts.get(number);
            let name = part.and_then(|part| part.cell(CellKind::Name).or(Some(&part.whole)));
            name.map(|cell| cell.text.lines().next().unwrap_or_default().to_owned()).unwrap_or_default()
        })
    });
    let title = move || name.with(|name| format!("{} {name}", forms.app.words().remove_statement));
    button()
        .class("icon small")
        .attr("title", title)
        .attr("aria-label", title)
        .when(events::click, move |_| remove(forms, number))
        .child(icons::cross())
}
