//! Single-key shortcuts. They act only while the focus is on the stage, on its controls or nowhere, and no text is
//! being typed. They can be switched off (WCAG 2.2, 2.1.4).

use crate::app::App;
use crate::views::*;
use crate::{browser, page::messages, views};
use play::{Play, SPEEDS};
use std::cell::Cell;
use std::rc::Rc;
use wasm_bindgen::JsCast;
use web_sys::{Element, Event, HtmlDialogElement, HtmlElement, KeyboardEvent};

/// Elements that handle keys themselves.
const TAKES_TEXT: &str = "input:not([type=range]):not([type=checkbox]), textarea, select, [contenteditable]";
const TAKES_SPACE: &str = "button, a, summary, input:not([type=range]), [role=tab]";

/// State of the keyboard and pointer input.
#[derive(Default)]
struct Hands {
    /// True if a pointer was pressed since the last Tab: the focus then comes from a click, and Space controls the
    /// transport.
    points: Cell<bool>,
    /// True if Space was used for the transport: its release must not trigger the focused button.
    holds_space: Cell<bool>,
}

/// Installs the listeners, which live as long as the page.
pub fn listen(app: App) {
    let hands = Rc::new(Hands::default());
    let (pointing, released) = (hands.clone(), hands.clone());
    browser::listen("pointerdown", move |_: &Event| pointing.points.set(true));
    browser::listen("keydown", move |event| pressed(app, &hands, event));
    browser::listen("keyup", move |event: &KeyboardEvent| {
        if event.key() == " " && released.holds_space.take() {
            event.prevent_default();
        }
    });
}

fn pressed(app: App, hands: &Hands, event: &KeyboardEvent) {
    if event.key() == "Tab" {
        hands.points.set(false);
    }
    if event.key() == "Escape" && app.projecting.get_untracked() && !event.default_prevented() {
        app.projecting.set(false);
        event.prevent_default();
        return;
    }
    // In a text field, the browser undoes the typing.
    let undoes = (event.ctrl_key() || event.meta_key()) && !event.shift_key() && !event.alt_key() && event.key() == "z";
    let typing = event
        .target()
        .and_then(|target| target.dyn_into::<Element>().ok())
        .is_some_and(|target| target.matches(TAKES_TEXT).unwrap_or_default());
    if undoes && !typing && messages::undo(app) {
        event.prevent_default();
        return;
    }
    let modified = event.ctrl_key() || event.alt_key() || event.meta_key() || event.default_prevented();
    if modified || !app.single_keys.get_untracked() {
        return;
    }
    let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
    let within = |selector: &str| target.as_ref().and_then(|target| target.closest(selector).ok().flatten()).is_some();
    let nowhere = target.as_ref().is_none_or(|target| matches!(target.tag_name().as_str(), "BODY" | "HTML"));
    let is_space = event.key() == " ";
    let clicked = is_space && hands.points.get() && within(TAKES_SPACE);
    if !(nowhere || clicked || within("#apparatus, #panel-explore, #tab-explore"))
        || within("dialog")
        || within(TAKES_TEXT)
    {
        return;
    }
    match event.key().as_str() {
        " " if clicked || !within(TAKES_SPACE) => {
            hands.holds_space.set(true);
            // Ignores the repetition of a held key.
            if !event.repeat() {
                toggle(app, target.filter(|_| clicked));
            }
        }
        "k" | "K" => app.act(|play| play.change_run(|line, _| line.toggle())),
        "r" | "R" => app.act(|play| play.change_run(|line, basis| line.back_to_start(basis))),
        "," => app.act(|play| play.change_run(|line, _| line.step_back())),
        "." => app.act(|play| play.change_run(|line, _| line.step_forward())),
        "<" => app.act(|play| change_speed(play, false)),
        ">" => app.act(|play| change_speed(play, true)),
        "s" | "S" => {
            if let Some(refusal) = app.attempt(|play| play.change_run(|line, basis| line.keep(basis))) {
                app.complain(refusal);
            }
        }
        "?" => open(),
        _ => return,
    }
    event.prevent_default();
}

/// Toggles play and pause of the transport that contains the clicked element, otherwise of the simulation.
fn toggle(app: App, clicked: Option<Element>) {
    let transport = clicked.and_then(|clicked| clicked.closest(".transport").ok().flatten());
    let own = transport.and_then(|transport| transport.query_selector("button.play").ok().flatten());
    match own.and_then(|button| button.dyn_into::<HtmlElement>().ok()) {
        Some(button) => button.click(),
        None => app.act(|play| play.change_run(|line, _| line.toggle())),
    }
}

fn change_speed(play: &mut Play, faster: bool) {
    let now = play.time_line().speed();
    let next = if faster {
        SPEEDS.iter().find(|&&speed| speed > now)
    } else {
        SPEEDS.iter().rev().find(|&&speed| speed < now)
    };
    if let Some(&speed) = next {
        play.change_run(|line, _| line.set_speed(speed));
    }
}

/// Opens the list of keys.
pub fn open() {
    if let Some(dialog) = browser::by_id::<HtmlDialogElement>("keys") {
        let _ = dialog.show_modal();
    }
}

/// The list of keys, with the switch for single-key shortcuts.
pub fn dialog(app: App) -> HtmlDialog {
    let words = app.words();
    let groups = [
        (
            words.keys_anywhere,
            vec![
                (vec![words.key_space, "K"], words.key_play),
                (vec![",", "."], words.key_step),
                (vec!["R"], words.back_to_start),
                (vec!["<", ">"], words.key_speed),
                (vec!["S"], words.key_keep),
                (vec!["Esc"], words.key_projector),
                (vec!["Ctrl Z"], words.key_undo),
                (vec!["?"], words.key_help),
            ],
        ),
        (words.keys_scene, vec![(vec!["↑", "↓", "←", "→"], words.key_handle)]),
        (
            words.keys_plot,
            vec![
                (vec!["←", "→"], words.key_cursor),
                (vec!["+", "−"], words.key_zoom),
                (vec!["↑", "↓", "←", "→"], words.key_pan),
                (vec!["Enter", "Esc"], words.key_pin),
                (vec!["0"], words.key_fit),
            ],
        ),
    ];
    let line = |(keys, meaning): (Vec<&'static str>, &'static str)| {
        div().child(dt().each(keys, |key| kbd().child(key))).child(dd().child(meaning))
    };
    let turn = move |event| {
        let on = is_checked(&event);
        app.single_keys.set(on);
        browser::remember("keys", if on { "" } else { "off" });
    };
    let tick = input()
        .r#type("checkbox")
        .id("single-keys")
        .prop("checked", move || app.single_keys.get())
        .when(events::change, turn);
    views::dialog("keys", "keys-title", words.keys_title, words.close)
        .child(switch(tick, words.keys_switch))
        .child(p().child(words.keys_where))
        .each(groups, |(title, keys)| View::from((h3().child(title), dl().each(keys, line))))
}
