//! Pointer, wheel and keyboard on a plot. A mouse reads by hovering, pans by dragging and zooms into a rectangle with
//! Shift. One finger reads, two fingers pan and zoom. A press, or lifting the finger, pins the read-out. The wheel
//! zooms only in a focused plot or with Ctrl; otherwise it scrolls the page.

use super::pins;
use crate::app::App;
use crate::stage::plot::{brush, look_at, with_plot};
use figure::{Direction, Point};
use play::PlotId;
use wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement, KeyboardEvent, PointerEvent, WheelEvent};

/// Distance within which a mouse, or a finger, grabs an end of the brush, in CSS pixels.
const REACH: f64 = 6.0;
const REACH_OF_FINGER: f64 = 20.0;
/// A smaller rectangle, in CSS pixels, is treated as a click.
const SMALLEST: f64 = 6.0;
/// A mouse that has moved less, in CSS pixels, has clicked and not dragged.
const STILL: f64 = 4.0;

/// Effect of a pointer move.
enum Motion {
    Read,
    Pan(f64, f64),
    Pinch { at: Point, factor: f64, right: f64, down: f64 },
    Nothing,
}

fn place(event: &PointerEvent) -> (f64, f64) {
    (f64::from(event.offset_x()), f64::from(event.offset_y()))
}

fn point((x, y): (f64, f64)) -> Point {
    Point { x: x as f32, y: y as f32 }
}

fn is_touch(event: &PointerEvent) -> bool {
    event.pointer_type() == "touch"
}

/// Index of the brush end grabbed by a pointer.
fn grabbed(app: App, id: PlotId, event: &PointerEvent) -> Option<usize> {
    let part = app.host().part()?;
    let reach = if is_touch(event) { REACH_OF_FINGER } else { REACH };
    app.read(|play| brush(play, id, Some(part))?.grabbed(place(event).0, reach))
}

/// Moves an end of the brush to the pointer.
fn brush_to(app: App, id: PlotId, end: usize, event: &PointerEvent) {
    let Some(part) = app.host().part() else { return };
    if let Some(part) = app.read(|play| Some(brush(play, id, Some(part))?.with_end(end, place(event).0))) {
        app.host().set_part(part);
        app.acted(true);
    }
}

/// Handles a pressed pointer.
pub fn down(app: App, id: PlotId, event: &PointerEvent) {
    if event.button() != 0 {
        return;
    }
    if let Some(target) = event.target().and_then(|target| target.dyn_into::<Element>().ok()) {
        let _ = target.set_pointer_capture(event.pointer_id());
    }
    let at = place(event);
    let (rectangle, touch) = (event.shift_key() && !is_touch(event), is_touch(event));
    let end = grabbed(app, id, event);
    with_plot(app, id, |plot| {
        plot.gesture.fingers.retain(|finger| finger.0 != event.pointer_id());
        plot.gesture.fingers.push((event.pointer_id(), at.0, at.1));
        if end.is_some() {
            (plot.gesture.end, plot.gesture.pressed, plot.pointer) = (end, None, None);
            return;
        }
        plot.gesture.rectangle = rectangle.then_some((at, at));
        plot.gesture.pressed = (plot.gesture.fingers.len() == 1 && !rectangle).then_some(at);
        plot.pointer = (plot.gesture.fingers.len() == 1 && (touch || !rectangle)).then(|| point(at));
    });
    app.wake();
}

/// Handles a moved pointer, pressed or not.
pub fn moved(app: App, id: PlotId, event: &PointerEvent) {
    let (at, pointer, touch) = (place(event), event.pointer_id(), is_touch(event));
    if let Some(end) = with_plot(app, id, |plot| plot.gesture.end).flatten() {
        brush_to(app, id, end, event);
        return;
    }
    if let Some(target) = event.target().and_then(|target| target.dyn_into::<HtmlElement>().ok()) {
        let over_end = event.buttons() == 0 && grabbed(app, id, event).is_some();
        let _ = target.style().set_property("cursor", if over_end { "ew-resize" } else { "" });
    }
    let motion = with_plot(app, id, |plot| {
        let gesture = &mut plot.gesture;
        if let Some((_, end)) = &mut gesture.rectangle {
            *end = at;
            return Motion::Nothing;
        }
        let others: Vec<(i32, f64, f64)> =
            gesture.fingers.iter().copied().filter(|finger| finger.0 != pointer).collect();
        let Some(finger) = gesture.fingers.iter_mut().find(|finger| finger.0 == pointer) else {
            plot.pointer = Some(point(at));
            return Motion::Read;
        };
        let before = (finger.1, finger.2);
        (finger.1, finger.2) = at;
        match others.first() {
            Some(&(_, x, y)) => {
                plot.pointer = None;
                gesture.pressed = None;
                let distance = |from: (f64, f64)| ((from.0 - x) * (from.0 - x) + (from.1 - y) * (from.1 - y)).sqrt();
                Motion::Pinch {
                    at: point(((at.0 + x) / 2.0, (at.1 + y) / 2.0)),
                    factor: distance(at).max(1.0) / distance(before).max(1.0),
                    right: (at.0 - before.0) / 2.0,
                    down: (at.1 - before.1) / 2.0,
                }
            }
            None if touch => {
                plot.pointer = Some(point(at));
                Motion::Read
            }
            None => {
                plot.pointer = None;
                if gesture.pressed.is_some_and(|from| (from.0 - at.0).abs().max((from.1 - at.1).abs()) > STILL) {
                    gesture.pressed = None;
                }
                if gesture.pressed.is_some() {
                    return Motion::Nothing;
                }
                Motion::Pan(at.0 - before.0, at.1 - before.1)
            }
        }
    });
    match motion {
        Some(Motion::Pan(right, down)) => app.act(|play| play.change_plots(|plots, _| plots.pan(id, right, down))),
        Some(Motion::Pinch { at, factor, right, down }) => app.act(|play| {
            play.change_plots(|plots, _| plots.pan(id, right, down));
            play.change_plots(|plots, _| plots.zoom(id, Some(at), factor, Direction::Both));
        }),
        Some(Motion::Read) => {
            look_at(app, id, point(at));
            app.wake();
        }
        Some(Motion::Nothing) => app.wake(),
        None => {}
    }
}

