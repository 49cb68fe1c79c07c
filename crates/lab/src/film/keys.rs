//! Keys for navigation in the film.

use super::doubts;
use super::frames::{go, play, step};
use crate::app::App;
use web_sys::KeyboardEvent;

/// Handles arrows, Home, End, Space and the period.
pub fn key(app: App, event: &KeyboardEvent) {
    if event.ctrl_key() || event.alt_key() || event.meta_key() || event.default_prevented() {
        return;
    }
    let far = if event.shift_key() { 10 } else { 1 };
    match event.key().as_str() {
        "ArrowLeft" | "ArrowDown" => step(app, -far),
        "ArrowRight" | "ArrowUp" => step(app, far),
        " " => play(app),
        "Home" => go(app, 0),
        "End" => go(app, usize::MAX),
        "." => doubts::next(app),
        _ => return,
    }
    event.prevent_default();
}
