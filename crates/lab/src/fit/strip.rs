//! Strip under the plots while something is measured: record, theory, *Fit*, and the result.

use super::{lines, setup, starting, theories};
use crate::app::App;
use view::panel::tabs;
use view::views::*;

/// The strip; empty outside of the tab *Measure* and without records.
pub fn view(app: App) -> View {
    let shown = memo(move || {
        app.records.track();
        app.tab.get() == tabs::MEASURE && app.read_desk(|desk| !desk.records().list().is_empty())
    });
    changing(move || if shown.get() { bar(app).into() } else { View::new() })
}

fn bar(app: App) -> HtmlSection {
    let words = app.words();
    let named =
        |name: &'static str, choice: View| label().class("strip-choice").child(span().child(name)).child(choice);
    let controls = div()
        .class("strip-controls")
        .child(named(words.fit_step_record, setup::chooser(app)))
        .child(named(words.fit_step_theory, theories::choice(app).into()))
        .child(starting::button_of(app, false).class("primary").id("fit").child(words.fit_begin));
    section()
        .class("strip")
        .id("strip")
        .attr("aria-label", words.fit_title)
        .child(controls)
        .child(changing(move || if app.narrow.get() { View::new() } else { lines::view(app).into() }))
}
