//! A ruler on the scene: a line whose two ends are moved by pointer or arrow keys. It shows lengths in the scale of the
//! drawing ([`play::Grips::scale`]); a scene without scale has no ruler.

use crate::app::App;
use crate::views::document;
use play::Play;
use std::cell::RefCell;
use std::rc::Rc;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::{Element, Event, KeyboardEvent, PointerEvent, SvgElement, SvgGraphicsElement};

const SVG: &str = "http://www.w3.org/2000/svg";
/// Step of an arrow key, as a fraction of the drawing height; ten times as large with Shift.
const KEY_STEP: f64 = 0.005;

/// The ruler in a scene.
pub struct Ruler {
    node: SvgElement,
    parts: Rc<RefCell<Parts>>,
    _listeners: Vec<Closure<dyn FnMut(Event)>>,
}

impl Ruler {
    /// Updates the length shown: the scale of a drawing may depend on parameters.
    pub fn draw(&self, play: &mut Play) {
        if let Ok(mut parts) = self.parts.try_borrow_mut() {
            parts.read(play);
        }
    }
}

impl Drop for Ruler {
    fn drop(&mut self) {
        self.node.remove();
    }
}

/// Nodes of the ruler, and the positions of its ends in scene units.
struct Parts {
    line: SvgElement,
    ends: Vec<SvgElement>,
    label: SvgElement,
    places: [(f64, f64); 2],
    /// Text of the length shown.
    reading: String,
    /// Size of a pixel in scene units when the ruler was created.
    pixel: f64,
}

impl Parts {
    /// Distance of the ends, in scene units.
    fn length(&self) -> f64 {
        let [(x, y), (to_x, to_y)] = self.places;
        ((x - to_x) * (x - to_x) + (y - to_y) * (y - to_y)).sqrt()
    }

    /// Moves the nodes to their positions.
    fn place(&self) {
        let [(x, y), (to_x, to_y)] = self.places;
        let _ = self.line.set_attribute("d", &format!("M{x:.2} {y:.2}L{to_x:.2} {to_y:.2}"));
        for (end, (x, y)) in self.ends.iter().zip(self.places) {
            let _ = end.set_attribute("cx", &format!("{x:.2}"));
            let _ = end.set_attribute("cy", &format!("{y:.2}"));
            let _ = end.set_attribute("aria-valuenow", &format!("{:.1}", self.length()));
        }
        let _ = self.label.set_attribute("x", &format!("{:.2}", (x + to_x) / 2.0 + 8.0 * self.pixel));
        let _ = self.label.set_attribute("y", &format!("{:.2}", (y + to_y) / 2.0));
    }

    /// Updates the text of the length if it has changed.
    fn read(&mut self, play: &mut Play) {
        let reading = play.grips().length(self.length()).unwrap_or_default();
        if reading != self.reading {
            self.label.set_text_content(Some(&reading));
            for end in &self.ends {
                let _ = end.set_attribute("aria-valuetext", &reading);
            }
            self.reading = reading;
        }
    }
}

/// Puts a ruler on the drawing.
pub fn lay(app: App, root: &SvgGraphicsElement) -> Option<Ruler> {
    let area = root.get_attribute("viewBox")?;
    let area: Vec<f64> = area.split([' ', ',']).filter_map(units::number::decimal).collect();
    let [left, top, width, height] = *area.as_slice() else { return None };
    let group = make("g", &[("part", "ruler")])?;
    let line = make("path", &[("fill", "none"), ("stroke", "currentColor"), ("stroke-width", "2")])?;
    // Sized for a finger, independently of the units of the drawing.
    let pixel = 1.0 / root.get_screen_ctm().map_or(1.0, |matrix| f64::from(matrix.d()).max(1e-6));
    let label = make("text", &[("fill", "currentColor"), ("font-weight", "600"), ("part", "ruler-label")])?;
    let _ = label.set_attribute("font-size", &format!("{:.2}", 14.0 * pixel));
    let _ = line.set_attribute("vector-effect", "non-scaling-stroke");
    let _ = group.append_child(&line);
    let _ = group.append_child(&label);
    let mut ends = Vec::new();
    for _ in 0..2 {
        let end = make(
            "circle",
            &[
                ("fill", "currentColor"),
                ("fill-opacity", "0.25"),
                ("stroke", "currentColor"),
                ("role", "slider"),
                ("tabindex", "0"),
                ("part", "ruler-end"),
                ("cursor", "move"),
            ],
        )?;
        let _ = end.set_attribute("r", &format!("{:.2}", 11.0 * pixel));
        let _ = end.set_attribute("vector-effect", "non-scaling-stroke");
        let _ = group.append_child(&end);
        ends.push(end);
    }
    let _ = root.append_child(&group);
    let x = left + 0.82 * width;
    let places = [(x, top + 0.75 * height), (x, top + 0.35 * height)];
    for (number, end) in ends.iter().enumerate() {
        let _ = end.set_attribute("aria-label", &format!("{} {}", app.words().ruler_end, number + 1));
    }
    let parts = Parts { line, ends: ends.clone(), label, places, reading: String::new(), pixel };
    let parts = Rc::new(RefCell::new(parts));
    shift(app, &parts, 0, (0.0, 0.0));
    let mut listeners = Vec::new();
    for (number, end) in ends.iter().enumerate() {
        follow(app, &parts, number, end, root, height, &mut listeners);
    }
    Some(Ruler { node: group, parts, _listeners: listeners })
}

