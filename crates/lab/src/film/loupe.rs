//! Magnifier of the pixels around a point that is being placed, above the finger.

use super::access::codecs::Painter;
use super::aim::Pixel;
use crate::app::App;
use view::views::*;
use wasm_bindgen::JsCast;
use web_sys::HtmlCanvasElement;

/// Width in CSS px, as in the style sheet.
const SIDE: f64 = 132.0;
/// Width of the magnified part of the film, px.
const SEEN: f64 = 33.0;

/// Magnifier.
pub struct Loupe {
    film: HtmlCanvasElement,
}

impl Loupe {
    /// Magnifier of a film.
    pub fn new(film: &HtmlCanvasElement) -> Self {
        Self { film: film.clone() }
    }

    /// View of the magnifier, hidden while no point is placed.
    pub fn view(self, app: App, [width, height]: Pixel) -> View {
        let mut canvas = canvas().attr("width", "264").attr("height", "264").attr("aria-hidden", "true");
        let node: HtmlCanvasElement = canvas.node();
        effect(move || {
            app.films.painted.track();
            if let Some(aim) = app.films.aim.get() {
                paint(&node, &self.film, aim.at);
            }
        });
        let place = move || {
            let Some(aim) = app.films.aim.get() else { return "display:none".to_owned() };
            let [x, y] = [aim.at[0] / width, aim.at[1] / height];
            // Above the point, or below it near the upper edge.
            let aside = if y > 0.4 { "-100% - 28px" } else { "28px" };
            let across = (100.0 * x).clamp(12.0, 88.0);
            format!("left:{across:.2}%;top:{:.2}%;transform:translate(-50%,calc({aside}))", 100.0 * y)
        };
        let point = move || {
            let Some(aim) = app.films.aim.get() else { return "display:none".to_owned() };
            format!("left:{:.3}%;top:{:.3}%", 100.0 * aim.at[0] / width, 100.0 * aim.at[1] / height)
        };
        View::from((
            span().class("film-cross").style(point).attr("aria-hidden", "true"),
            canvas.class("film-loupe").id("film-loupe").style(place),
        ))
    }
}

fn paint(loupe: &HtmlCanvasElement, film: &HtmlCanvasElement, [x, y]: Pixel) -> Option<()> {
    let context = loupe.get_context("2d").ok()??;
    let painter: Painter = context.unchecked_into();
    let zoom = 2.0 * SIDE / SEEN;
    let [left, top] = [SIDE - zoom * x, SIDE - zoom * y];
    painter.set_image_smoothing_enabled(false);
    painter.set_transform(1.0, 0.0, 0.0, 1.0, 0.0, 0.0);
    painter.fill_rect(0.0, 0.0, 2.0 * SIDE, 2.0 * SIDE);
    let [width, height] = [film.width(), film.height()].map(f64::from);
    painter.draw_image(film, left, top, zoom * width, zoom * height).ok()
}
