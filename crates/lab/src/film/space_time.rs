//! Space-time picture below the film: the strips of all frames side by side, with the track and the model. A drag
//! corrects the path.

use super::access::object;
use super::aim::Pixel;
use super::frames::{go, step};
use super::now::{anchors, model_path, now};
use super::refusals::refuse;
use super::{doubts, tracking, words};
use crate::app::App;
use desk::SpaceTimePicture;
use film::tracking::column::Click;
use std::rc::Rc;
use view::views::*;
use wasm_bindgen::{Clamped, JsCast};
use web_sys::{CanvasRenderingContext2d, Element, HtmlCanvasElement, ImageData, KeyboardEvent, PointerEvent};

/// Margin of the shown part of the tube on each side, relative to the range of the surface.
const AROUND: f64 = 0.25;
/// Minimum number of shown rows.
const LEAST: f64 = 40.0;
/// Vertical drag in CSS px below which it is a click.
const STILL: f64 = 4.0;

/// Space-time picture of a surface and its shown part.
struct Strip {
    picture: Rc<SpaceTimePicture>,
    /// Index of the surface.
    surface: usize,
    /// First shown row, and the number of shown rows.
    rows: [f64; 2],
    /// Shown rows, one px each.
    painted: HtmlCanvasElement,
}

/// Space-time pictures; empty before tracking.
pub fn view(app: App) -> View {
    changing(move || {
        let pictures = app.films.pictures.get_clone();
        wasm_bindgen_futures::spawn_local(async move {
            // Painted once the canvases have a size.
            view::browser::breathe().await;
            app.films.resized.update(|count| *count += 1);
        });
        each(pictures.into_iter().enumerate(), |(surface, picture)| match strip(app, surface, picture) {
            Some(strip) => canvas_of(app, Rc::new(strip)),
            None => View::new(),
        })
    })
}

fn strip(app: App, surface: usize, picture: Rc<SpaceTimePicture>) -> Option<Strip> {
    let now = now(app)?;
    let track = now.tracks.get(surface);
    let rows = track.into_iter().flat_map(|track| &track.points).map(|point| picture.row_of(point.position));
    let [low, high] = rows.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], row| [low.min(row), high.max(row)]);
    let all = picture.rows as f64;
    // The whole tube before there are results.
    let [low, high] = if low > high { [0.0, all] } else { [low, high] };
    let (middle, half) = ((low + high) / 2.0, ((0.5 + AROUND) * (high - low)).max(LEAST / 2.0));
    let first = (middle - half).clamp(0.0, all - 1.0).floor();
    let count = ((middle + half).clamp(first + 1.0, all) - first).ceil();
    let width = picture.frames.len();
    let part = picture.grey.get(first as usize * width..(first + count) as usize * width)?;
    // Frames not yet read are transparent.
    let seen = |at: usize| if at % width.max(1) < picture.read { 255 } else { 0 };
    let colours: Vec<u8> = part.iter().enumerate().flat_map(|(at, &grey)| [grey, grey, grey, seen(at)]).collect();
    let data = ImageData::new_with_u8_clamped_array_and_sh(Clamped(&colours), width as u32, count as u32).ok()?;
    let painted: HtmlCanvasElement = document().create_element("canvas").ok()?.dyn_into().ok()?;
    painted.set_width(width as u32);
    painted.set_height(count as u32);
    context(&painted)?.put_image_data(&data, 0.0, 0.0).ok()?;
    Some(Strip { picture, surface, rows: [first, count], painted })
}

fn context(canvas: &HtmlCanvasElement) -> Option<CanvasRenderingContext2d> {
    canvas.get_context_with_context_options("2d", &object(&[])).ok()??.dyn_into().ok()
}

impl Strip {
    /// Frame and position (px) of a point of the canvas, given as fractions of its width and height.
    fn click(&self, [across, down]: Pixel) -> Option<Click> {
        let column = (across * self.picture.frames.len() as f64).floor().max(0.0) as usize;
        let frame = *self.picture.frames.get(column.min(self.picture.frames.len().saturating_sub(1)))?;
        let row = self.rows[0] + down.clamp(0.0, 1.0) * self.rows[1] - 0.5;
        Some(Click { frame, position: self.picture.position(row) })
    }

    /// Point of the canvas for a position (px) in a frame, as fractions of width and height.
    fn place(&self, frame: usize, at: Pixel) -> Pixel {
        let column = self.picture.frames.partition_point(|other| *other < frame);
        let across = (column as f64 + 0.5) / self.picture.frames.len().max(1) as f64;
        [across, (self.picture.row_of(at) + 0.5 - self.rows[0]) / self.rows[1]]
    }

