//! List of the elements in stacking order, the uppermost first.

use super::hand::Hand;
use super::words;
use document::drawing::{Drawing, Item};
use view::views::*;

/// Name of an element in the list: its kind, with its title or text if there is one.
pub fn name(hand: Hand, item: &Item) -> String {
    let kind = item.kind.title.text(hand.app.language.get_untracked()).into_owned();
    hand.text.with(|text| {
        let said = item.says.and_then(|says| text.get(says.range())).map(str::trim).filter(|said| !said.is_empty());
        match said {
            Some(said) if said != kind => format!("{kind}: {said}"),
            _ => kind,
        }
    })
}

/// Collects the children of a frame or group from top to bottom, each followed by its own children: (index, depth,
/// name).
fn downwards(
    hand: Hand,
    drawing: &Drawing,
    (parent, depth): (Option<usize>, usize),
    rows: &mut Vec<(usize, usize, String)>,
) {
    for (number, item) in drawing.items.iter().enumerate().rev().filter(|(_, item)| item.parent == parent) {
        rows.push((number, depth, name(hand, item)));
        downwards(hand, drawing, (Some(number), depth + 1), rows);
    }
}

/// List with a button for each element.
pub fn view(hand: Hand) -> HtmlDiv {
    let words = words::of(hand.app);
    let rows = memo(move || {
        hand.drawing.with(|drawing| {
            let mut rows = Vec::new();
            drawing.iter().for_each(|drawing| downwards(hand, drawing, (None, 0), &mut rows));
            rows
        })
    });
    let row = move |(number, depth, name): (usize, usize, String)| {
        let is_chosen = move || hand.chosen.with(|chosen| chosen.contains(&number)).to_string();
        li().child(
            button()
                .class("quiet layer")
                .id(format!("layer-{number}"))
                .style(format!("padding-left:{}px", 10 + 14 * depth))
                .attr("aria-pressed", is_chosen)
                .when(events::click, move |event| hand.choose(&event, number))
                .child(name),
        )
    };
    let list = move || {
        let rows = rows.get_clone();
        if rows.iter().all(|(_, depth, _)| *depth == 0) && rows.len() <= 1 {
            return View::from(note(words.layers_none));
        }
        ul().class("layers").each(rows, row).into()
    };
    div()
        .class("drawing-layers")
        .role("group")
        .attr("aria-label", words.layers)
        .child(h4().child(words.layers))
        .child(changing(list))
}
