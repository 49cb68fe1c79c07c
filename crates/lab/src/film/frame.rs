//! The shown frame, on which points are placed and moved by mouse, finger and keys.

use super::aim::{Aim, Handle, Kind, Pixel, Tool};
use super::loupe::Loupe;
use super::tools::{self, Held};
use super::words::{self, Words};
use super::{keys, overlay};
use crate::app::App;
use desk::Subject;
use view::views::*;
use wasm_bindgen::JsCast;
use web_sys::{Element, KeyboardEvent, PointerEvent};

/// Maximum length of a drag that moves nothing, in CSS px, since a finger is never still.
const STILL: f64 = 3.0;

/// Frame with its overlays.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let Some(player) = app.with(|lab| lab.player.clone()).flatten() else { return View::new() };
    let [width, height] = player.size();
    let mut frame = div();
    let node: Element = frame.node();
    let _ = node.append_child(&player.canvas);
    let loupe = Loupe::new(&player.canvas);
    let class = move || if app.films.tool.get() == Tool::Rest { "film-frame" } else { "film-frame aiming" };
    let frame = frame
        .class(class)
        .id("film-frame")
        .attr("data-frame", move || app.films.painted.get().map(|frame| frame.to_string()))
        .tabindex("0")
        .role("application")
        .attr("aria-label", words.film)
        .attr("aria-describedby", "film-keys")
        .when(events::keydown, move |event| key(app, &event, [width, height]))
        .when(events::pointerdown, move |event| down(app, &event, [width, height]))
        .when(events::pointermove, move |event| moved(app, &event, [width, height]))
        .when(events::pointerup, move |event| up(app, &event, [width, height]))
        .when(events::pointercancel, move |_| app.films.aim.set(None))
        .when(events::focusout, move |_| left(app))
        .child(overlay::lines(app, [width, height]))
        .child(overlay::marks(app, [width, height]))
        .child(handles(app, [width, height]))
        .child(loupe.view(app, [width, height]));
    View::from((
        prompt(app),
        div().class("film-place").child(frame),
        p().id("film-keys").hidden(true).child(words.picture_keys),
        overlay::readout(app),
    ))
}

/// Prompt for the next click.
fn prompt(app: App) -> View {
    let words = words::of(app);
    let asked = memo(move || {
        let points = app.films.points.with(Vec::len) + app.films.ruler.with(Vec::len) % 2;
        asked(app, words, app.films.tool.get(), app.films.kind.get(), points)
    });
    changing(move || {
        let asked = asked.get();
        if asked.is_empty() {
            return selection(app);
        }
        let leave = move |_| {
            app.films.points.set(Vec::new());
            app.films.tool.set(Tool::Rest);
            view::browser::focus("film-frame");
        };
        let leave = button().class("quiet").id("film-leave").when(events::click, leave).child(words.leave);
        div().class("film-prompt").child(p().id("film-asked").child(asked)).child(leave).into()
    })
}

/// Selected point with the button that removes it.
fn selection(app: App) -> View {
    let words = words::of(app);
    let frame = app.films.frame.get();
    let seen = |handle: &Handle| tools::held(app).iter().any(|held| held.handle == *handle && held.is_seen(frame));
    let Some(handle) = app.films.selected.get().filter(seen) else {
        return View::from(div().class("film-prompt none"));
    };
    let remove = move |_| {
        tools::remove(app, handle);
        view::browser::focus("film-frame");
    };
    let (_, name) = name(handle, words);
    let button = button()
        .class("quiet")
        .id("film-remove")
        .title(words.remove_key)
        .when(events::click, remove)
        .child(words.remove);
    div().class("film-prompt").child(p().child(name)).child(button).into()
}

