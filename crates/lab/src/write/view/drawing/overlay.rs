//! Overlay of the picture: grid, edges of selected elements, grips, and the displacement of a drag.

use super::hand::Hand;
use super::held::Held;
use super::seen::Seen;
use document::drawing::Grip;
use sycamore_web::SvgGlobalAttributes;
use view::views::*;

/// Size of a grip, and distance from its centre within which it is hit, in CSS pixels.
const GRIP: f64 = 5.0;
const FINGER: f64 = 18.0;

/// The whole overlay, in picture units.
pub fn view(hand: Hand) -> View {
    let view_box = memo(move || hand.seen.with(|seen| seen.as_ref().map(|seen| seen.view_box)));
    let shown = move || {
        view_box.get().map_or_else(View::new, |[left, top, width, height]| {
            svg()
                .class("drawing-overlay")
                .viewBox(format!("{left} {top} {width} {height}"))
                .attr("aria-hidden", "true")
                .child(grid(hand))
                .child(chosen(hand))
                .child(way(hand))
                .into()
        })
    };
    changing(shown)
}

/// Lines of the grid, including the axes of the frame.
fn grid(hand: Hand) -> View {
    let lines = memo(move || {
        let seen = hand.seen.get_clone().filter(|_| hand.grid.get())?;
        let [left, top, width, height] = seen.view_box;
        let step = seen.ground_measure().step * seen.ground.scale;
        if step.is_nan() || step <= 0.0 || width.max(height) / step > 400.0 {
            return None;
        }
        let [x, y] = seen.ground.origin;
        let along = |from: f64, length: f64, origin: f64| {
            let first = ((from - origin) / step).ceil();
            let count = (length / step) as usize + 1;
            (0..count).map(move |number| origin + (first + number as f64) * step)
        };
        let mut fine = String::new();
        along(left, width, x).for_each(|x| fine.push_str(&format!("M{x:.3} {top:.3}v{height:.3}")));
        along(top, height, y).for_each(|y| fine.push_str(&format!("M{left:.3} {y:.3}h{width:.3}")));
        let axes = seen.ground.framed.then(|| format!("M{x:.3} {top:.3}v{height:.3}M{left:.3} {y:.3}h{width:.3}"));
        Some((fine, axes.unwrap_or_default()))
    });
    changing(move || {
        lines.get_clone().map_or_else(View::new, |(fine, axes)| {
            View::from((path().class("grid").d(fine), path().class("grid axis").d(axes)))
        })
    })
}

/// Edges and grips of the selected elements.
fn chosen(hand: Hand) -> View {
    let shown = memo(move || {
        let seen = hand.seen.get_clone()?;
        let chosen = hand.chosen.get_clone();
        let items = chosen.iter().filter_map(|number| Some((*number, seen.items.get(*number)?.clone()?)));
        Some((seen.pixel, items.collect::<Vec<_>>()))
    });
    changing(move || {
        let Some((pixel, items)) = shown.get_clone() else { return View::new() };
        let grips_of = (items.len() == 1).then(|| items.first().cloned()).flatten();
        let edges = each(items, |(_, item)| {
            let [left, top, right, bottom] = item.edges;
            let margin = 3.0 * pixel;
            let (x, y) = (left - margin, top - margin);
            let (width, height) = (right - left + 2.0 * margin, bottom - top + 2.0 * margin);
            tags::rect()
                .class("edges")
                .attr("x", x.to_string())
                .attr("y", y.to_string())
                .attr("width", width.to_string())
                .attr("height", height.to_string())
        });
        let grips = grips_of.into_iter().flat_map(|(number, item)| {
            let own = item.grips.into_iter().filter(|(grip, _)| *grip != Grip::Whole);
            own.map(move |(grip, at)| (number, grip, at)).collect::<Vec<_>>()
        });
        let grips = each(grips, |(number, grip, [x, y])| {
            let circle = |class: &'static str, radius: f64| {
                tags::circle()
                    .class(class)
                    .attr("cx", x.to_string())
                    .attr("cy", y.to_string())
                    .attr("r", (radius * pixel).to_string())
            };
            tags::g()
                .class(format!("grip {grip:?}").to_lowercase())
                .attr("data-grip", format!("{number} {grip:?}"))
                .child(circle("reach", FINGER))
                .child(circle("knob", GRIP))
        });
        View::from((edges, grips))
    })
}

/// Displacement of the present drag.
fn way(hand: Hand) -> View {
    changing(move || {
        let Some(Held { from, at, grip: (_, grip), .. }) = hand.held.get().filter(Held::is_moved) else {
            return View::new();
        };
        let Some(seen) = hand.seen.get_clone_untracked() else { return View::new() };
        let [right, down] = [at[0] - from[0], at[1] - from[1]];
        let line = path().class("way").d(format!("M{} {}L{} {}", from[0], from[1], at[0], at[1]));
        if grip != Grip::Whole {
            return line.into();
        }
        let moved = hand.chosen.get_clone_untracked();
        let boxes = each(moved, |number| ghost(&seen, number, [right, down]));
        View::from((line, boxes))
    })
}

/// Edges of an element at the position to which it is dragged.
fn ghost(seen: &Seen, number: usize, [right, down]: [f64; 2]) -> View {
    let Some(item) = seen.items.get(number).and_then(Option::as_ref) else { return View::new() };
    let [left, top, end, bottom] = item.edges;
    let d = format!("M{} {}h{}v{}h{}z", left + right, top + down, end - left, bottom - top, left - end);
    path().class("ghost").d(d).into()
}
