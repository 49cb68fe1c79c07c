//! Dragging in the scene with a mouse, a pen or a finger.
//!
//! Browsers ignore `touch-action` on parts of a drawing: a finger on a handle would scroll the page, and the drag would
//! be cancelled after a few pixels. Therefore the whole scene listens to `touchstart` and prevents scrolling if a
//! handle is under the finger. Elsewhere, a finger scrolls the page.

use crate::app::App;
use crate::stage::invitation;
use program::Drag;
use std::cell::Cell;
use std::rc::Rc;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::{
    AddEventListenerOptions, Event, EventTarget, FocusOptions, Node, PointerEvent, SvgElement, SvgGraphicsElement,
    TouchEvent,
};

/// Side of the square around the centre of a handle in which a finger grabs it, in CSS pixels (WCAG 2.2, 2.5.5).
const FINGER: f64 = 44.0;

/// Makes the handles of a scene draggable as long as it lives.
pub struct Grips {
    root: SvgGraphicsElement,
    listeners: Vec<Closure<dyn FnMut(Event)>>,
}

/// A handle that is being dragged.
#[derive(Clone, Copy)]
struct Held {
    pointer: i32,
    /// Index of the handle.
    handle: usize,
    /// Position at which it was grabbed, in CSS pixels.
    at: (f64, f64),
}

impl Grips {
    /// Listens to all pointers on the scene `root`, which defines the user units of the document.
    pub fn new(app: App, root: SvgGraphicsElement, handles: Vec<(SvgElement, Drag)>) -> Self {
        let mut grips = Self { root, listeners: Vec::new() };
        let handles = Rc::new(handles);
        let held: Rc<Cell<Option<Held>>> = Rc::default();
        grips.touches(handles.clone());
        grips.begin(app, handles.clone(), held.clone());
        grips.follow(app, held.clone());
        grips.end(app, handles, held);
        grips
    }

    fn touches(&mut self, handles: Rc<Vec<(SvgElement, Drag)>>) {
        self.listen("touchstart", move |event| {
            let Ok(event) = event.dyn_into::<TouchEvent>() else { return };
            let Some(touch) = event.changed_touches().get(0) else { return };
            let at = (f64::from(touch.client_x()), f64::from(touch.client_y()));
            if event.cancelable() && under(&handles, touch.target(), at, true).is_some() {
                event.prevent_default();
            }
        });
    }

    fn begin(&mut self, app: App, handles: Rc<Vec<(SvgElement, Drag)>>, held: Rc<Cell<Option<Held>>>) {
        self.listen("pointerdown", move |event| {
            let Ok(event) = event.dyn_into::<PointerEvent>() else { return };
            if event.button() != 0 || held.get().is_some() {
                return;
            }
            let at = (f64::from(event.client_x()), f64::from(event.client_y()));
            let Some(handle) = under(&handles, event.target(), at, event.pointer_type() != "mouse") else { return };
            let Some((node, drag)) = handles.get(handle) else { return };
            // Prevents the selection of text.
            event.prevent_default();
            let _ = node.set_pointer_capture(event.pointer_id());
            // Set before the focus, so that no focus ring is drawn.
            let _ = node.set_attribute("part", "handle held");
            let options = FocusOptions::new();
            options.set_prevent_scroll(true);
            let _ = node.focus_with_options(&options);
            held.set(Some(Held { pointer: event.pointer_id(), handle, at }));
            invitation::accept(app);
            app.act(|play| play.change_settings(|settings| settings.drag_begin(drag)));
        });
    }

    fn follow(&mut self, app: App, held: Rc<Cell<Option<Held>>>) {
        let root = self.root.clone();
        self.listen("pointermove", move |event| {
            let Ok(event) = event.dyn_into::<PointerEvent>() else { return };
            if let Some(held) = held.get()
                && held.pointer == event.pointer_id()
                && let Some(matrix) = root.get_screen_ctm()
            {
                let right = (f64::from(event.client_x()) - held.at.0) / f64::from(matrix.a());
                let up = (held.at.1 - f64::from(event.client_y())) / f64::from(matrix.d());
                app.slide(|play| play.change_settings(|settings| settings.drag_move(right, up)));
            }
        });
    }

    fn end(&mut self, app: App, handles: Rc<Vec<(SvgElement, Drag)>>, held: Rc<Cell<Option<Held>>>) {
        for kind in ["pointerup", "pointercancel"] {
            let (handles, held) = (handles.clone(), held.clone());
            self.listen(kind, move |event| {
                let Ok(event) = event.dyn_into::<PointerEvent>() else { return };
                let Some(let_go) = held.get().filter(|held| held.pointer == event.pointer_id()) else { return };
                held.set(None);
                if let Some((node, _)) = handles.get(let_go.handle) {
                    let _ = node.set_attribute("part", "handle");
                }
                app.act(|play| play.change_settings(|settings| settings.drag_end()));
            });
        }
    }

    fn listen(&mut self, kind: &str, react: impl FnMut(Event) + 'static) {
        let closure = Closure::new(react);
        let options = AddEventListenerOptions::new();
        // A passive listener could not prevent scrolling.
        options.set_passive(false);
        let listener = closure.as_ref().unchecked_ref();
        let _ = self.root.add_event_listener_with_callback_and_add_event_listener_options(kind, listener, &options);
        self.listeners.push(closure);
    }
}

/// Index of the handle at a point (CSS pixels): the handle that `target` belongs to; for a finger or a pen (`coarse`),
/// also the nearest small handle.
fn under(
    handles: &[(SvgElement, Drag)],
    target: Option<EventTarget>,
    (x, y): (f64, f64),
    coarse: bool,
) -> Option<usize> {
    let target = target.and_then(|target| target.dyn_into::<Node>().ok());
    // An inner handle precedes the outer one in the list.
    let hit = handles.iter().position(|(node, _)| node.contains(target.as_ref()));
    if hit.is_some() || !coarse {
        return hit;
    }
    let distance = |(index, (node, _)): (usize, &(SvgElement, Drag))| {
        let bounds = node.get_bounding_client_rect();
        let (width, height) = (bounds.width(), bounds.height());
        let (right, down) = (x - bounds.left() - width / 2.0, y - bounds.top() - height / 2.0);
        let near = right.abs() <= width.max(FINGER) / 2.0 && down.abs() <= height.max(FINGER) / 2.0;
        // An element that is not drawn has no size.
        (near && width + height > 0.0).then_some((index, right * right + down * down))
    };
    let near = handles.iter().enumerate().filter_map(distance);
    near.min_by(|(_, one), (_, other)| one.total_cmp(other)).map(|(index, _)| index)
}
