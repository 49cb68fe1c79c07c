//! Drawing editor: a palette of parts, a canvas for placing, resizing and rotating them by pointer or keys, the list in
//! stacking order, and the attributes of the selection. All actions change the text of the scene.

mod acts;
mod canvas;
mod hand;
mod held;
mod inspector;
mod keys;
mod layers;
mod matrix;
mod overlay;
mod palette;
mod picture;
mod pointing;
mod seen;
mod tools;
mod words;

use super::super::typing;
use crate::app::App;
use document::drawing::read;
use hand::Hand;
use view::views::*;

/// The drawing editor.
pub fn view(app: App) -> HtmlDiv {
    let text = memo(move || {
        app.typed.track();
        app.written.track();
        typing::text(app, 0)
    });
    let drawing = memo(move || text.with(|text| read(&document::read(text))));
    let hand = Hand {
        app,
        text,
        drawing,
        chosen: create_signal(Vec::new()),
        grid: create_signal(true),
        seen: create_signal(None),
        pointed: create_signal(None),
        held: create_signal(None),
        refusal: create_signal(None),
    };
    let exists = memo(move || drawing.with(Option::is_some));
    let content = move || if exists.get() { drawn(hand) } else { begin(hand) };
    // Elements that no longer exist cannot stay selected.
    effect(move || {
        let count = drawing.with(|drawing| drawing.as_ref().map_or(0, |drawing| drawing.items.len()));
        if hand.chosen.with_untracked(|chosen| chosen.iter().any(|number| *number >= count)) {
            hand.chosen.set(Vec::new());
        }
    });
    div().class("drawing-form").child(changing(content))
}

fn drawn(hand: Hand) -> View {
    let palette_open = create_signal(false);
    View::from((
        tools::view(hand, palette_open),
        palette::view(hand, palette_open),
        canvas::view(hand),
        refusal_of(hand.refusal),
        div().class("drawing-lists").child(inspector::view(hand)).child(layers::view(hand)),
    ))
}

/// Content for a document without a scene.
fn begin(hand: Hand) -> View {
    let words = words::of(hand.app);
    let add = button()
        .class("quiet outlined")
        .id("drawing-begin")
        .when(events::click, move |_| acts::begin(hand))
        .child(words.begin);
    View::from((note(words.nothing), div().class("form-tools").child(add), refusal_of(hand.refusal)))
}
