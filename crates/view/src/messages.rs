//! The line of messages above the transport: what has happened, with a way to undo it or to go there. What is shown here
//! has been spoken once, through the live region; the line itself is none.

use crate::app::App;
use crate::views::*;
use crate::{browser, icons};
use play::Prominence;

/// More errors are not shown at once; the oldest go.
const MOST_ERRORS: usize = 3;

/// What can be done about a message.
#[derive(Clone, PartialEq)]
pub enum Action {
    /// Puts back what the removal of this number took away.
    Undo(u32),
    /// Goes to the element of this id.
    Show(String),
}

/// A line.
#[derive(Clone, PartialEq)]
pub struct Message {
    text: String,
    /// An error stays until it is dismissed; anything else fades, and the next one takes its place.
    is_error: bool,
    action: Option<Action>,
}

impl Message {
    /// Something that went well.
    pub fn notice(text: String) -> Self {
        Self { text, is_error: false, action: None }
    }

    /// Something that did not.
    pub fn error(text: String) -> Self {
        Self { text, is_error: true, action: None }
    }

    /// Words as they are shown; nothing of what is only spoken.
    pub fn new(prominence: Prominence, words: &str) -> Option<Self> {
        match prominence {
            Prominence::Spoken => None,
            Prominence::Shown => Some(Self::notice(words.to_owned())),
            Prominence::Error => Some(Self::error(words.to_owned())),
        }
    }

    /// The message with a button that puts back what was removed, where there is a number of that removal.
    pub fn undone_by(self, number: Option<u32>) -> Self {
        Self { action: number.map(Action::Undo).or(self.action), ..self }
    }

    /// The message with a button that goes to the element of this id.
    pub fn leading_to(self, place: String) -> Self {
        Self { action: Some(Action::Show(place)), ..self }
    }
}

/// Shows a message.
pub fn show(app: App, message: Message) {
    app.messages.update(|messages| {
        messages.retain(|other| other.is_error && *other != message);
        if message.is_error && messages.len() >= MOST_ERRORS {
            messages.remove(0);
        }
        messages.push(message);
    });
}

/// Takes away what refers to the document that was open before.
pub fn leave_document(app: App) {
    app.messages.update(|messages| messages.retain(|message| message.is_error));
}

/// Undoes what the line offers to undo.
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

/// The lines, newest last.
pub fn view(app: App) -> View {
    changing(move || {
        let messages = app.messages.get_clone();
        // Of the root, not asked with `:has()`: that would be asked again of the whole page for each text that changes.
        if let Some(root) = document().document_element() {
            let _ = root.class_list().toggle_with_force("with-messages", !messages.is_empty());
        }
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
        // There must be time to read it and to reach the button.
        (false, Some(_)) => "message passing slowly",
    };
    let act = message.action.clone().map(|action| {
        let name = match action {
            Action::Undo(_) => words.undo,
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
    // The style sheet's animation is the clock: it stops while the line is hovered or has the focus.
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
        Action::Show(place) => app.host().show(place),
    }
}

fn remove(app: App, message: &Message) {
    app.messages.update(|messages| messages.retain(|other| other != message));
}

fn dismiss(app: App, message: &Message) {
    remove(app, message);
    browser::focus_in_place("apparatus");
}
