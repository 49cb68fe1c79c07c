//! Parts of the scene that follow the hand: focused and moved with the arrow keys, or by pointer ([`crate::grip`]).

use crate::app::App;
use document::Drag;
use session::Session;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::{Event, KeyboardEvent, SvgElement, SvgGraphicsElement};

/// An arrow key moves a handle by this part of the scene's height, with Shift five times as far.
const KEY_STEP: f64 = 0.01;

/// A part of the scene that can be dragged.
pub struct Handle {
    node: SvgElement,
    drag: Drag,
    listeners: Vec<Closure<dyn FnMut(Event)>>,
    shown: String,
}

impl Handle {
    /// Makes a node a handle.
    pub fn new(node: SvgElement, drag: Drag) -> Self {
        Self { node, drag, listeners: Vec::new(), shown: String::new() }
    }

    /// What takes hold of it by pointer.
    pub fn part(&self) -> (SvgElement, Drag) {
        (self.node.clone(), self.drag.clone())
    }

    /// Says where it is to those who do not see it. Left alone while the run is playing: a screen reader on the handle
    /// would talk without end.
    pub fn describe(&mut self, session: &Session) {
        if session.is_playing() && !self.shown.is_empty() {
            return;
        }
        let Some(state) = session.states().into_iter().nth(self.drag.state) else { return };
        let text = format!("{} {}", state.text, state.unit);
        if text != self.shown {
            let _ = self.node.set_attribute("aria-label", &state.label);
            let _ = self.node.set_attribute("aria-valuenow", &state.value.to_string());
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

/// Makes a handle known to readers of the screen, and follow keys. `root` is the scene's `svg`, whose user units the
/// document counts in.
pub fn attach(app: App, handle: &mut Handle, root: &SvgGraphicsElement) {
    for (name, value) in [
        ("role", "slider"),
        ("tabindex", "0"),
        ("aria-roledescription", app.words().drag_role),
        // Any number is allowed, but the role demands limits.
        ("aria-valuemin", "-1000000"),
        ("aria-valuemax", "1000000"),
        ("aria-orientation", if handle.drag.up.is_some() { "vertical" } else { "horizontal" }),
    ] {
        let _ = handle.node.set_attribute(name, value);
    }
    let _ = handle.node.set_attribute("part", "handle");
    keyboard(app, handle, root);
}

fn keyboard(app: App, handle: &mut Handle, root: &SvgGraphicsElement) {
    let (drag, root) = (handle.drag.clone(), root.clone());
    handle.listen("keydown", move |event| {
        let Ok(event) = event.dyn_into::<KeyboardEvent>() else { return };
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
        // Along the axis that the document names, whichever pair of arrows is pressed.
        let (right, up) = match (drag.right.is_some(), drag.up.is_some()) {
            (true, true) => (right, up),
            (true, false) => (right + up, 0.0),
            (false, _) => (0.0, right + up),
        };
        app.act(|session| {
            session.drag_begin(&drag);
            session.drag_move(right * step, up * step);
            session.drag_end();
        });
    });
}
