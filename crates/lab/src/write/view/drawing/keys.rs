//! Keyboard on the canvas.

use super::acts;
use super::hand::Hand;
use crate::write::typing;
use web_sys::KeyboardEvent;

/// Handles a pressed key.
pub fn pressed(hand: Hand, event: &KeyboardEvent) {
    let key = event.key();
    let far = if event.shift_key() { 10.0 } else { 1.0 };
    let with_control = event.ctrl_key() || event.meta_key();
    match (key.as_str(), with_control) {
        ("ArrowLeft", false) => acts::step(hand, [-far, 0.0]),
        ("ArrowRight", false) => acts::step(hand, [far, 0.0]),
        ("ArrowUp", false) => acts::step(hand, [0.0, -far]),
        ("ArrowDown", false) => acts::step(hand, [0.0, far]),
        ("PageDown", false) => next(hand, 1),
        ("PageUp", false) => next(hand, -1),
        ("Delete" | "Backspace", false) => acts::remove(hand),
        ("Escape", false) if hand.chosen.with_untracked(|chosen| !chosen.is_empty()) => hand.chosen.set(Vec::new()),
        ("d" | "D", true) => acts::copy(hand),
        ("z" | "Z", true) => typing::undo(hand.app, 0, event.shift_key()),
        ("y" | "Y", true) => typing::undo(hand.app, 0, true),
        _ => return,
    }
    event.prevent_default();
    event.stop_propagation();
}

/// Selects the next or previous element of the text, cyclically.
fn next(hand: Hand, by: isize) {
    let drawing = hand.drawing.get_clone_untracked();
    let items = drawing.iter().flat_map(|drawing| drawing.items.iter().enumerate());
    let all: Vec<usize> = items.filter(|(_, item)| !item.is_frame()).map(|(number, _)| number).collect();
    let now = hand.chosen.with_untracked(|chosen| chosen.first().copied());
    let place = now.and_then(|now| all.iter().position(|number| *number == now));
    let count = all.len() as isize;
    let place =
        place.map_or(if by > 0 { 0 } else { count - 1 }, |place| (place as isize + by).rem_euclid(count.max(1)));
    if let Some(number) = usize::try_from(place).ok().and_then(|place| all.get(place)) {
        hand.chosen.set(vec![*number]);
        if let Some(item) = drawing.and_then(|drawing| drawing.items.get(*number).cloned()) {
            hand.app.say(super::layers::name(hand, &item));
        }
    }
}
