//! The switch *Everything* of the laboratory: with it, the page shows also what teachers and authors need.

use crate::app::App;
use crate::views::*;
use crate::{browser, page::shell};
use play::Embedding;

/// Storage key of the choice.
const KEY: &str = "everything";

/// Sets the switch as the address of the page asks, otherwise as it was left at the last visit; off at first.
pub fn restore(app: App) {
    let left = browser::remembered(KEY).map(|left| left == "on");
    app.everything.set(app.host().embedding().everything.or(left).unwrap_or(false));
}

/// State of the switch for a link: `None` if it is off and nobody has chosen that.
pub fn in_link(app: App) -> Option<bool> {
    let on = app.everything.get_untracked();
    let is_chosen = app.host().embedding().everything.is_some() || browser::remembered(KEY).is_some();
    (on || is_chosen).then_some(on)
}

/// Turns the switch and stores the choice. An address that asks for the other state is changed, for a reload.
pub fn turn(app: App) {
    let on = !app.everything.get_untracked();
    browser::remember(KEY, if on { "on" } else { "off" });
    let embedding = shell::embedding();
    if embedding.everything.is_some() {
        let address =
            Embedding { everything: Some(on), ..embedding }.in_address(&browser::address(&browser::fragment()));
        browser::replace_address(&address);
    }
    app.everything.set(on);
}

/// Shows the content only while everything is shown.
pub fn only(app: App, content: Box<dyn Fn() -> View>) -> View {
    changing(move || if app.everything.get() { content() } else { View::new() })
}
