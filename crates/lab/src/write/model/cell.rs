//! A cell: a field for the text at its place in the document.

use super::fault;
use super::forms::{Forms, Refusal};
use crate::write::fields::{follow, take_back};
use crate::write::{insight, typing};
use document::edit::{set_cell, set_name};
use document::form::CellKind;
use view::views::*;
use web_sys::{Event, HtmlInputElement};

/// Id of a field.
pub fn id(number: usize, kind: CellKind) -> String {
    format!("cell-{number}-{kind:?}").to_lowercase()
}

/// Common behaviour of all fields: text, writing, error state.
struct Behaviour {
    forms: Forms,
    number: usize,
    kind: CellKind,
    refusal: Refusal,
}

impl Behaviour {
    fn text(&self) -> ReadSignal<String> {
        let (form, number, kind) = (self.forms.form, self.number, self.kind);
        memo(move || {
            form.with(|form| {
                let cell = form.parts.get(number).and_then(|part| part.cell(kind));
                cell.map(|cell| cell.text.clone()).unwrap_or_default()
            })
        })
    }

    fn is_wrong(&self) -> impl Fn() -> Option<&'static str> + use<> {
        let (faults, number, kind, refusal) = (self.forms.faults, self.number, self.kind, self.refusal);
        move || {
            let found = faults.with(|faults| faults.iter().any(|fault| fault.is_of(number, kind) && fault.is_error()));
            let refused = refusal.with(|refusal| refusal.as_ref().is_some_and(|(refused, _)| *refused == kind));
            (found || refused).then_some("true")
        }
    }

    /// Writes typed text into the document.
    fn write(&self, typed: &str) {
        let Self { forms, number, kind, refusal } = *self;
        let written = if kind == CellKind::Name {
            typing::change_all(forms.app, |outline, translations| set_name(outline, number, typed, translations))
        } else {
            let text = typing::text(forms.app, 0);
            typing::change(forms.app, 0, &text, |outline| set_cell(outline, number, kind, typed)).map(|_| ())
        };
        refusal.set(written.err().map(|why| (kind, why)));
    }
}

/// Shows the help for the word under the cursor of a field.
fn explains<E: Build>(own: &Behaviour, node: HtmlInputElement, field: E) -> E {
    let Behaviour { forms, number, kind, .. } = *own;
    let look = move || {
        let place = node.selection_start().ok().flatten().unwrap_or(0);
        insight::look_at_cell(forms.app, number, kind, place as usize);
    };
    let (focused, pressed) = (look.clone(), look.clone());
    field
        .when(events::keyup, move |_| look())
        .when(events::focusin, move |_| focused())
        .when(events::click, move |_| pressed())
}

/// A single-line field with its accessible name. A changed name is replaced everywhere, once complete.
pub fn field(
    forms: Forms,
    number: usize,
    kind: CellKind,
    name: impl Fn() -> String + 'static,
    refusal: Refusal,
) -> HtmlInput {
    let own = Behaviour { forms, number, kind, refusal };
    let (text, is_wrong) = (own.text(), own.is_wrong());
    let mut field = input().r#type("text").class("cell").id(id(number, kind)).autocomplete("off");
    let node: HtmlInputElement = field.node();
    follow(node.clone(), text);
    let field = explains(&own, node, field)
        .attr("spellcheck", if kind == CellKind::Label { "true" } else { "false" })
        .attr("autocapitalize", "off")
        .attr("aria-label", name)
        .attr("aria-describedby", fault::id(number))
        .attr("aria-invalid", is_wrong)
        .when(events::keydown, move |event| take_back(forms.app, text, &event));
    let write = move |event: Event| own.write(&value_of(&event));
    if kind == CellKind::Name {
        return field.when(events::change, write);
    }
    let field = if kind == CellKind::Text { rests(forms, field) } else { field };
    field.when(events::input, write)
}

/// A field of several lines.
pub fn lines(forms: Forms, number: usize, name: String, refusal: Refusal) -> HtmlTextarea {
    let kind = CellKind::Text;
    let own = Behaviour { forms, number, kind, refusal };
    let (text, is_wrong) = (own.text(), own.is_wrong());
    let mut field = textarea().class("cell lines").id(id(number, kind));
    // The methods used here are the same as for a single-line input.
    let node: HtmlInputElement = field.node();
    follow(node.clone(), text);
    let rows = move || text.with(|text| (text.lines().count() + 1).to_string());
    rests(forms, explains(&own, node, field))
        .attr("rows", rows)
        .attr("spellcheck", "false")
        .attr("autocapitalize", "off")
        .attr("aria-label", name)
        .attr("aria-describedby", fault::id(number))
        .attr("aria-invalid", is_wrong)
        .when(events::keydown, move |event| take_back(forms.app, text, &event))
        .when(events::input, move |event| own.write(&value_of(&event)))
}

/// Selection between on and off.
pub fn switch_field(forms: Forms, number: usize, name: impl Fn() -> String + 'static, refusal: Refusal) -> HtmlSelect {
    let own = Behaviour { forms, number, kind: CellKind::Value, refusal };
    let text = own.text();
    let words = forms.app.words();
    let option = move |(value, others, name): (&'static str, [&'static str; 2], &'static str)| {
        let selected = move || text.with(|text| others.contains(&text.as_str()));
        option().value(value).prop("selected", selected).child(name)
    };
    select()
        .class("cell")
        .id(id(number, CellKind::Value))
        .attr("aria-label", name)
        .each([("on", ["on", "true"], words.switch_on), ("off", ["off", "false"], words.switch_off)], option)
        .when(events::change, move |event| own.write(&value_of(&event)))
}

/// While a statement is being typed, it keeps its place in the form, even if its kind changes.
fn rests<E: Build>(forms: Forms, field: E) -> E {
    field.when(events::focus, move |_| forms.typing.set(true)).when(events::blur, move |_| forms.typing.set(false))
}