/// Prompt of a tool after `points` clicks.
fn asked(app: App, words: &'static Words, tool: Tool, kind: Kind, points: usize) -> &'static str {
    match (tool, kind) {
        (Tool::Rest, _) => "",
        (Tool::Subject, Kind::Surface) => words.ask_surface,
        (Tool::Subject, Kind::Arms) if one_arm(app) => words.ask_second_surface,
        (Tool::Subject, Kind::Arms) => words.ask_surface,
        (Tool::Subject, Kind::Body) => words.ask_body,
        (Tool::Subject, Kind::Hand) => words.ask_hand,
        (Tool::Tube, _) if points == 0 => words.ask_tube,
        (Tool::Tube, _) => words.ask_other_end,
        (Tool::Still, _) => words.ask_still,
        (Tool::Ruler, _) if points == 0 => words.ask_ruler,
        (Tool::Ruler, _) => words.ask_second_mark,
        (Tool::Origin, _) => words.ask_origin,
        (Tool::Axis, _) => words.ask_axis,
        (Tool::Corners, _) => words.ask_corner,
    }
}

/// True if the surface of one of two arms has been clicked.
fn one_arm(app: App) -> bool {
    let now = app.films.now.get_clone();
    now.is_some_and(|now| matches!(&now.subject, Subject::Surfaces(surfaces) if surfaces.len() == 1))
}

/// Movable points of this frame and of all frames.
fn handles(app: App, size: Pixel) -> View {
    let words = words::of(app);
    // Points of one frame are recreated with it; points of all frames keep the focus.
    let of = move |one_frame: bool| {
        let seen = memo(move || {
            let frame = if one_frame { app.films.frame.get() } else { 0 };
            let is_seen = |held: &Held| held.frame.is_some() == one_frame && held.is_seen(frame);
            tools::held(app).into_iter().filter(is_seen).collect::<Vec<_>>()
        });
        changing(move || each(seen.get_clone(), |held| handle(app, held, size, words)))
    };
    View::from((of(true), of(false)))
}

fn handle(app: App, held: Held, size: Pixel, words: &'static Words) -> View {
    let Held { handle, at, .. } = held;
    let place = move || {
        let aim = app.films.aim.get().filter(|aim| aim.handle == Some(handle));
        let [x, y] = aim.map_or(at, |aim| aim.at);
        format!("left:{:.3}%;top:{:.3}%", 100.0 * x / size[0], 100.0 * y / size[1])
    };
    let (kind, name) = name(handle, words);
    let id = id(handle);
    button()
        .class(format!("film-handle {kind}"))
        .id(id)
        .style(place)
        .attr("aria-label", format!("{name}: x {:.1}, y {:.1} px", at[0], at[1]))
        .when(events::keydown, move |event| handle_key(app, &event, handle, at, size))
        .when(events::focus, move |_| app.films.selected.set(Some(handle)))
        .when(events::pointerdown, move |event: PointerEvent| {
            capture(&event);
            event.stop_propagation();
            app.films.selected.set(Some(handle));
            app.films.aim.set(Some(Aim { handle: Some(handle), at, by_keys: false }));
        })
        .into()
}

/// Class and name of a handle.
fn name(handle: Handle, words: &Words) -> (&'static str, String) {
    let numbered = |name: &str, number: usize| format!("{name} {}", number + 1);
    match handle {
        Handle::Surface(number) => ("subject", numbered(words.surface, number)),
        Handle::Tube(_, end) => ("tube", numbered(words.tube_end, end)),
        Handle::Body(number, _) => ("subject", numbered(words.body, number)),
        Handle::Hand(_) => ("subject", words.point.to_owned()),
        Handle::Still(number) => ("still", numbered(words.fixed_mark, number)),
        Handle::Ruler(number) => ("ruler", numbered(words.ruler_mark, number)),
        Handle::Origin => ("origin", words.origin.to_owned()),
        Handle::Axis => ("origin", words.axis.to_owned()),
        Handle::Corner(number) => ("ruler", numbered(words.corner, number)),
    }
}

fn id(handle: Handle) -> String {
    match handle {
        Handle::Surface(number) => format!("film-surface-{number}"),
        Handle::Tube(number, end) => format!("film-tube-{number}-{end}"),
        Handle::Body(number, key) => format!("film-body-{number}-{key}"),
        Handle::Hand(number) => format!("film-point-{number}"),
        Handle::Still(number) => format!("film-still-{number}"),
        Handle::Ruler(number) => format!("film-ruler-{number}"),
        Handle::Origin => "film-origin".to_owned(),
        Handle::Axis => "film-axis".to_owned(),
        Handle::Corner(number) => format!("film-corner-{number}"),
    }
}

fn capture(event: &PointerEvent) {
    if let Some(target) = event.target().and_then(|target| target.dyn_into::<Element>().ok()) {
        let _ = target.set_pointer_capture(event.pointer_id());
    }
}

/// Position of a pointer on the frame, px, limited to the frame.
fn place_of(event: &PointerEvent, size: Pixel) -> Option<Pixel> {
    let frame = view::browser::by_id::<Element>("film-frame")?.get_bounding_client_rect();
    let part = |at: i32, from: f64, length: f64| ((f64::from(at) - from) / length.max(1.0)).clamp(0.0, 1.0);
    Some([
        part(event.client_x(), frame.left(), frame.width()) * size[0],
        part(event.client_y(), frame.top(), frame.height()) * size[1],
    ])
}

/// True if two points are at most several CSS px apart.
fn is_near(one: Pixel, other: Pixel, size: Pixel) -> bool {
    let shown =
        view::browser::by_id::<Element>("film-frame").map_or(size[0], |frame| frame.get_bounding_client_rect().width());
    let far = |k: usize| (one[k] - other[k]).abs() * shown / size[0];
    far(0).max(far(1)) < STILL
}

fn down(app: App, event: &PointerEvent, size: Pixel) {
    if event.button() != 0 || app.films.tool.get_untracked() == Tool::Rest {
        return;
    }
    capture(event);
    app.films.aim.set(place_of(event, size).map(|at| Aim { handle: None, at, by_keys: false }));
}

fn moved(app: App, event: &PointerEvent, size: Pixel) {
    let Some(aim) = app.films.aim.get_untracked().filter(|aim| !aim.by_keys) else { return };
    if let Some(at) = place_of(event, size) {
        app.films.aim.set(Some(Aim { at, ..aim }));
    }
}

fn up(app: App, event: &PointerEvent, size: Pixel) {
    let Some(aim) = app.films.aim.get_untracked().filter(|aim| !aim.by_keys) else { return };
    let at = place_of(event, size).unwrap_or(aim.at);
    // A click without a drag does not move a point.
    let held = aim.handle.and_then(|handle| tools::held(app).into_iter().find(|held| held.handle == handle));
    if held.is_some_and(|held| is_near(held.at, at, size)) {
        return app.films.aim.set(None);
    }
    finish(app, Aim { at, ..aim });
}

/// Places or moves the point.
fn finish(app: App, aim: Aim) {
    app.films.aim.set(None);
    match aim.handle {
        Some(handle) => {
            tools::moved(app, handle, aim.at);
            if aim.by_keys {
                view::browser::focus_later(id(handle));
            }
        }
        None => tools::place(app, aim.at),
    }
}

/// Cancels the placement by keys when the focus leaves.
fn left(app: App) {
    if app.films.aim.get_untracked().is_some_and(|aim| aim.by_keys) {
        app.films.aim.set(None);
    }
}

/// Keys of the frame: step through the film, or place a point.
fn key(app: App, event: &KeyboardEvent, size: Pixel) {
    if event.default_prevented() {
        return;
    }
    if aim_key(app, event, size) {
        return event.prevent_default();
    }
    if event.key() == "Enter" && app.films.tool.get_untracked() != Tool::Rest {
        event.prevent_default();
        let at = app.films.last.get_untracked().unwrap_or([size[0] / 2.0, size[1] / 2.0]);
        app.films.aim.set(Some(Aim { handle: None, at, by_keys: true }));
        return app.say(said(at));
    }
    keys::key(app, event);
}

/// Keys of a handle: arrows start to move it.
fn handle_key(app: App, event: &KeyboardEvent, handle: Handle, at: Pixel, size: Pixel) {
    let aiming = app.films.aim.get_untracked().is_some_and(|aim| aim.by_keys);
    if !aiming && event.key().starts_with("Arrow") {
        app.films.aim.set(Some(Aim { handle: Some(handle), at, by_keys: true }));
    }
    if !aiming && matches!(event.key().as_str(), "Delete" | "Backspace") {
        event.prevent_default();
        view::browser::focus("film-frame");
        return tools::remove(app, handle);
    }
    if aim_key(app, event, size) || matches!(event.key().as_str(), "Enter" | " ") {
        event.prevent_default();
    }
}

/// Moves, sets or cancels a point that is placed by keys. Returns false without such a point, or for another key.
fn aim_key(app: App, event: &KeyboardEvent, [width, height]: Pixel) -> bool {
    let Some(aim) = app.films.aim.get_untracked().filter(|aim| aim.by_keys) else { return false };
    let far = if event.shift_key() { 10.0 } else { 1.0 };
    let (across, down) = match event.key().as_str() {
        "ArrowLeft" => (-far, 0.0),
        "ArrowRight" => (far, 0.0),
        "ArrowUp" => (0.0, -far),
        "ArrowDown" => (0.0, far),
        "Enter" => {
            app.films.last.set(Some(aim.at));
            finish(app, aim);
            return true;
        }
        "Escape" => {
            app.films.aim.set(None);
            return true;
        }
        _ => return false,
    };
    let at = [(aim.at[0] + across).clamp(0.0, width), (aim.at[1] + down).clamp(0.0, height)];
    app.films.aim.set(Some(Aim { at, ..aim }));
    app.say(said(at));
    true
}

fn said([x, y]: Pixel) -> String {
    format!("x {x:.0}, y {y:.0}")
}
