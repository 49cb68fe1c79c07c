//! Recurring elements of the views: buttons, switches, fields, tables, dialogs.

pub(crate) mod colours;
pub mod followed;
pub mod icons;
pub(crate) mod portions;
pub mod sight;
pub(crate) mod steady;
pub mod symbols;
pub(crate) mod toolbar;

use crate::browser;
use crate::views::*;
use std::borrow::Cow;
use web_sys::HtmlDialogElement;

/// A button without default action.
pub fn button() -> HtmlButton {
    tags::button().r#type("button")
}

/// A button with icon and text.
pub fn labelled(icon: SvgSvg, words: &'static str) -> HtmlButton {
    button().class("quiet with-icon").child(icon).child(span().child(words))
}

/// A section of the page. Its heading is visible to screen readers only.
pub fn part(id: &'static str, class: &'static str, title: &'static str) -> HtmlSection {
    let heading = format!("{id}-title");
    section()
        .class(class)
        .id(id)
        .attr("aria-labelledby", heading.clone())
        .child(h2().id(heading).class("visually-hidden").child(title))
}

/// A table in a box with this class, scrollable also by keyboard.
pub fn table_in(
    class: &'static str,
    name: impl Into<Cow<'static, str>>,
    head: Option<HtmlTr>,
    body: HtmlTbody,
) -> HtmlDiv {
    let name: Cow<'static, str> = name.into();
    let table = table()
        .child(caption().class("visually-hidden").child(name.clone()))
        .maybe(head.map(|head| thead().child(head)))
        .child(body);
    div().class(class).tabindex("0").role("region").attr("aria-label", name).child(table)
}

/// A dialog with a title and a close button with this accessible name.
pub fn dialog(id: &'static str, title_id: &'static str, title: &'static str, close: &'static str) -> HtmlDialog {
    let mut dialog = tags::dialog().id(id).attr("aria-labelledby", title_id);
    let node: HtmlDialogElement = dialog.node();
    let close = button()
        .class("icon")
        .attr("aria-label", close)
        .when(events::click, move |_| node.close())
        .child(icons::cross());
    dialog.child(div().class("dialog-head").child(h2().id(title_id).child(title)).child(close))
}

/// A text field for short input.
pub fn short_field(id: String) -> HtmlInput {
    input().r#type("text").class("number").id(id).autocomplete("off").attr("spellcheck", "false")
}

/// A text field for a number. `refused`: reason for which the last text was refused; [`why_refused`] shows it.
pub fn number_field(id: impl Into<String>, refused: Signal<Option<String>>) -> HtmlInput {
    let id: String = id.into();
    let error = format!("{id}-error");
    let is_refused = move || refused.with(Option::is_some);
    short_field(id)
        .enterkeyhint("done")
        .attr("aria-invalid", move || is_refused().then_some("true"))
        .attr("aria-describedby", move || is_refused().then(|| error.clone()))
}

/// The reason for which a [`number_field`] with this id refused its text.
pub fn why_refused(id: &str, refused: Signal<Option<String>>) -> HtmlP {
    refusal_of(refused).id(format!("{id}-error"))
}

/// A check box. If ticking it rebuilds the view, the focus returns to it.
pub fn tick(id: String, ticked: bool, act: impl Fn(bool) + 'static) -> HtmlInput {
    let place = id.clone();
    let ticking = move |event| {
        act(is_checked(&event));
        browser::focus_later(place.clone());
    };
    input().r#type("checkbox").id(id).prop("checked", ticked).when(events::change, ticking)
}

/// A check box with its label.
pub fn switch(tick: HtmlInput, words: impl Into<View>) -> HtmlLabel {
    label().class("switch").child(tick).child(span().child(words))
}

/// A field with its unit.
pub fn with_unit(field: HtmlInput, unit: impl Into<View>) -> HtmlSpan {
    span().class("quantity").child(field).child(unit_of(unit))
}

/// Unit after a field.
pub fn unit_of(unit: impl Into<View>) -> HtmlSpan {
    span().class("unit").child(unit)
}

/// Label before the field with this id.
pub fn field_of(id: impl Into<Cow<'static, str>>, name: impl Into<View>) -> HtmlSpan {
    let id: Cow<'static, str> = id.into();
    span().class("quantity").child(label().r#for(id).child(name))
}

/// A note.
pub fn note(words: impl Into<View>) -> HtmlP {
    p().class("note").child(words)
}

/// Heading of a table row.
pub fn row_head(words: impl Into<View>) -> HtmlTh {
    th().scope("row").child(words)
}

/// Heading of a table column.
pub fn column_head(words: impl Into<View>) -> HtmlTh {
    th().scope("col").child(words)
}

/// A remove button with this accessible name.
pub fn cross(name: String) -> HtmlButton {
    button().class("icon small").called(name).child(icons::cross())
}

/// Paragraph for the reason of a refusal.
pub fn refusal_of(why: Signal<Option<String>>) -> HtmlP {
    p().class("refusal").role("alert").child(text(move || why.get_clone().unwrap_or_default()))
}
