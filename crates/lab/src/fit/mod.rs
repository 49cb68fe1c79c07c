//! Fits in the page: started by a button, computed in slices between frames. The strip under the plots has what a fit needs and
//! its result in three lines; the tab *Measure* has the rest, folded.

mod leaving_out;
mod lines;
mod report;
mod results;
mod setup;
mod signals;
mod starting;
mod strip;
mod suitability;
mod theories;
mod travel;
mod work;

pub use results::RESULTS;
pub use signals::Fitting;
pub use starting::start;
pub use strip::view as strip;
pub use suitability::follow;
pub use work::go_on;

use crate::app::App;
use view::page::everything;
use view::views::*;
use web_sys::HtmlDetailsElement;

/// Places of the folded steps in [`Fitting::unfolded`].
const RECORD: usize = 0;
const THEORY: usize = 1;
const NUMBERS: usize = 2;

/// Unfolds the results of the fits.
pub fn unfold_results(app: App) {
    app.fit.unfolded[NUMBERS].set(true);
}

/// What the tab *Measure* has about fits; empty without records.
pub fn view(app: App) -> View {
    let has_records = memo(move || {
        app.records.track();
        app.read_desk(|desk| !desk.records().list().is_empty())
    });
    // While the tab is open, the plots show the selected part of the time axis.
    effect(move || {
        app.tab.track();
        app.page.wake();
    });
    changing(move || if has_records.get() { steps(app) } else { View::new() })
}

fn steps(app: App) -> View {
    let words = app.words();
    let refusal = app.fit.refusal;
    let rank = starting::button_of(app, true).class("quiet").id("rank").title(words.fit_rank_title);
    let another = section()
        .class("fitting card step")
        .attr("aria-labelledby", "another-theory")
        .child(h3().id("another-theory").child(words.fit_another))
        .child(note(words.fit_another_note))
        .child(div().class("intake").child(rank.child(words.fit_rank)));
    let record = fold(app, RECORD, "record-step", words.fit_step_record)
        .child(setup::record(app, refusal))
        .child(leaving_out::view(app));
    let theory = fold(app, THEORY, "theory-step", words.fit_step_theory)
        .child(theories::view(app))
        .child(setup::varied(app, refusal));
    let numbers = fold(app, NUMBERS, "fit-step", words.fit_step_fit)
        .child(results::view(app))
        .child(everything::only(app.page, Box::new(move || setup::options(app).into())));
    // Where the strip is the lower bar of the window, it has no room for the result.
    let result = changing(move || if app.narrow.get() { lines::view(app).into() } else { View::new() });
    div().class("fitting-steps").child(result).child(another).child(record).child(theory).child(numbers).into()
}

/// A card that is unfolded by its title; it stays so when the tab is built again.
fn fold(app: App, place: usize, id: &'static str, title: &'static str) -> HtmlDetails {
    let mut card = details();
    let node: HtmlDetailsElement = card.node();
    let open = app.fit.unfolded[place];
    card.class("fitting card fold")
        .id(id)
        .prop("open", move || open.get())
        .when(events::toggle, move |_| open.set(node.open()))
        .child(summary().child(h3().child(title)))
}
