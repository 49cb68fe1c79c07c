//! Buttons above the canvas.

use super::acts::{self, Edge};
use super::hand::Hand;
use super::{palette, words};
use document::edit::Order;
use view::pieces::icons;
use view::views::*;

/// All buttons; those without applicable selection are disabled. The first one opens the palette.
pub fn view(hand: Hand, open: Signal<bool>) -> HtmlDiv {
    let words = words::of(hand.app);
    let count = memo(move || hand.chosen.with(Vec::len));
    let act = |id: &'static str, (icon, name): (SvgSvg, &'static str), act: fn(Hand), several: bool| {
        button()
            .class("icon")
            .id(id)
            .called(name)
            .prop("disabled", move || count.get() == 0 || !several && count.get() > 1)
            .when(events::click, move |_| act(hand))
            .child(icon)
    };
    let grid = button()
        .class("icon")
        .id("drawing-grid")
        .called(words.snap)
        .attr("aria-pressed", move || hand.grid.get().to_string())
        .when(events::click, move |_| hand.grid.set(!hand.grid.get_untracked()))
        .child(icons::grid());
    let forward = |hand| acts::reorder(hand, Order::Forward);
    let backward = |hand| acts::reorder(hand, Order::Backward);
    div()
        .class("drawing-tools")
        .child(palette::button_of(hand, open))
        .child(act("drawing-copy", (icons::copy(), words.copy), acts::copy, false))
        .child(act("drawing-remove", (icons::bin(), words.remove), acts::remove, true))
        .child(act("drawing-forward", (icons::forward(), words.forward), forward, false))
        .child(act("drawing-backward", (icons::backward(), words.backward), backward, false))
        .child(align(hand))
        .child(grid)
}

/// Buttons that align several elements by their edges.
fn align(hand: Hand) -> View {
    let words = words::of(hand.app);
    let edges = [
        (Edge::Left, words.align_left),
        (Edge::Centre, words.align_centre),
        (Edge::Right, words.align_right),
        (Edge::Top, words.align_top),
        (Edge::Middle, words.align_middle),
        (Edge::Bottom, words.align_bottom),
    ];
    let several = memo(move || hand.chosen.with(|chosen| chosen.len() > 1));
    changing(move || {
        if !several.get() {
            return View::new();
        }
        let mut field = select().class("cell").id("drawing-align").attr("aria-label", words.align);
        let node: web_sys::HtmlSelectElement = field.node();
        let chosen = move |_| {
            let number: Option<usize> = node.value().parse().ok();
            if let Some((edge, _)) = number.and_then(|number| edges.get(number)) {
                acts::align(hand, *edge);
            }
            node.set_value("");
        };
        let choices = edges.into_iter().enumerate();
        field
            .child(option().value("").child(words.align))
            .each(choices, |(number, (_, name))| option().value(number.to_string()).child(name))
            .when(events::change, chosen)
            .into()
    })
}