    fn paint(&self, app: App, canvas: &HtmlCanvasElement) -> Option<()> {
        let [width, height] = [f64::from(canvas.client_width()), f64::from(canvas.client_height())];
        let dense = window().device_pixel_ratio();
        canvas.set_width((width * dense) as u32);
        canvas.set_height((height * dense) as u32);
        let context = context(canvas)?;
        context.scale(dense, dense).ok()?;
        let painted = &self.painted;
        context.draw_image_with_html_canvas_element_and_dw_and_dh(painted, 0.0, 0.0, width, height).ok()?;
        let now = now(app)?;
        let Some(track) = now.tracks.get(self.surface) else { return Some(()) };
        let scale = |[across, down]: Pixel| [across * width, down * height];
        let found = track.points.iter().map(|point| scale(self.place(point.frame, point.position)));
        // Band of one standard error, visible only if it is large.
        let sigma = |error: Pixel| (error[0] * error[0] + error[1] * error[1]).sqrt() / self.rows[1] * height;
        let errors = track.points.iter().map(|point| sigma(point.sigma));
        let found: Vec<Pixel> = found.collect();
        context.set_fill_style_str("rgb(255 196 0 / 45%)");
        context.begin_path();
        let errors: Vec<f64> = errors.collect();
        for (at, error) in found.iter().zip(&errors) {
            context.line_to(at[0], at[1] - error);
        }
        for (at, error) in found.iter().zip(&errors).rev() {
            context.line_to(at[0], at[1] + error);
        }
        context.fill();
        let line = |points: &[Pixel], halo: &str, colour: &str| {
            context.begin_path();
            points.iter().for_each(|at| context.line_to(at[0], at[1]));
            for (width, colour) in [(3.0, halo), (1.3, colour)] {
                context.set_line_width(width);
                context.set_stroke_style_str(colour);
                context.stroke();
            }
        };
        line(&found, "rgb(0 0 0 / 45%)", "#ffd23f");
        let models = model_path(app, self.surface, &self.picture.frames);
        let model: Vec<Pixel> = models.iter().map(|(frame, at)| scale(self.place(*frame, *at))).collect();
        line(&model, "rgb(255 255 255 / 60%)", "#c2185b");
        let truth = app.films.truth.with_untracked(|all| all.get(self.surface).map(|one| one.path.clone()));
        let truth: Vec<Pixel> = truth.iter().flatten().map(|(frame, at)| scale(self.place(*frame, *at))).collect();
        line(&truth, "rgb(255 255 255 / 60%)", "#00897b");
        context.set_fill_style_str("#ff5252");
        let doubtful = now.doubts.iter().filter(|doubt| doubt.track == self.surface);
        for doubt in doubtful {
            let [x, _] = scale(self.place(doubt.frame, self.picture.origin));
            context.fill_rect(x - 1.0, height - 5.0, 2.0, 5.0);
        }
        context.set_fill_style_str("#40c4ff");
        for anchor in anchors(&now, self.surface) {
            let [x, y] = scale(self.place(anchor.frame, anchor.position));
            context.begin_path();
            context.arc(x, y, 4.0, 0.0, std::f64::consts::TAU).ok()?;
            context.fill();
        }
        let [x, _] = scale(self.place(app.films.frame.get_untracked(), self.picture.origin));
        context.set_fill_style_str("rgb(0 150 255 / 70%)");
        context.fill_rect(x - 0.75, 0.0, 1.5, height);
        if let Some((surface, click)) = app.films.anchor.get_untracked().filter(|(surface, _)| *surface == self.surface)
        {
            let _ = surface;
            let [x, y] = scale(self.place(click.frame, click.position));
            context.set_stroke_style_str("#40c4ff");
            context.set_line_width(2.0);
            context.begin_path();
            context.move_to(x - 9.0, y);
            context.line_to(x + 9.0, y);
            context.stroke();
        }
        Some(())
    }
}

