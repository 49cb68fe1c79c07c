//! A statement as text, with its typeset form.

use super::cell::{field, lines};
use super::faults;
use super::forms::Forms;
use super::removal::remove_button;
use document::form::CellKind;
use view::views::*;

/// A single line for an equation or definition; otherwise a card with several lines.
pub fn view(forms: Forms, number: usize, has_lines: bool) -> HtmlDiv {
    let refusal = create_signal(None);
    let name = format!("{} {}", forms.app.words().form_statement, number + 1);
    let field: View = if has_lines {
        lines(forms, number, name, refusal).into()
    } else {
        field(forms, number, CellKind::Text, move || name.clone(), refusal).into()
    };
    let typeset = memo(move || {
        forms.form.with(|form| form.parts.get(number).map(|part| part.typeset.clone()).unwrap_or_default())
    });
    let typeset = changing(move || div().class("typeset").inner_html(typeset.get_clone()));
    let line = div().class("statement-line").child(field).child(remove_button(forms, number));
    let class = if has_lines { "statement card" } else { "statement" };
    div().class(class).child(line).child(typeset).child(faults::view(forms, number, refusal))
}
