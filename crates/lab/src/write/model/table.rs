//! Parameters and initial values: a row for each, or a card if the window is narrow.

use super::cell::{field, switch_field};
use super::faults;
use super::forms::{Forms, Refusal};
use super::removal::remove_button;
use super::shape::{self, Shape};
use crate::app::App;
use document::form::{CellKind, Section};
use view::views::*;

/// Columns of a section.
fn columns(section: Section) -> &'static [CellKind] {
    use CellKind::{Label, Name, Range, Step, Unit, Value};
    if section == Section::InitialValues {
        &[Name, Value, Unit, Label]
    } else {
        &[Name, Value, Unit, Range, Step, Label]
    }
}

fn title(app: App, section: Section, kind: CellKind) -> &'static str {
    let words = app.words();
    match kind {
        CellKind::Name if section == Section::InitialValues => words.column_quantity,
        CellKind::Name => words.column_name,
        CellKind::Value if section == Section::InitialValues => words.column_start,
        CellKind::Value => words.column_value,
        CellKind::Unit if section == Section::InitialValues => words.column_shown_in,
        CellKind::Unit => words.column_unit,
        CellKind::Range => words.column_range,
        CellKind::Step => words.column_step,
        CellKind::Label | CellKind::Text => words.column_label,
    }
}

/// The table. Explicit roles keep it a table for screen readers if the rows are laid out as cards.
pub fn view(forms: Forms, section: Section, rows: Vec<(usize, Shape)>) -> HtmlTable {
    let columns = columns(section);
    let head = tr()
        .role("row")
        .each(columns, |kind| column_head(title(forms.app, section, *kind)).role("columnheader"))
        .child(
            th().scope("col")
                .role("columnheader")
                .child(span().class("visually-hidden").child(forms.app.words().remove_statement)),
        );
    let class = if section == Section::Parameters { "form-table parameters-form" } else { "form-table" };
    table()
        .class(class)
        .role("table")
        .child(caption().class("visually-hidden").child(shape::title(forms.app, section)))
        .child(thead().role("rowgroup").child(head))
        .child(tbody().role("rowgroup").each(rows, |(number, shape)| row(forms, section, number, &shape)))
}

fn row(forms: Forms, section: Section, number: usize, shape: &Shape) -> View {
    let app = forms.app;
    let refusal: Refusal = create_signal(None);
    let any = faults::any(forms, number, refusal);
    let span = columns(section).len();
    let said = td().role("cell").attr("colspan", (span + 1).to_string()).child(faults::view(forms, number, refusal));
    let said = tr().role("row").class("fault-row").hidden(move || !any.get()).child(said);
    let remove = td().role("cell").class("remove").child(remove_button(forms, number));
    if shape.word == "group" {
        let name = field(forms, number, CellKind::Label, move || app.words().group.to_owned(), refusal);
        let name = td()
            .role("cell")
            .class("of-group")
            .attr("colspan", span.to_string())
            .attr("data-title", app.words().group)
            .child(name);
        return View::from((tr().role("row").class("group-row").child(name).child(remove), said));
    }
    let own = memo(move || {
        forms.form.with(|form| {
            let cell = form.parts.get(number).and_then(|part| part.cell(CellKind::Name));
            cell.map(|cell| cell.text.clone()).unwrap_or_default()
        })
    });
    let cell = |kind: &CellKind| {
        let title = title(app, section, *kind);
        let place = td().role("cell").class(format!("of-{kind:?}").to_lowercase()).attr("data-title", title);
        if !shape.cells.contains(kind) {
            return place.class("none");
        }
        let name = move || own.with(|own| format!("{own}: {title}"));
        let is_switch = shape.word == "switch" && *kind == CellKind::Value;
        let field: View = match is_switch {
            true => switch_field(forms, number, name, refusal).into(),
            // If the table is narrow, the column of the labels has no heading.
            false if *kind == CellKind::Label => {
                field(forms, number, *kind, name, refusal).attr("placeholder", title).into()
            }
            false => field(forms, number, *kind, name, refusal).into(),
        };
        let word = (*kind == CellKind::Name && !matches!(shape.word.as_str(), "" | "parameter"))
            .then(|| code().class("word").child(shape.word.clone()));
        place.child(field).maybe(word)
    };
    View::from((tr().role("row").each(columns(section), cell).child(remove), said))
}
