//! Figures in the dashboard.

use crate::app::App;
use class::page::Look;
use view::page::theme;
use view::views::*;

/// Widest figure, in pixels.
const WIDEST: f64 = 700.0;

/// Size, colours and language of the figures in the dashboard.
pub fn look(app: App) -> Look {
    let width = window().inner_width().ok().and_then(|width| width.as_f64()).unwrap_or(WIDEST);
    let width = (width - 80.0).clamp(280.0, WIDEST);
    Look { width, height: 300.0, palette: theme::palette(), language: app.language.get_untracked() }
}

/// A figure from its SVG.
pub fn figure_of(svg: String) -> HtmlDiv {
    div().class("class-figure").inner_html(svg)
}