fn make(name: &str, attributes: &[(&str, &str)]) -> Option<SvgElement> {
    let node: SvgElement = document().create_element_ns(Some(SVG), name).ok()?.dyn_into().ok()?;
    for (name, value) in attributes {
        let _ = node.set_attribute(name, value);
    }
    Some(node)
}

/// Makes an end follow pointer and keys.
fn follow(
    app: App,
    parts: &Rc<RefCell<Parts>>,
    number: usize,
    end: &SvgElement,
    root: &SvgGraphicsElement,
    height: f64,
    listeners: &mut Vec<Closure<dyn FnMut(Event)>>,
) {
    let mut listen = |kind: &str, react: Box<dyn FnMut(Event)>| {
        let closure = Closure::new(react);
        let _ = end.add_event_listener_with_callback(kind, closure.as_ref().unchecked_ref());
        listeners.push(closure);
    };
    let held = Rc::new(RefCell::new(None::<(f64, f64)>));
    let take = held.clone();
    listen(
        "pointerdown",
        Box::new(move |event| {
            let Ok(event) = event.dyn_into::<PointerEvent>() else { return };
            event.stop_propagation();
            if let Some(end) = event.current_target().and_then(|target| target.dyn_into::<Element>().ok()) {
                let _ = end.set_pointer_capture(event.pointer_id());
            }
            *take.borrow_mut() = Some((f64::from(event.client_x()), f64::from(event.client_y())));
        }),
    );
    // A finger on the end must not scroll the page.
    listen(
        "touchstart",
        Box::new(|event| {
            event.prevent_default();
            event.stop_propagation();
        }),
    );
    let (moves, moved, drawing) = (held.clone(), parts.clone(), root.clone());
    listen(
        "pointermove",
        Box::new(move |event| {
            let Ok(event) = event.dyn_into::<PointerEvent>() else { return };
            let Some(before) = *moves.borrow() else { return };
            let now = (f64::from(event.client_x()), f64::from(event.client_y()));
            *moves.borrow_mut() = Some(now);
            let scale = drawing.get_screen_ctm().map_or(1.0, |matrix| f64::from(matrix.d()).max(1e-6));
            shift(app, &moved, number, ((now.0 - before.0) / scale, (now.1 - before.1) / scale));
        }),
    );
    let (lifts, lifted) = (held.clone(), parts.clone());
    listen(
        "pointerup",
        Box::new(move |_| {
            if lifts.borrow_mut().take().is_some() {
                say(app, &lifted.borrow());
            }
        }),
    );
    listen("pointercancel", Box::new(move |_| *held.borrow_mut() = None));
    let keyed = parts.clone();
    listen(
        "keydown",
        Box::new(move |event| {
            let Ok(event) = event.dyn_into::<KeyboardEvent>() else { return };
            let step = height * KEY_STEP * if event.shift_key() { 10.0 } else { 1.0 };
            let by = match event.key().as_str() {
                "ArrowUp" => (0.0, -step),
                "ArrowDown" => (0.0, step),
                "ArrowLeft" => (-step, 0.0),
                "ArrowRight" => (step, 0.0),
                _ => return,
            };
            event.prevent_default();
            event.stop_propagation();
            shift(app, &keyed, number, by);
        }),
    );
}

/// Moves an end by a displacement in scene units.
fn shift(app: App, parts: &Rc<RefCell<Parts>>, number: usize, by: (f64, f64)) {
    let mut parts = parts.borrow_mut();
    if let Some(place) = parts.places.get_mut(number) {
        (place.0, place.1) = (place.0 + by.0, place.1 + by.1);
    }
    parts.place();
    app.read(|play| parts.read(play));
}

fn say(app: App, parts: &Parts) {
    app.say(format!("{}: {}", app.words().ruler, parts.reading));
}
