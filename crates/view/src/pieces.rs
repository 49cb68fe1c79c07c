//! Pieces that recur in the views: buttons, switches, fields, tables, dialogs.

use crate::views::*;
use crate::{browser, icons};
use std::borrow::Cow;
use web_sys::HtmlDialogElement;

/// A button that does nothing of its own.
pub fn button() -> HtmlButton {
    tags::button().r#type("button")
}

/// A button with an icon and words.
pub fn labelled(icon: SvgSvg, words: &'static str) -> HtmlButton {
    button().class("quiet with-icon").child(icon).child(span().child(words))
}

/// A part of the page. Its heading is only heard: those who see it know it by its look.
pub fn part(id: &'static str, class: &'static str, title: &'static str) -> HtmlSection {
    let heading = format!("{id}-title");
    section()
        .class(class)
        .id(id)
        .attr("aria-labelledby", heading.clone())
        .child(h2().id(heading).class("visually-hidden").child(title))
}

/// A table in a box of this class in which it can be scrolled, also by keys.
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

/// A dialog with its title, and a button of this name that closes it.
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

/// A field to type something short into.
pub fn short_field(id: String) -> HtmlInput {
    input().r#type("text").class("number").id(id).autocomplete("off").attr("spellcheck", "false")
}

/// A box to tick. A view that is rebuilt by ticking it gives the focus back to its place.
pub fn tick(id: String, ticked: bool, act: impl Fn(bool) + 'static) -> HtmlInput {
    let place = id.clone();
    let ticking = move |event| {
        act(is_checked(&event));
        browser::focus_later(place.clone());
    };
    input().r#type("checkbox").id(id).prop("checked", ticked).when(events::change, ticking)
}

/// A box to tick, with its words.
pub fn switch(tick: HtmlInput, words: impl Into<View>) -> HtmlLabel {
    label().class("switch").child(tick).child(span().child(words))
}

/// A field with its unit.
pub fn with_unit(field: HtmlInput, unit: impl Into<View>) -> HtmlSpan {
    span().class("quantity").child(field).child(unit_of(unit))
}

/// The unit behind a field.
pub fn unit_of(unit: impl Into<View>) -> HtmlSpan {
    span().class("unit").child(unit)
}

/// Before a field of this id: what it is called.
pub fn field_of(id: impl Into<Cow<'static, str>>, name: impl Into<View>) -> HtmlSpan {
    let id: Cow<'static, str> = id.into();
    span().class("quantity").child(label().r#for(id).child(name))
}

/// A remark.
pub fn note(words: impl Into<View>) -> HtmlP {
    p().class("note").child(words)
}

/// What heads a row of a table.
pub fn row_head(words: impl Into<View>) -> HtmlTh {
    th().scope("row").child(words)
}

/// What heads a column of a table.
pub fn column_head(words: impl Into<View>) -> HtmlTh {
    th().scope("col").child(words)
}

/// The cross that takes something away; the name says what.
pub fn cross(name: String) -> HtmlButton {
    button().class("icon small").called(name).child(icons::cross())
}

/// A place where it is said why something was not done.
pub fn refusal_of(why: Signal<Option<String>>) -> HtmlP {
    p().class("refusal").role("alert").child(text(move || why.get_clone().unwrap_or_default()))
}
