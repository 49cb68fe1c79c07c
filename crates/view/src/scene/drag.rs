//! Draggable parts of the scene: moved with the arrow keys when focused, or by pointer ([`crate::scene::grip`]).

use crate::app::App;
use crate::stage::invitation;
use play::Play;
use program::{Drag, Dragged};
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::{Event, KeyboardEvent, SvgElement, SvgGraphicsElement};

/// Step of an arrow key, as a fraction of the scene height; five times as large with Shift.
const KEY_STEP: f64 = 0.01;

/// A part of the scene that can be dragged.
pub struct Handle {
    node: SvgElement,
    drag: Drag,
    /// Name from the document.
    name: Option<String>,
    /// Number among several unnamed handles with the same target; 0 if it is the only one.
    pub number: usize,
    listeners: Vec<Closure<dyn FnMut(Event)>>,
    shown: String,
}

impl Handle {
    /// Creates a handle from a node.
    pub fn new(node: SvgElement, drag: Drag, name: Option<String>) -> Self {
        Self { node, drag, name, number: 0, listeners: Vec::new(), shown: String::new() }
    }

    /// Numbers the handles that would otherwise have equal names.
    pub fn number_unnamed(handles: &mut [Self]) {
        for index in 0..handles.len() {
            let Some(target) = handles.get(index).filter(|one| one.name.is_none()).map(|one| one.drag.target) else {
                continue;
            };
            let same = |one: &&Self| one.name.is_none() && one.drag.target == target;
            let several = handles.iter().filter(same).count() > 1;
            let before = handles.iter().take(index).filter(same).count();
            if let Some(handle) = handles.get_mut(index).filter(|_| several) {
                handle.number = before + 1;
            }
        }
    }

    /// Node and target, for dragging by pointer.
    pub fn part(&self) -> (SvgElement, Drag) {
        (self.node.clone(), self.drag.clone())
    }

    /// Updates the ARIA attributes with the position. Skipped while the run is playing: a screen reader on the handle
    /// would read continuously.
    pub fn describe(&mut self, play: &mut Play) {
        if play.time_line().is_playing() && !self.shown.is_empty() {
            return;
        }
        let moved = match self.drag.target {
            Dragged::State(index) => {
                let state = play.values().state(index);
                state.map(|state| (state.label, format!("{} {}", state.text, state.unit), state.value))
            }
            Dragged::Parameter(index) => {
                play.basis().parameter(play.course(), index).map(|one| (one.label, one.spoken, one.value))
            }
        };
        let Some((quantity, text, value)) = moved else { return };
        if text != self.shown {
            let label = match (&self.name, self.number) {
                (Some(name), _) => format!("{name}: {quantity}"),
                (None, 0) => quantity,
                (None, number) => format!("{quantity} {number}"),
            };
            let _ = self.node.set_attribute("aria-label", &label);
            if let Some((least, greatest)) = play.grips().range(&self.drag) {
                let _ = self.node.set_attribute("aria-valuemin", &short(least));
                let _ = self.node.set_attribute("aria-valuemax", &short(greatest));
            }
            let _ = self.node.set_attribute("aria-valuenow", &short(value));
            let _ = self.node.set_attribute("aria-valuetext", &text);
            self.shown = text;
        }
    }

    fn listen(&mut self, kind: &str, react: impl FnMut(Event) + 'static) {
        let closure = Closure::new(react);
        let _ = self.node.add_event_listener_with_callback(kind, closure.as_ref().unchecked_ref());
        self.listeners.push(closure);
    }
}

/// Formats with single precision: the ends of a range are found by bisection and are no more precise.
fn short(value: f64) -> String {
    (value as f32).to_string()
}

/// Makes a handle accessible to screen readers and to the keyboard. `root` is the scene's `svg`, which defines the user
/// units of the document.
pub fn attach(app: App, handle: &mut Handle, root: &SvgGraphicsElement) {
    for (name, value) in [
        ("role", "slider"),
        ("tabindex", "0"),
        ("aria-roledescription", app.words().drag_role),
        ("aria-orientation", if handle.drag.up.is_some() { "vertical" } else { "horizontal" }),
    ] {
        let _ = handle.node.set_attribute(name, value);
    }
    let _ = handle.node.set_attribute("part", "handle");
    ring(handle);
    keyboard(app, handle, root);
}

/// Shows the focus ring only after keyboard navigation; some browsers draw it after a drag by mouse, too.
fn ring(handle: &mut Handle) {
    let node = handle.node.clone();
    handle.listen("focus", move |_| {
        let held = node.get_attribute("part").is_some_and(|part| part.contains("held"));
        if !held {
            let _ = node.set_attribute("part", "handle ring");
        }
    });
    let node = handle.node.clone();
    handle.listen("blur", move |_| drop(node.set_attribute("part", "handle")));
}

fn keyboard(app: App, handle: &mut Handle, root: &SvgGraphicsElement) {
    let (drag, root, node) = (handle.drag.clone(), root.clone(), handle.node.clone());
    handle.listen("keydown", move |event| {
        let Ok(event) = event.dyn_into::<KeyboardEvent>() else { return };
        let _ = node.set_attribute("part", "handle ring");
        let (right, up): (f64, f64) = match event.key().as_str() {
            "ArrowUp" => (0.0, 1.0),
            "ArrowDown" => (0.0, -1.0),
            "ArrowRight" => (1.0, 0.0),
            "ArrowLeft" => (-1.0, 0.0),
            "PageUp" => (0.0, 5.0),
            "PageDown" => (0.0, -5.0),
            _ => return,
        };
        if event.ctrl_key() || event.alt_key() || event.meta_key() {
            return;
        }
        event.prevent_default();
        event.stop_propagation();
        let Some(matrix) = root.get_screen_ctm() else { return };
        let height = root.get_bounding_client_rect().height() / f64::from(matrix.d());
        let step = height * KEY_STEP * if event.shift_key() { 5.0 } else { 1.0 };
        // Any pair of arrow keys moves along the axis given by the document.
        let (right, up) = match (drag.right.is_some(), drag.up.is_some()) {
            (true, true) => (right, up),
            (true, false) => (right + up, 0.0),
            (false, _) => (0.0, right + up),
        };
        invitation::accept(app);
        app.act(|play| {
            play.change_settings(|settings| settings.drag_begin(&drag));
            play.change_settings(|settings| settings.drag_move(right * step, up * step));
            play.change_settings(|settings| settings.drag_end());
        });
    });
}
