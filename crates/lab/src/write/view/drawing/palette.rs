//! Palette of all elements that can be drawn.

use super::hand::Hand;
use super::{acts, words};
use document::drawing::{Part, drawable};
use view::pieces::icons;
use view::views::*;

/// Button that opens the palette.
pub fn button_of(hand: Hand, open: Signal<bool>) -> HtmlButton {
    labelled(icons::plus(), words::of(hand.app).add)
        .id("drawing-add")
        .attr("aria-expanded", move || open.get().to_string())
        .attr("aria-controls", "drawing-palette")
        .when(events::click, move |_| open.set(!open.get_untracked()))
}

/// Palette with a button for each kind of element.
pub fn view(hand: Hand, open: Signal<bool>) -> HtmlDiv {
    let language = hand.app.language.get_untracked();
    let one = move |kind: &'static Part| {
        let add = move |_| {
            open.set(false);
            acts::add(hand, kind);
        };
        let name = kind.title.text(language).into_owned();
        button().class("quiet").attr("data-part", kind.name).when(events::click, add).child(name)
    };
    div()
        .class("drawing-palette")
        .id("drawing-palette")
        .role("group")
        .attr("aria-label", words::of(hand.app).palette)
        .hidden(move || !open.get())
        .each(drawable(), one)
}
