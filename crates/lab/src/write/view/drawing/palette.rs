//! The palette: all that can be drawn, by its name.

use super::{Hand, acts, words};
use document::drawing::drawable;
use view::icons;
use view::views::*;

/// A button that shows them, and a button for each.
pub fn view(hand: Hand) -> HtmlDiv {
    let words = words::of(hand.app);
    let open = create_signal(false);
    let language = hand.app.language.get_untracked();
    let show = labelled(icons::plus(), words.add)
        .id("drawing-add")
        .attr("aria-expanded", move || open.get().to_string())
        .attr("aria-controls", "drawing-palette")
        .when(events::click, move |_| open.set(!open.get_untracked()));
    let one = move |kind: document::drawing::Part| {
        let add = move |_| {
            open.set(false);
            acts::add(hand, kind);
        };
        let name = kind.title().text(language).to_owned();
        button().class("quiet").attr("data-part", kind.name).when(events::click, add).child(name)
    };
    let all = div()
        .class("drawing-palette")
        .id("drawing-palette")
        .role("group")
        .attr("aria-label", words.palette)
        .hidden(move || !open.get())
        .each(drawable(), one);
    div().class("drawing-add").child(show).child(all)
}
