//! Form fields that represent a part of the text: they show it unchanged, and typed text is written back.

use super::typing;
use crate::app::App;
use view::browser;
use view::pieces::icons;
use view::views::*;
use web_sys::{HtmlInputElement, KeyboardEvent};

/// Writes typed text into the document, or returns the reason for refusing it.
pub type Write = Box<dyn Fn(&str) -> Result<(), String>>;

/// A part of the text, in a field.
pub struct Piece {
    /// Id of the field.
    pub id: String,
    /// Accessible name.
    pub name: String,
    /// Present text of the part.
    pub text: ReadSignal<String>,
    /// Reason why the last change was refused.
    pub refusal: Signal<Option<String>>,
    /// Writes typed text into the document.
    pub write: Write,
}

impl Piece {
    /// A field of a single line.
    pub fn line(self, app: App) -> HtmlInput {
        let mut field = input().r#type("text").class("cell").autocomplete("off");
        let node: HtmlInputElement = field.node();
        self.connected(app, node, field)
    }

    /// A field with as many lines as the text.
    pub fn lines(self, app: App) -> HtmlTextarea {
        self.area(app, "cell lines")
    }

    /// A field for prose, with as many lines as the text.
    pub fn prose(self, app: App) -> HtmlTextarea {
        self.area(app, "cell prose-cell")
    }

    fn area(self, app: App, class: &'static str) -> HtmlTextarea {
        let mut field = textarea().class(class);
        // The methods used here are the same as for a single-line input.
        let node: HtmlInputElement = field.node();
        let text = self.text;
        let rows = move || text.with(|text| text.lines().count().max(1).to_string());
        self.connected(app, node, field.attr("rows", rows))
    }

    fn connected<E: Build>(self, app: App, node: HtmlInputElement, field: E) -> E {
        let Self { id, name, text, refusal, write } = self;
        follow(node, text);
        field
            .attr("id", id)
            .attr("spellcheck", "false")
            .attr("autocapitalize", "off")
            .attr("aria-label", name)
            .attr("aria-invalid", move || refusal.with(Option::is_some).then_some("true"))
            .when(events::keydown, move |event| take_back(app, text, &event))
            .when(events::input, move |event| refuse(refusal, write(&value_of(&event)).err()))
    }
}

/// Text of a quantity in a list: its name, and its label if it has one.
pub fn named(name: &str, label: Option<String>) -> String {
    label.map_or_else(|| name.to_owned(), |label| format!("{name}: {label}"))
}

/// A labelled line, in a form for something new.
pub fn new_line(id: &'static str, name: &'static str, field: View) -> HtmlDiv {
    div().class("new-line").child(label().r#for(id).child(name)).child(field)
}

/// Button that opens and closes a form for something new. `open`: true while the form is open; `first`: id of its first
/// field, which is focused when it opens.
pub fn opener(title: &'static str, open: Signal<bool>, first: &'static str) -> HtmlButton {
    let toggle = move |_| {
        open.update(|open| *open = !*open);
        if open.get_untracked() {
            browser::focus_later(first.to_owned());
        }
    };
    labelled(icons::plus(), title).attr("aria-expanded", move || open.get().to_string()).when(events::click, toggle)
}

/// Shows the reason for refusing a change, unless the change has rebuilt the views.
pub fn refuse(refusal: Signal<Option<String>>, why: Option<String>) {
    if refusal.is_alive() {
        refusal.set(why);
    }
}

/// Updates the field whenever the text differs from the typed text by more than surrounding blanks.
pub fn follow(node: HtmlInputElement, text: ReadSignal<String>) {
    effect(move || {
        text.with(|text| {
            if node.value().trim() != text.trim() {
                node.set_value(text);
            }
        });
    });
}

/// Ctrl+Z and Ctrl+Y undo and redo the last change of the document, unless the field contains text that has not been
/// written to it.
pub fn take_back(app: App, text: ReadSignal<String>, event: &KeyboardEvent) {
    let key = event.key().to_lowercase();
    if !(event.ctrl_key() || event.meta_key()) || !matches!(key.as_str(), "z" | "y") {
        return;
    }
    if text.with_untracked(|text| value_of(event).trim() == text.trim()) {
        event.prevent_default();
        typing::undo(app, 0, key == "y" || event.shift_key());
    }
}
