//! The tabs of the panel: those of the simulation, and those of measuring and fitting.

mod source;

use crate::app::App;
use crate::tabs::{FIT, MEASURE};
use crate::{fit, measurements};
use view::panel::Tab;
use view::views::*;

/// The panel.
pub fn view(app: App) -> HtmlSection {
    let words = app.words();
    let tabs = [
        Some(Tab::play(app.page)),
        Tab::activities(app.page),
        Some(Tab::new(MEASURE, words.tab_measure, move || measurements::view(app).into())),
        Some(Tab::new(FIT, words.tab_fit, move || fit::view(app))),
        Some(Tab::theory(app.page, move || source::view(app))),
    ];
    view::panel::view(app.page, tabs.into_iter().flatten().collect())
}