fn canvas_of(app: App, strip: Rc<Strip>) -> View {
    let words = words::of(app);
    let mut canvas = canvas();
    let node: HtmlCanvasElement = canvas.node();
    let (painted, place) = (strip.clone(), node.clone());
    effect(move || {
        app.films.frame.track();
        app.films.anchor.track();
        app.films.now.track();
        app.films.resized.track();
        app.films.truth.track();
        app.fits.track();
        app.changes.parameters.track();
        painted.paint(app, &place);
    });
    let number = strip.surface;
    let (pressed, dragged, keyed, ended) = (strip.clone(), strip.clone(), strip.clone(), node.clone());
    let from = create_signal(None::<f64>);
    let down = move |event: PointerEvent| {
        let Some(target) = event.target().and_then(|target| target.dyn_into::<Element>().ok()) else { return };
        let _ = target.set_pointer_capture(event.pointer_id());
        from.set(Some(f64::from(event.client_y())));
        if let Some(click) = pressed.click(place_of(&event, &target)) {
            go(app, click.frame);
        }
    };
    let moved = move |event: PointerEvent| {
        let Some(start) = from.get_untracked() else { return };
        let Some(click) = dragged.click(place_of(&event, &node)) else { return };
        let still = app.films.anchor.get_untracked().is_none();
        if still && (f64::from(event.client_y()) - start).abs() < STILL {
            return go(app, click.frame);
        }
        // The drag moves the surface within the selected frame.
        let frame = app.films.frame.get_untracked();
        app.films.anchor.set(Some((number, Click { frame, ..click })));
    };
    let up = move |_: PointerEvent| {
        from.set(None);
        set(app);
    };
    canvas
        .class("space-time")
        .id(format!("space-time-{number}"))
        .tabindex("0")
        .role("application")
        .attr("aria-label", format!("{} {}", words.space_time, number + 1))
        .attr("aria-describedby", "space-time-keys")
        .title(words.space_time_hint)
        .when(events::pointerdown, down)
        .when(events::pointermove, moved)
        .when(events::pointerup, up)
        .when(events::pointercancel, move |_| {
            from.set(None);
            app.films.anchor.set(None);
        })
        .when(events::keydown, move |event| key(app, &event, &keyed, &ended))
        .when(events::blur, move |_| app.films.anchor.set(None))
        .into()
}

fn place_of(event: &PointerEvent, node: &Element) -> Pixel {
    let place = node.get_bounding_client_rect();
    let part = |at: i32, from: f64, length: f64| (f64::from(at) - from) / length.max(1.0);
    [part(event.client_x(), place.left(), place.width()), part(event.client_y(), place.top(), place.height())]
}

/// Applies the correction in progress.
fn set(app: App) {
    let Some((surface, click)) = app.films.anchor.take() else { return };
    refuse(
        app,
        app.attempt_on_desk(|desk| desk.change_films(|films, play| films.anchor_surface(play, surface, click))),
    );
    tracking::go_on(app);
}

/// Keys: left and right step through the film; up and down move the surface in this frame, Enter applies the
/// correction, Delete removes it.
fn key(app: App, event: &KeyboardEvent, strip: &Strip, _canvas: &HtmlCanvasElement) {
    if event.ctrl_key() || event.alt_key() || event.meta_key() {
        return;
    }
    let far: isize = if event.shift_key() { 10 } else { 1 };
    let frame = app.films.frame.get_untracked();
    match event.key().as_str() {
        "ArrowLeft" => step(app, -far),
        "ArrowRight" => step(app, far),
        "." => doubts::next(app),
        "ArrowUp" => shift(app, strip, frame, -(far as f64)),
        "ArrowDown" => shift(app, strip, frame, far as f64),
        "Enter" => set(app),
        "Escape" => app.films.anchor.set(None),
        "Delete" | "Backspace" => {
            refuse(
                app,
                app.attempt_on_desk(|desk| {
                    desk.change_films(|films, play| films.release_surface(play, strip.surface, frame))
                }),
            );
            tracking::go_on(app);
        }
        _ => return,
    }
    event.prevent_default();
}

fn shift(app: App, strip: &Strip, frame: usize, rows: f64) {
    let begun =
        app.films.anchor.get_untracked().filter(|(surface, click)| *surface == strip.surface && click.frame == frame);
    let from = begun.map(|(_, click)| click.position).or_else(|| {
        let now = now(app)?;
        let points = &now.tracks.get(strip.surface)?.points;
        let at = points.binary_search_by_key(&frame, |point| point.frame).ok()?;
        points.get(at).map(|point| point.position)
    });
    let Some(from) = from else { return };
    let row = (strip.picture.row_of(from) + rows).clamp(0.0, strip.picture.rows as f64 - 1.0);
    app.films.anchor.set(Some((strip.surface, Click { frame, position: strip.picture.position(row) })));
    app.say(format!("{row:.0}"));
}
