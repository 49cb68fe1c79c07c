//! The canvas: the running picture with grid and grips.

use super::hand::Hand;
use super::picture::Canvas;
use super::pointing::Pointing;
use super::{keys, overlay, words};
use sycamore_reactive::on_cleanup;
use view::views::*;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::{AddEventListenerOptions, Element, ResizeObserver, TouchEvent};

/// The canvas.
pub fn view(hand: Hand) -> View {
    let words = words::of(hand.app);
    let canvas = Canvas::default();
    let mut place = div().class("drawing-picture");
    let node: Element = place.node();
    let (built, drawn, measured) = (canvas.clone(), canvas.clone(), canvas.clone());
    // A new program requires a new picture.
    effect(move || {
        hand.app.written.track();
        hand.app.changes.program.track();
        built.build(hand, &node);
        built.measure(hand);
    });
    effect(move || {
        hand.app.changes.frame.track();
        drawn.draw(hand);
    });
    // Measuring a large drawing takes the browser longer than drawing it; ten times a second suffices while the run
    // plays.
    effect(move || {
        hand.app.changes.values.track();
        hand.app.changes.parameters.track();
        measured.measure(hand);
    });
    let node: Element = place.node();
    follow_size(hand, canvas.clone(), &node);
    let runs = memo(move || hand.seen.with(Option::is_some));
    let over = move || if runs.get() { overlay::view(hand) } else { View::new() };
    let pointing = Pointing { hand, canvas };
    let mut surface = div();
    scrolls_beside(&pointing, &surface.node());
    let (down, moved, up) = (pointing.clone(), pointing.clone(), pointing);
    let surface = surface
        .class("drawing-canvas")
        .id("drawing-canvas")
        .tabindex("0")
        .role("application")
        .attr("aria-label", words.canvas)
        .attr("aria-describedby", "drawing-keys")
        .when(events::pointerdown, move |event| down.begin(&event))
        .when(events::pointermove, move |event| moved.follow(&event))
        .when(events::pointerup, move |event| up.end(&event))
        .when(events::pointercancel, move |_| hand.held.set(None))
        .when(events::keydown, move |event| keys::pressed(hand, &event))
        .child(place)
        .child(changing(over));
    let paused = move || if runs.get() { View::new() } else { note(words.paused).into() };
    View::from((surface, p().id("drawing-keys").class("note").child(words.keys), changing(paused)))
}

/// Listens to touches before the browser begins to scroll. The listener must not be passive, in order to prevent
/// scrolling.
fn scrolls_beside(pointing: &Pointing, surface: &Element) {
    let pointing = pointing.clone();
    let touched = Closure::<dyn FnMut(TouchEvent)>::new(move |event: TouchEvent| pointing.touched(&event));
    let options = AddEventListenerOptions::new();
    options.set_passive(false);
    let listener = touched.as_ref().unchecked_ref();
    let _ = surface.add_event_listener_with_callback_and_add_event_listener_options("touchstart", listener, &options);
    on_cleanup(move || drop(touched));
}

/// Measures again when the size of the canvas changes.
fn follow_size(hand: Hand, canvas: Canvas, node: &Element) {
    let draw = Closure::<dyn FnMut()>::new(move || canvas.measure(hand));
    let Ok(observer) = ResizeObserver::new(draw.as_ref().unchecked_ref()) else { return };
    observer.observe(node);
    on_cleanup(move || {
        observer.disconnect();
        drop(draw);
    });
}
