//! Actions on the drawing. Each changes the text and keeps the selection.

use super::hand::Hand;
use super::seen::{Seen, SeenItem};
use crate::write::typing;
use document::Outline;
use document::drawing::{Axis, Drawing, Grip, Part};
use document::edit::{
    EditError, Measure, Order, add_element, add_scene, duplicate_element, follow, remove_elements, reorder_element,
    set_attribute, set_text, shift,
};
use model::Edit;
use view::browser;

/// Steps of rotation angles in degrees: with the grid, and without it.
const TURNS: [f64; 2] = [15.0, 1.0];

/// Edge by which several elements are aligned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edge {
    /// Left edges.
    Left,
    /// Vertical centre lines.
    Centre,
    /// Right edges.
    Right,
    /// Upper edges.
    Top,
    /// Horizontal centre lines.
    Middle,
    /// Lower edges.
    Bottom,
}

/// Changes the text. Returns true on success; the reason for a refusal is shown.
fn change(hand: Hand, edit: impl FnOnce(&Outline) -> Result<Vec<Edit>, EditError>) -> bool {
    let text = typing::text(hand.app, 0);
    let done = typing::act(hand.app, 0, &text, edit);
    let is_done = done.is_ok();
    hand.refusal.set(done.err());
    is_done
}

/// Begins a drawing.
pub fn begin(hand: Hand) {
    let language = hand.app.language.get_untracked();
    let title = hand.app.read(|play| play.program().edition(language.tag()).title.clone());
    if change(hand, |outline| add_scene(outline, &title).map(|edit| vec![edit])) {
        browser::focus_later("drawing-canvas".to_owned());
    }
}

/// Adds an element at the place of the last click, otherwise at the centre of the view; shifted if elements are there.
pub fn add(hand: Hand, kind: &'static Part) {
    let Some(seen) = hand.seen.get_clone_untracked() else { return };
    let place = (seen.on_ground(seen.spot(hand.pointed.get_untracked())), seen.good_length());
    let (measure, language) = (seen.ground_measure(), hand.app.language.get_untracked());
    let mut added = None;
    let is_done = change(hand, |outline| {
        let (edit, number) = add_element(outline, kind, place, &measure, language)?;
        added = Some(number);
        Ok(vec![edit])
    });
    if is_done {
        hand.chosen.set(added.into_iter().collect());
        browser::focus_later("drawing-canvas".to_owned());
    }
}

/// Element as seen, and true if it is placed in a frame; `None` if it is not in the picture.
fn both<'a>(drawing: &'a Drawing, seen: &'a Seen, number: usize) -> Option<(&'a SeenItem, bool)> {
    let item = drawing.items.get(number)?;
    Some((seen.items.get(number)?.as_ref()?, item.framed))
}

/// Selected elements that are not inside other selected ones.
fn outermost(drawing: &Drawing, chosen: &[usize]) -> Vec<usize> {
    let inside = |number: &usize| drawing.outwards(*number).skip(1).any(|around| chosen.contains(&around));
    chosen.iter().copied().filter(|number| !inside(number)).collect()
}

/// Moves a grip of an element, or all selected elements, by a displacement in picture units. A rotation grip receives
/// an angle in radians, clockwise.
pub fn move_by(hand: Hand, grip: (usize, Grip), way: [f64; 2]) {
    let (number, grip) = grip;
    let moved = if grip == Grip::Whole { hand.chosen.get_clone_untracked() } else { vec![number] };
    let ways: Vec<(usize, [f64; 2])> = moved.into_iter().map(|number| (number, way)).collect();
    move_each(hand, grip, &ways, hand.grid.get_untracked());
}

fn move_each(hand: Hand, grip: Grip, ways: &[(usize, [f64; 2])], on_grid: bool) {
    let (Some(drawing), Some(seen)) = (hand.drawing.get_clone_untracked(), hand.seen.get_clone_untracked()) else {
        return;
    };
    let numbers: Vec<usize> = ways.iter().map(|(number, _)| *number).collect();
    let outermost = outermost(&drawing, &numbers);
    change(hand, |outline| {
        let mut edits = Vec::new();
        for (number, way) in ways.iter().filter(|(number, _)| outermost.contains(number)) {
            let Some((item, framed)) = both(&drawing, &seen, *number) else { continue };
            let (by, measure) = if grip == Grip::Turn {
                let turn = if framed { -way[0] } else { way[0] };
                ([turn, 0.0], Measure::degrees(TURNS[usize::from(!on_grid)]))
            } else {
                (item.way(*way, grip, framed), item.measure(seen.pixel, on_grid))
            };
            edits.extend(shift(outline, *number, grip, by, &measure)?);
        }
        Ok(edits)
    });
}