/// Handles a released pointer: pins or unpins the read-out, or zooms to the rectangle.
pub fn up(app: App, id: PlotId, event: &PointerEvent) {
    let ended = with_plot(app, id, |plot| {
        plot.gesture.fingers.retain(|finger| finger.0 != event.pointer_id());
        plot.gesture.end = None;
        (plot.gesture.rectangle.take(), plot.gesture.pressed.take())
    });
    let Some((rectangle, pressed)) = ended else { return };
    if pressed.is_some() {
        pins::press(app, id, point(place(event)));
    }
    if let Some((from, to)) = rectangle
        && (from.0 - to.0).abs() > SMALLEST
        && (from.1 - to.1).abs() > SMALLEST
    {
        app.act(|play| play.change_plots(|plots, _| plots.zoom_to(id, point(from), point(to))));
    }
    app.wake();
}

/// Handles a pointer cancelled by the browser, which scrolls the page.
pub fn cancelled(app: App, id: PlotId, event: &PointerEvent) {
    with_plot(app, id, |plot| {
        plot.gesture.fingers.retain(|finger| finger.0 != event.pointer_id());
        (plot.gesture.rectangle, plot.gesture.pressed, plot.pointer) = (None, None, None);
        plot.gesture.end = None;
    });
    app.wake();
}

/// Handles a pointer that leaves the canvas.
pub fn left(app: App, id: PlotId) {
    with_plot(app, id, |plot| plot.pointer = None);
    app.wake();
}

/// Handles the wheel.
pub fn wheel(app: App, id: PlotId, event: &WheelEvent) {
    let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
    let focused = target.is_some() && target == crate::views::document().active_element();
    if !(focused || event.ctrl_key()) {
        return;
    }
    event.prevent_default();
    let at = point((f64::from(event.offset_x()), f64::from(event.offset_y())));
    let direction = if event.shift_key() { Direction::Horizontal } else { Direction::Both };
    let delta = if event.delta_y() == 0.0 { event.delta_x() } else { event.delta_y() };
    let factor = if delta < 0.0 { 1.25 } else { 0.8 };
    app.act(|play| play.change_plots(|plots, _| plots.zoom(id, Some(at), factor, direction)));
}

/// Handles a key pressed on the canvas.
pub fn key(app: App, id: PlotId, event: &KeyboardEvent) {
    if event.alt_key() || event.meta_key() {
        return;
    }
    let (key, pan) = (event.key(), 30.0);
    let rows = if event.shift_key() { 10 } else { 1 };
    match (key.as_str(), event.ctrl_key()) {
        ("ArrowLeft", true) => app.act(|play| play.change_plots(|plots, _| plots.pan(id, pan, 0.0))),
        ("ArrowRight", true) => app.act(|play| play.change_plots(|plots, _| plots.pan(id, -pan, 0.0))),
        ("ArrowUp", true) => app.act(|play| play.change_plots(|plots, _| plots.pan(id, 0.0, pan))),
        ("ArrowDown", true) => app.act(|play| play.change_plots(|plots, _| plots.pan(id, 0.0, -pan))),
        ("ArrowLeft", false) => read(app, id, -rows),
        ("ArrowRight", false) => read(app, id, rows),
        ("+" | "=", false) => app.act(|play| play.change_plots(|plots, _| plots.zoom(id, None, 1.5, Direction::Both))),
        ("-" | "_", false) => {
            app.act(|play| play.change_plots(|plots, _| plots.zoom(id, None, 1.0 / 1.5, Direction::Both)))
        }
        ("Enter", false) => {
            let cursor = with_plot(app, id, |plot| plot.cursor.clone()).flatten();
            if let Some(readout) = cursor {
                pins::press_at(app, id, readout);
            }
        }
        ("Escape", false) if pins::clear(app, id) => {}
        ("0", false) => app.act(|play| play.change_plots(|plots, _| plots.reset(id))),
        _ => return,
    }
    event.prevent_default();
    event.stop_propagation();
}

/// Moves the keyboard cursor by a number of rows and speaks the read-out.
fn read(app: App, id: PlotId, rows: isize) {
    let Some(readout) = app.act(|play| play.change_plots(|plots, run| plots.move_cursor(run, id, rows))) else {
        return;
    };
    let mut words = vec![readout.heading.clone()];
    words.extend(readout.samples.iter().map(|sample| sample.text.clone()));
    words.retain(|line| !line.is_empty());
    app.say(words.join(", "));
    with_plot(app, id, |plot| {
        plot.pointer = None;
        plot.cursor = Some(readout);
    });
    app.wake();
}

/// Handles the loss of the focus.
pub fn blurred(app: App, id: PlotId) {
    with_plot(app, id, |plot| plot.cursor = None);
    app.wake();
}
