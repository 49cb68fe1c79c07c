//! The line of messages above the transport: what has happened, with a way to undo it or to go there. What is shown here
//! has been spoken once, through the live region; the line itself is none.

use crate::app::App;
use crate::panel::Tab;
use crate::views::*;
use crate::{browser, icons};
use desk::{Announcement, Desk};
use play::Prominence;

/// More errors are not shown at once; the oldest go.
const MOST_ERRORS: usize = 3;

/// What can be done about a message.
#[derive(Clone, PartialEq)]
pub enum Action {
    /// Puts back what the removal of this number took away.
    Undo(u32),
    /// Goes to the element of this id in a tab.
    Show(Tab, String),
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

    /// What is shown of an announcement; `text` is the announcement in words.
    pub fn of(desk: &Desk, announcement: &Announcement, text: &str) -> Option<Self> {
        let action = match announcement {
            Announcement::RecordAdded(_) => {
                desk.newest_record().map(|id| Action::Show(Tab::Measure, format!("record-{id}")))
            }
            Announcement::FitFinished => Some(Action::Show(Tab::Fit, "fit-results".to_owned())),
            other if other.can_be_undone() => desk.undo_number().map(Action::Undo),
            _ => None,
        };
        match announcement.prominence() {
            Prominence::Spoken => None,
            Prominence::Shown => Some(Self { action, ..Self::notice(text.to_owned()) }),
            Prominence::Error => Some(Self::error(text.to_owned())),
        }
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
    offered.is_some_and(|number| app.act_on_desk(|desk| desk.undo(number)))
}

/// The lines, newest last.
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
        // There must be time to read it and to reach the button.
        (false, Some(_)) => "message passing slowly",
    };
    let act = message.action.clone().map(|action| {
        let name = match action {
            Action::Undo(_) => words.undo,
            Action::Show(..) => words.show,
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
        Action::Show(tab, place) => {
            app.tab.set(*tab);
            browser::reveal_later(place.clone());
        }
    }
}

fn remove(app: App, message: &Message) {
    app.messages.update(|messages| messages.retain(|other| other != message));
}

fn dismiss(app: App, message: &Message) {
    remove(app, message);
    browser::focus_in_place("apparatus");
}
