//! Fields in which the reader draws a curve, by finger, mouse or pen, or point by point with the keys.

use crate::app::App;
use crate::views::*;
use play::DrawingView;
use std::rc::Rc;
use sycamore_web::SvgGlobalAttributes;
use web_sys::{HtmlElement, KeyboardEvent, PointerEvent};

/// Change by an arrow key, as a fraction of the range.
const SMALL: f64 = 1.0 / 40.0;
/// Change by a page key, as a fraction of the range.
const LARGE: f64 = 1.0 / 10.0;

/// A field for each curve drawn by the reader; empty if there are none.
pub fn view(app: App) -> View {
    each(app.read(|play| play.basis().drawn_curves(play.course())), |first| field(app, first))
}

/// The curve being drawn, and the point that the keys change.
#[derive(Clone)]
struct Sketch {
    app: App,
    index: usize,
    heights: Signal<Vec<f64>>,
    point: Signal<usize>,
    /// Last position of the pointer during a stroke: (place, height).
    stroke: Signal<Option<(f64, f64)>>,
}

impl Sketch {
    /// Index of the point nearest to a place (0 to 1).
    fn at(&self, place: f64) -> usize {
        let last = self.heights.with_untracked(Vec::len).saturating_sub(1);
        (place * last as f64).round() as usize
    }

    /// Draws a straight line from the last position of the pointer.
    fn draw_to(&self, (place, height): (f64, f64)) {
        let (before, from) = self.stroke.get_untracked().unwrap_or((place, height));
        let (first, last) = (self.at(before), self.at(place));
        self.heights.update(|heights| {
            for point in first.min(last)..=first.max(last) {
                let part =
                    if last == first { 1.0 } else { (point as f64 - first as f64) / (last as f64 - first as f64) };
                if let Some(own) = heights.get_mut(point) {
                    *own = from + part * (height - from);
                }
            }
        });
        self.point.set(last);
        self.stroke.set(Some((place, height)));
    }

    /// Applies the curve; the run restarts.
    fn finish(&self) {
        self.stroke.set(None);
        let heights = self.heights.get_clone_untracked();
        let index = self.index;
        self.app.slide(move |play| {
            // The heights of the field always fit the curve.
            let _ = play.change_settings(|settings| settings.draw(index, &heights));
        });
    }

    /// Handles a key. Returns true if it has a function here.
    fn key(&self, key: &str) -> bool {
        let last = self.heights.with_untracked(Vec::len).saturating_sub(1);
        let point = self.point.get_untracked();
        let by = match key {
            "ArrowLeft" => return self.choose(point.saturating_sub(1)),
            "ArrowRight" => return self.choose((point + 1).min(last)),
            "Home" => return self.choose(0),
            "End" => return self.choose(last),
            "ArrowUp" => SMALL,
            "ArrowDown" => -SMALL,
            "PageUp" => LARGE,
            "PageDown" => -LARGE,
            _ => return false,
        };
        self.heights.update(|heights| {
            if let Some(own) = heights.get_mut(point) {
                *own = (*own + by).clamp(0.0, 1.0);
            }
        });
        self.finish();
        true
    }

    fn choose(&self, point: usize) -> bool {
        self.point.set(point);
        true
    }

    fn height(&self) -> f64 {
        self.heights.with(|heights| heights.get(self.point.get()).copied().unwrap_or_default())
    }
}

fn field(app: App, first: DrawingView) -> HtmlDiv {
    let words = app.words();
    let index = first.index;
    let now = memo(move || {
        app.changes.parameters.track();
        app.read(|play| play.basis().drawn_curve(play.course(), index))
    });
    let sketch = Sketch {
        app,
        index,
        heights: create_signal(first.heights.clone()),
        point: create_signal(0),
        stroke: create_signal(None),
    };
    let following = sketch.clone();
    effect(move || {
        let heights = now.with(|view| view.as_ref().map(|view| view.heights.clone()));
        if let Some(heights) = heights.filter(|_| following.stroke.get_untracked().is_none()) {
            following.heights.set(heights);
        }
    });
    let id = format!("drawing-{index}");
    let hint = format!("{id}-hint");
    let locked = app.host().embedding().locked;
    let clear = button()
        .class("quiet")
        .id(format!("{id}-clear"))
        .attr("aria-label", format!("{}: {}", words.clear_drawing, first.label))
        .attr("aria-disabled", move || {
            now.with(|view| view.as_ref().is_none_or(|view| view.is_default)).then_some("true")
        })
        .when(events::click, move |_| app.act(|play| play.change_settings(|settings| settings.clear_drawing(index))))
        .child(words.clear_drawing);
    let [low, high] = first.values.clone();
    let [from, until] = first.arguments.clone();
    div()
        .class("block drawing")
        .child(div().class("block-head").child(h3().class("plain").child(first.label.clone())).child(clear))
        .child(
            div()
                .class("drawing-place")
                .child(
                    div()
                        .class("drawing-values")
                        .attr("aria-hidden", "true")
                        .child(span().child(high))
                        .child(span().child(low)),
                )
                // A disabled `fieldset` does not disable the drawing field.
                .child(pad(&sketch, now, &first, id, hint.clone()).attr("inert", move || locked.then_some("")))
                .child(
                    div()
                        .class("drawing-arguments")
                        .attr("aria-hidden", "true")
                        .child(span().child(from))
                        .child(span().child(until)),
                ),
        )
        .child(note(words.drawing_hint).id(hint))
}