/// Moves the selected elements by steps of the grid, to the right and downwards on the screen.
pub fn step(hand: Hand, steps: [f64; 2]) {
    let Some(seen) = hand.seen.get_clone_untracked() else { return };
    let length = |number: usize| {
        let item = seen.items.get(number)?.as_ref()?;
        let measure = item.measure(seen.pixel, hand.grid.get_untracked());
        Some(measure.step * measure.scale / item.inwards_scale())
    };
    let chosen = hand.chosen.get_clone_untracked();
    let ways: Vec<(usize, [f64; 2])> = chosen
        .into_iter()
        .filter_map(|number| length(number).map(|length| (number, steps.map(|steps| steps * length))))
        .collect();
    move_each(hand, Grip::Whole, &ways, hand.grid.get_untracked());
}

/// Aligns the selected elements by an edge.
pub fn align(hand: Hand, edge: Edge) {
    let Some(seen) = hand.seen.get_clone_untracked() else { return };
    let chosen = hand.chosen.get_clone_untracked();
    let edges = chosen.iter().filter_map(|number| Some((*number, seen.items.get(*number)?.as_ref()?.edges)));
    let edges: Vec<(usize, [f64; 4])> = edges.collect();
    let place = |[left, top, right, bottom]: [f64; 4]| match edge {
        Edge::Left => left,
        Edge::Centre => (left + right) / 2.0,
        Edge::Right => right,
        Edge::Top => top,
        Edge::Middle => (top + bottom) / 2.0,
        Edge::Bottom => bottom,
    };
    let places = || edges.iter().map(|(_, edges)| place(*edges));
    let goal = match edge {
        Edge::Left | Edge::Top => places().fold(f64::INFINITY, f64::min),
        Edge::Right | Edge::Bottom => places().fold(f64::NEG_INFINITY, f64::max),
        // Position of the first selected element.
        Edge::Centre | Edge::Middle => places().next().unwrap_or(0.0),
    };
    let is_across = matches!(edge, Edge::Left | Edge::Centre | Edge::Right);
    let way = |from: f64| if is_across { [goal - from, 0.0] } else { [0.0, goal - from] };
    let ways: Vec<(usize, [f64; 2])> = edges.iter().map(|(number, edges)| (*number, way(place(*edges)))).collect();
    move_each(hand, Grip::Whole, &ways, false);
}

/// Removes the selected elements.
pub fn remove(hand: Hand) {
    let chosen = hand.chosen.get_clone_untracked();
    if !chosen.is_empty() && change(hand, |outline| remove_elements(outline, &chosen)) {
        hand.chosen.set(Vec::new());
        browser::focus_later("drawing-canvas".to_owned());
    }
}

/// Copies the selected element, placed beside the original.
pub fn copy(hand: Hand) {
    let (Some(drawing), Some(seen), Some(number)) = (
        hand.drawing.get_clone_untracked(),
        hand.seen.get_clone_untracked(),
        hand.chosen.with_untracked(|chosen| chosen.first().copied()),
    ) else {
        return;
    };
    let Some((item, framed)) = both(&drawing, &seen, number) else { return };
    let measure = item.measure(seen.pixel, true);
    let aside = 2.0 * measure.step;
    let by = [aside, if framed { -aside } else { aside }];
    let mut copied = None;
    let is_done = change(hand, |outline| {
        let (edit, number) = duplicate_element(outline, number, by, &measure)?;
        copied = Some(number);
        Ok(vec![edit])
    });
    if is_done {
        hand.chosen.set(copied.into_iter().collect());
    }
}

/// Moves the selected element above or below its neighbour.
pub fn reorder(hand: Hand, order: Order) {
    let Some(number) = hand.chosen.with_untracked(|chosen| chosen.first().copied()) else { return };
    let mut moved = None;
    let is_done = change(hand, |outline| {
        let (edits, number) = reorder_element(outline, number, order)?;
        moved = Some(number);
        Ok(edits)
    });
    if is_done {
        hand.chosen.set(moved.into_iter().collect());
    }
}

/// Sets an attribute of an element.
pub fn set(hand: Hand, number: usize, name: &str, text: &str) {
    change(hand, |outline| set_attribute(outline, number, name, text));
}

/// Sets the text or name of an element.
pub fn say(hand: Hand, number: usize, text: &str) {
    change(hand, |outline| set_text(outline, number, text));
}

/// Makes a component of a point follow a quantity.
pub fn bind(hand: Hand, number: usize, attribute: &str, axis: Axis, name: &str) {
    change(hand, |outline| follow(outline, number, attribute, axis, name));
}
