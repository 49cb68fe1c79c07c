//! Fields of forms that stand for a piece of the text: they show it as it is there, and what is typed goes into the text.

use super::typing;
use crate::app::App;
use view::views::*;
use web_sys::{HtmlInputElement, KeyboardEvent};

/// Writes what was typed into the text, or says why not.
pub type Write = Box<dyn Fn(&str) -> Result<(), String>>;

/// A piece of the text in a field.
pub struct Piece {
    /// The id of the field.
    pub id: String,
    /// What it is called, for those who do not see what stands around it.
    pub name: String,
    /// The piece as it stands in the text.
    pub text: ReadSignal<String>,
    /// Why the last change was refused.
    pub refusal: Signal<Option<String>>,
    /// Writes what was typed into the text.
    pub write: Write,
}

impl Piece {
    /// A field in one line.
    pub fn line(self, app: App) -> HtmlInput {
        let mut field = input().r#type("text").class("cell").autocomplete("off");
        let node: HtmlInputElement = field.node();
        self.connected(app, node, field)
    }

    /// A field of as many lines as the text has.
    pub fn lines(self, app: App) -> HtmlTextarea {
        self.area(app, "cell lines")
    }

    /// The same for words.
    pub fn prose(self, app: App) -> HtmlTextarea {
        self.area(app, "cell prose-cell")
    }

    fn area(self, app: App, class: &'static str) -> HtmlTextarea {
        let mut field = textarea().class(class);
        // Its methods are those of an input of one line, as far as they are needed here.
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

/// A quantity in a list to choose from: its name, and its label if it has one.
pub fn named(name: &str, label: Option<String>) -> String {
    label.map_or_else(|| name.to_owned(), |label| format!("{name}: {label}"))
}

/// A field of this id under its name, in a form for something new.
pub fn new_line(id: &'static str, name: &'static str, field: View) -> HtmlDiv {
    div().class("new-line").child(label().r#for(id).child(name)).child(field)
}

/// Says why a change was refused, unless the change has built the views again that say it.
pub fn refuse(refusal: Signal<Option<String>>, why: Option<String>) {
    if refusal.is_alive() {
        refusal.set(why);
    }
}

/// Shows the text in the field whenever it differs by more than blanks from what is typed there.
pub fn follow(node: HtmlInputElement, text: ReadSignal<String>) {
    effect(move || {
        text.with(|text| {
            if node.value().trim() != text.trim() {
                node.set_value(text);
            }
        });
    });
}

/// Control with Z takes back the last change of the document, unless something is typed that is not in it.
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
