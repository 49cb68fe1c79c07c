//! Tabs of the panel: those of the simulation, *Measure*, and with everything shown *Write* and *Class*.

mod needed;
mod source;

pub use needed::{follow, turn_on};

use crate::app::App;
use crate::{class, measuring::measurements, write};
use view::panel::Tab;
use view::panel::tabs::{CLASS, MEASURE, WRITE};
use view::views::*;

/// The panel.
pub fn view(app: App) -> HtmlSection {
    let words = app.words();
    let tabs = vec![
        Tab::explore(app.page),
        Tab::questions(app.page),
        Tab::new(MEASURE, words.tab_measure, move || measurements::view(app).into()),
        Tab::theory(app.page, move || source::view(app)),
        Tab::lasting(WRITE, words.tab_write, move || write::view(app)),
        Tab::lasting(CLASS, words.tab_class, move || class::door(app)),
    ];
    view::panel::view(app.page, view::panel::shown(app.page, tabs))
}
