//! The line of messages at the top of the page, with actions to undo an event or to go to its place. The messages are
//! spoken once through the live region; the line itself is not a live region.

use crate::app::App;
use crate::page::message::{Action, Message};
use crate::views::*;
use crate::{browser, pieces::icons};

/// Removes the messages about the previous document; errors stay.
pub fn leave_document(app: App) {
    app.messages.update(|messages| messages.retain(|message| message.is_error));
}

/// The errors that are shown now.
pub fn errors(app: App) -> Vec<Message> {
    app.messages.with_untracked(|messages| messages.iter().filter(|message| message.is_error).cloned().collect())
}

/// Removes these messages.
pub fn forget(app: App, forgotten: &[Message]) {
    app.messages.update(|messages| messages.retain(|message| !forgotten.contains(message)));
}

/// Undoes the first removal offered by the messages. Returns true if there was one.
pub fn undo(app: App) -> bool {
    let offered = app.messages.with_untracked(|messages| {
        messages.iter().find_map(|message| match message.action {
            Some(Action::Undo(number)) => Some(number),
            _ => None,
        })
    });
    offered.is_some_and(|number| {
        let undone = app.host().undo(number);
        app.acted(false);
        undone
    })
}

/// The messages, newest last.
pub fn view(app: App) -> View {
    changing(move || {
        let messages = app.messages.get_clone();
        if messages.is_empty() {
            return View::new();
        }
        let lines = ul().each(messages, |message| line(app, message));
        section().class("messages").id("messages").attr("aria-label", app.words().messages).child(lines).into()
    })
}

fn line(app: App, message: Message) -> HtmlLi {
    let words = app.words();
    let class = match (message.is_error, &message.action) {
        (true, _) => "message error",
        (false, None) => "message passing",
        // Leaves time to read the message and to reach the button.
        (false, Some(_)) => "message passing slowly",
    };
    let act = message.action.clone().map(|action| {
        let name = match action {
            Action::Undo(_) | Action::Restore(_) => words.undo,
            Action::Show(_) => words.show,
        };
        button().class("quiet").when(events::click, move |_| perform(app, &action)).child(name)
    });
    let (passed, closed) = (message.clone(), message.clone());
    let close = button()
        .class("icon small")
        .called(words.dismiss)
        .when(events::click, move |_| dismiss(app, &closed))
        .child(icons::cross());
    // The timer is a CSS animation: it pauses while the line is hovered or focused.
    li().class(class)
        .when(events::animationend, move |_| remove(app, &passed))
        .child(span().class("words").child(message.text))
        .maybe(act)
        .child(close)
}

fn perform(app: App, action: &Action) {
    match action {
        Action::Undo(_) => {
            undo(app);
            browser::focus_in_place("apparatus");
        }
        Action::Restore(version) => {
            app.host().restore(version);
            app.messages.update(|messages| messages.retain(|message| message.action.as_ref() != Some(action)));
            browser::focus_in_place("apparatus");
        }
        Action::Show(place) => app.host().show(place),
    }
}

/// Removes a message.
pub fn remove(app: App, message: &Message) {
    forget(app, std::slice::from_ref(message));
}

fn dismiss(app: App, message: &Message) {
    remove(app, message);
    browser::focus_in_place("apparatus");
}
