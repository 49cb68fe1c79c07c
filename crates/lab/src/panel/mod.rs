//! Tabs of the panel: those of the simulation, and those for measuring, fitting and writing.

mod source;

use crate::app::App;
use crate::{fit, measurements, write};
use view::panel::Tab;
use view::tabs::{FIT, MEASURE, WRITE};
use view::views::*;

/// The panel.
pub fn view(app: App) -> HtmlSection {
    let words = app.words();
    let tabs = vec![
        Tab::play(app.page),
        Tab::activities(app.page),
        Tab::new(MEASURE, words.tab_measure, move || measurements::view(app).into()),
        Tab::new(FIT, words.tab_fit, move || fit::view(app)),
        Tab::theory(app.page, move || source::view(app)),
        Tab::lasting(WRITE, words.tab_write, move || write::view(app)),
    ];
    view::panel::view(app.page, tabs)
}
