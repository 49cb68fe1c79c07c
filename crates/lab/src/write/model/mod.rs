//! The model of the document as forms: description, tables of parameters and initial values, equations beside their
//! typeset form, and cards for events, choices and tables. Each cell changes its place in the text.

mod cell;
mod description;
mod fault;
mod faults;
mod forms;
mod removal;
mod shape;
mod statement;
mod table;

use super::typing;
use crate::app::App;
use document::edit::add_statement;
use document::form::{CellKind, Form, Section, proposal, read};
pub use fault::beside;
use forms::Forms;
use shape::{Shape, shape, title};
use view::browser;
use view::pieces::icons;
use view::views::*;

/// Panel of the model.
pub fn view(app: App) -> View {
    let form = memo(move || {
        app.typed.track();
        app.written.track();
        read(&document::read(&typing::text(app, 0)))
    });
    let forms = Forms { app, form, faults: fault::of(app), typing: create_signal(false) };
    let mut last: Vec<Shape> = Vec::new();
    let shapes = memo(move || {
        let now: Vec<Shape> = forms.form.with(|form| form.parts.iter().map(shape).collect());
        if !(forms.typing.get() && now.len() == last.len()) {
            last = now;
        }
        last.clone()
    });
    let sections = move || {
        let shapes = shapes.get_clone();
        let numbered = |section: Section| -> Vec<(usize, Shape)> {
            shapes.iter().cloned().enumerate().filter(|(_, shape)| shape.section == section).collect()
        };
        let section = |one: Section| section_of(forms, one, numbered(one));
        let (shown, empty): (Vec<Section>, Vec<Section>) =
            Section::ALL.into_iter().partition(|one| *one <= Section::Equations || !numbered(*one).is_empty());
        let more = (!empty.is_empty()).then(|| div().class("form-tools").each(empty, |one| add_button(forms, one)));
        div().class("forms").each(shown, section).maybe(more)
    };
    View::from((typing::undo_buttons(app), description::view(app), changing(sections)))
}

/// A section: heading, content, and a button that adds a statement.
fn section_of(forms: Forms, section: Section, parts: Vec<(usize, Shape)>) -> HtmlSection {
    let id = format!("form-{section:?}").to_lowercase();
    let is_row = |shape: &Shape| shape.cells.first() != Some(&CellKind::Text);
    let (rows, others): (Vec<_>, Vec<_>) = parts.into_iter().partition(|(_, shape)| is_row(shape));
    let rows = (!rows.is_empty()).then(|| table::view(forms, section, rows));
    tags::section()
        .class("form-section")
        .attr("aria-labelledby", id.clone())
        .child(h3().id(id).child(title(forms.app, section)))
        .maybe(rows)
        .each(others, |(number, shape)| statement::view(forms, number, shape.has_lines))
        .child(add_button(forms, section))
}

fn add_button(forms: Forms, section: Section) -> HtmlButton {
    let words = forms.app.words();
    let name = match section {
        Section::Parameters => words.add_parameter,
        Section::InitialValues => words.add_initial_value,
        Section::Equations => words.add_equation,
        Section::Events => words.add_event,
        Section::Choices => words.add_choice,
        Section::Tables => words.add_table,
    };
    labelled(icons::plus(), name).when(events::click, move |_| add(forms, section))
}

/// Adds a statement to a section and moves the focus to it.
fn add(forms: Forms, section: Section) {
    let app = forms.app;
    let text = typing::text(app, 0);
    let added = typing::act(app, 0, &text, |outline| {
        add_statement(outline, section, &proposal(outline, section)).map(|edit| vec![edit])
    });
    match added {
        Ok(edits) => {
            let start = edits.first().map_or(0, |edit| edit.span.start);
            let place = |form: &Form| form.parts.iter().position(|part| part.span.start >= start);
            if let Some((number, kind)) = forms.form.with_untracked(|form| {
                let number = place(form)?;
                Some((number, form.parts.get(number)?.cells.first()?.kind))
            }) {
                browser::focus_later(cell::id(number, kind));
            }
        }
        Err(refusal) => app.complain(refusal),
    }
}
