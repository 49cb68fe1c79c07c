//! Parts of the scene that follow the hand: by pointer, or focused and moved with the arrow keys.

use crate::app::App;
use document::Drag;
use session::Session;
use std::cell::Cell;
use std::rc::Rc;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::{Event, KeyboardEvent, PointerEvent, SvgElement, SvgGraphicsElement};

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

/// Makes a handle follow pointer and keys. `root` is the scene's `svg`, whose user units the document counts in.
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
    pointer(app, handle, root);
    keyboard(app, handle, root);
}

fn pointer(app: App, handle: &mut Handle, root: &SvgGraphicsElement) {
    // The pointer that holds the handle, and where it took hold.
    let held: Rc<Cell<Option<(i32, f64, f64)>>> = Rc::default();
    let (drag, node, grip) = (handle.drag.clone(), handle.node.clone(), held.clone());
    handle.listen("pointerdown", move |event| {
        let Ok(event) = event.dyn_into::<PointerEvent>() else { return };
        if event.button() != 0 || grip.get().is_some() {
            return;
        }
        // Otherwise the browser selects text or scrolls.
        event.prevent_default();
        let _ = node.set_pointer_capture(event.pointer_id());
        let _ = node.focus();
        let _ = node.set_attribute("part", "handle held");
        grip.set(Some((event.pointer_id(), event.client_x().into(), event.client_y().into())));
        app.act(|session| session.drag_begin(&drag));
    });
    let (grip, root) = (held.clone(), root.clone());
    handle.listen("pointermove", move |event| {
        let Ok(event) = event.dyn_into::<PointerEvent>() else { return };
        if let Some((id, x, y)) = grip.get()
            && id == event.pointer_id()
            && let Some(matrix) = root.get_screen_ctm()
        {
            let right = (f64::from(event.client_x()) - x) / f64::from(matrix.a());
            let up = (y - f64::from(event.client_y())) / f64::from(matrix.d());
            app.slide(|session| session.drag_move(right, up));
        }
    });
    for kind in ["pointerup", "pointercancel"] {
        let (grip, node) = (held.clone(), handle.node.clone());
        handle.listen(kind, move |event| {
            let Ok(event) = event.dyn_into::<PointerEvent>() else { return };
            if grip.get().is_some_and(|(id, ..)| id == event.pointer_id()) {
                grip.set(None);
                let _ = node.set_attribute("part", "handle");
                app.act(Session::drag_end);
            }
        });
    }
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