/// The drawing field.
fn pad(
    sketch: &Sketch,
    now: ReadSignal<Option<DrawingView>>,
    first: &DrawingView,
    id: String,
    hint: String,
) -> HtmlDiv {
    let (app, index) = (sketch.app, sketch.index);
    let drawn = sketch.clone();
    let line = move || {
        if drawn.stroke.get().is_some() {
            let last = drawn.heights.with(Vec::len).saturating_sub(1).max(1) as f64;
            return drawn.heights.with(|heights| {
                path_through(heights.iter().enumerate().map(|(point, height)| (point as f64 / last, *height)))
            });
        }
        now.with(|view| view.as_ref().map_or_else(String::new, |view| path_through(view.line.iter().copied())))
    };
    let zero = first.zero.map(|zero| {
        let height = format!("{}", 100.0 * (1.0 - zero));
        tags::path().class("zero").d(format!("M0 {height}H100"))
    });
    let picture = svg()
        .viewBox("0 0 100 100")
        .attr("preserveAspectRatio", "none")
        .attr("aria-hidden", "true")
        .child(tags::path().class("grid").d("M0 25H100M0 50H100M0 75H100M20 0V100M40 0V100M60 0V100M80 0V100"))
        .maybe(zero)
        .child(tags::path().class("curve").d(line));
    let marked = sketch.clone();
    let mark = move || {
        let last = marked.heights.with(Vec::len).saturating_sub(1).max(1) as f64;
        let (place, height) = (marked.point.get() as f64 / last, marked.height());
        format!("left:{:.2}%;top:{:.2}%", 100.0 * place, 100.0 * (1.0 - height))
    };
    let spoken = sketch.clone();
    let text = move || {
        let (point, height) = (spoken.point.get(), spoken.height());
        app.read(|play| play.basis().drawn_text(index, point, height))
    };
    let valued = sketch.clone();
    let mut pad = div();
    let node: HtmlElement = pad.node();
    let node = Rc::new(node);
    let place = {
        let node = node.clone();
        move |event: &PointerEvent| {
            let bounds = node.get_bounding_client_rect();
            let right = (f64::from(event.client_x()) - bounds.left()) / bounds.width().max(1.0);
            let down = (f64::from(event.client_y()) - bounds.top()) / bounds.height().max(1.0);
            (right.clamp(0.0, 1.0), 1.0 - down.clamp(0.0, 1.0))
        }
    };
    let place = Rc::new(place);
    let (begins, moves, ends, leaves, typed) =
        (sketch.clone(), sketch.clone(), sketch.clone(), sketch.clone(), sketch.clone());
    let (place_at_first, place_on_the_way) = (place.clone(), place);
    pad.class("drawing-pad")
        .id(id)
        .role("slider")
        .tabindex("0")
        .attr("aria-label", first.label.clone())
        .attr("aria-describedby", hint)
        .attr("aria-valuemin", "0")
        .attr("aria-valuemax", "100")
        .attr("aria-valuenow", move || format!("{:.1}", 100.0 * valued.height()))
        .attr("aria-valuetext", text)
        .when(events::pointerdown, move |event: PointerEvent| {
            if event.button() != 0 {
                return;
            }
            event.prevent_default();
            let _ = node.set_pointer_capture(event.pointer_id());
            let _ = node.focus();
            begins.draw_to(place_at_first(&event));
        })
        .when(events::pointermove, move |event: PointerEvent| {
            if moves.stroke.get_untracked().is_some() {
                moves.draw_to(place_on_the_way(&event));
            }
        })
        .when(events::pointerup, move |_| {
            if ends.stroke.get_untracked().is_some() {
                ends.finish();
            }
        })
        .when(events::pointercancel, move |_| {
            if leaves.stroke.get_untracked().is_some() {
                leaves.finish();
            }
        })
        .when(events::keydown, move |event: KeyboardEvent| {
            let modified = event.ctrl_key() || event.alt_key() || event.meta_key();
            if !modified && typed.key(&event.key()) {
                event.prevent_default();
            }
        })
        .child(picture)
        .child(span().class("drawing-mark").style(mark))
}

/// SVG path through points whose places and heights are fractions of the field.
fn path_through(points: impl Iterator<Item = (f64, f64)>) -> String {
    let mut path = String::new();
    for (place, height) in points {
        path.push(if path.is_empty() { 'M' } else { 'L' });
        path.push_str(&format!("{:.3} {:.3}", 100.0 * place, 100.0 * (1.0 - height)));
    }
    path
}
